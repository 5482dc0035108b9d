// SPDX-License-Identifier: GPL-3.0-or-later
// How tight refits of deformed characters are: the radius of a level's balls over that of the smallest balls of its deformed vertices,
// on the level where this is worst. The default variants and the tightest ones, for characters whose joints scale, and for
// those with morph targets.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/deformed.hpp"
#include "algorithms/model/procedural/procedural.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_deformed_tightness {
namespace {

using namespace refitlab;

// What a joint is scaled by: all of them by one factor, each by its own, or each along axes.
enum class Scales { none, uniform, axes };

Point3 factors(Scales scales, std::size_t joint) {
  const double a = 0.9 + 0.35 * std::sin(double(joint)), b = 0.95 + 0.25 * std::cos(1.7 * double(joint));
  switch (scales) {
    case Scales::uniform: return {a, a, a};
    case Scales::axes: return {a, b, 1.0};
    default: return {1, 1, 1};
  }
}

// A pose whose joints scale about their own origins before they turn.
AffinePose scaled(const Character& c, const Pose& pose, Scales scales) {
  AffinePose out;
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const Point3 factor = factors(scales, j), &origin = c.mesh.joints[j].origin;
    AffineMap<double> map;
    for (int i = 0; i < 3; ++i)
      map.columns[static_cast<std::size_t>(i)] = rotate<double>(pose[j].rotation, Point3::Unit(i)) * factor[i];
    map.offset = apply(pose[j], origin) - turned_by(map, origin);
    out.push_back(map);
  }
  return out;
}

// Three targets: a belly that swells, a mesh that leans, and bumps all over.
void add_targets(SkinnedMesh& mesh) {
  auto box = Box<double>::empty();
  for (const Point3& v : mesh.vertices) box.merge(v);
  const double size = box.edges().maxCoeff();
  const Point3 middle = box.center();
  mesh.targets = {3, std::vector<std::vector<Displacement<double>>>(mesh.vertices.size())};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point3 x = (mesh.vertices[v] - middle) / size;
    auto& by = mesh.targets.of_vertex[v];
    if (x.norm() < 0.15) by.push_back({0, Point3(x * (0.5 * size))});
    by.push_back({1, Point3(x[1] * x[1] * 0.3 * size, 0, 0)});
    by.push_back({2, Point3(std::sin(60 * x[1]), 0, std::cos(50 * x[0])) * (0.01 * size)});
  }
}

struct Worst {
  double ratio = 0;
  int level = 0;
};

// Over the poses, on the worst level.
Worst worst_level(const AnimatedCharacter& c, const RefitVariant& variant, Scales scales, bool morphs) {
  std::vector<double> radii(static_cast<std::size_t>(c.tree.level_count())), optimal(radii.size());
  FrameRefits frame(c, variant);
  DeformedReference reference(c, variant.pieces);
  int number = 0;
  for (const Clip& clip : c.clips)
    for (const double share : {0.2, 0.7}) {
      const AffinePose pose = scaled(c, clip.sample(share * clip.duration), scales);
      const std::vector<double> weights =
          morphs ? std::vector<double>{0.8, std::sin(double(++number)), 0.5} : std::vector<double>();
      const bool is_linear = variant.skinning == Skinning::linear;
      const auto [rigid, own] = split(c.mesh, pose);
      const Deformation deformation{weights, is_linear ? AffinePose() : own};
      const auto palette = is_linear ? make_skinning_palette(c.mesh, c.sets, pose)
                                     : make_skinning_palette(c.mesh, c.sets, rigid, variant.skinning);
      reference.begin(deformation);
      frame.begin(palette, &reference);
      const auto skinned = skin(c.mesh, c.sets, palette, variant.skinning, deformation);
      const auto smallest = optimal_balls(c.tree, c.vertices, skinned);
      for (std::size_t n = 0; n < smallest.size(); ++n) {
        const auto level = static_cast<std::size_t>(c.tree.nodes[n].level - 1);
        radii[level] += frame[static_cast<int>(n)].radius, optimal[level] += smallest[n].radius;
      }
    }
  Worst worst;
  for (std::size_t l = 0; l < radii.size(); ++l)
    if (radii[l] / optimal[l] > worst.ratio) worst = {radii[l] / optimal[l], static_cast<int>(l) + 1};
  return worst;
}

struct Kind {
  const char* name;
  Scales scales;
  bool morphs;
};

constexpr Kind uniform{"scaled", Scales::uniform, false}, axes{"scaled along axes", Scales::axes, false},
    morphs{"morphed", Scales::none, true}, both{"both", Scales::axes, true};

Checked check(const AnimatedCharacter& c, std::initializer_list<const char*> variants, std::initializer_list<Kind> kinds,
              double most) {
  std::string text;
  bool passed = true;
  long count = 0;
  for (const char* name : variants) {
    text += std::string(name) + ":";
    for (const Kind& kind : kinds) {
      const Worst worst = worst_level(c, refit_variant(name), kind.scales, kind.morphs);
      char part[100];
      std::snprintf(part, sizeof part, " %s %.4f (level %d),", kind.name, worst.ratio, worst.level);
      text += part;
      passed = passed && worst.ratio <= most;
      ++count;
    }
    text.back() = ';';
    text += ' ';
  }
  return Checked(passed, count, text);
}

AnimatedCharacter morphed(Model model) {
  std::vector<Clip> clips = std::move(model.clips);
  SkinnedMesh mesh(std::move(model));
  add_targets(mesh);
  return {bake(std::move(mesh)), std::move(clips)};
}

}  // namespace

PROPTEST(deformed_tightness) {
  const auto defaults = {"linear_mixed", "control_mixed", "dual_quaternion_mixed"};
  const auto plain = bake(make_man()), man = morphed(make_man());
  const Options options{.number_type = "double"};
  t.example("the default variants' balls of the man, whose joints scale, are on no level by more than 12 % too large", options,
            [&] { return check(plain, defaults, {uniform}, 1.12); });
  t.example("those of joints that scale along axes are on no level by more than 15 % too large", options,
            [&] { return check(plain, defaults, {axes}, 1.15); });
  t.example("those of the man with morph targets, scaled too, are on no level by more than 12 % too large", options, [&] {
    return check(man, defaults, {uniform, axes, morphs, both}, 1.12);
  });
  t.example("the tightest variant's balls of the man, scaled and morphed, are on no level by more than 5.5 % too large", options,
            [&] {
              return check(man, {"control_many_pieces"}, {uniform, axes, morphs, both}, 1.055);
            });
}

}  // namespace proptests::suite_deformed_tightness
