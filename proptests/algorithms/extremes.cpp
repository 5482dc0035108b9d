// SPDX-License-Identifier: GPL-3.0-or-later
// Tests models at the limits of what a model may be, through everything that looks at one: the results are right, or it is
// refused with a clear error.
#include <cmath>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "algorithms/runtime/collide/collide.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/extreme_models.hpp"
#include "proptests/gen/rigged_gltf.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests::suite_extremes {
namespace {

using namespace refitlab;
using gen::ExtremeModel;
using gen::RiggedGltf;
using oracle::sorted;

// Holds a character in a pose, by one skinning, and how large its numbers are.
struct Posed {
  Posed(const Character& c, const Pose& pose, Skinning skinning)
      : palette(make_skinning_palette(c.mesh, c.sets, pose, skinning)),
        deformed(skin(c.mesh, c.sets, palette, skinning)),
        exact(c.mesh, c.sets, palette, skinning) {
    for (const Point3& p : deformed) size = std::max(size, p.norm());
    for (const Point3& p : c.mesh.vertices) size = std::max(size, p.norm());
    for (const auto& t : pose) size = std::max(size, t.translation.norm());
  }
  SkinningPalette<double> palette;
  std::vector<Point3> deformed;
  ExactSkin exact;
  double size = 0;
};

// Decides exactly, after a quick test, since most vertices are far from the surface.
bool encloses_exactly(const Ball3<double>& ball, const Point3& v) {
  if (!std::isfinite(ball.radius)) return ball.radius == INFINITY;
  if (norm<double, 3>(v - ball.center) * (1 + 1e-14) + 1e-150 < ball.radius) return true;
  return encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, convert<Rational>(v)) == Verdict::holds;
}

// Returns what is wrong with the balls of all nodes, or nothing. An infinite radius is right, but no other number that is not
// finite. Vertices are skinned exactly, and as skin() does.
template <class Balls>
std::string complaint(const Character& c, Posed& posed, const Balls& ball_of) {
  for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
    const auto found = ball_of(n);
    const Ball3<double> ball{found.center.template cast<double>(), found.radius};
    if (!ball.center.allFinite() || !(ball.radius >= 0)) return "node " + std::to_string(n) + " has no ball; ";
    for (const int v : c.vertices[n])
      if (!posed.exact.is_in(ball, v) || !encloses_exactly(ball, posed.deformed[v]))
        return "node " + std::to_string(n) + " misses vertex " + std::to_string(v) + " with radius " +
               std::to_string(ball.radius / posed.size) + " of its size; ";
  }
  return "";
}

std::string refit_complaints(const Character& c, const Pose& pose) {
  std::string out;
  for (const Skinning skinning : gen::all_skinnings) {
    Posed posed(c, pose, skinning);
    const Skinning bounded = skinning == Skinning::hejl ? Skinning::spherical : skinning;
    for (const RefitVariant& variant : compared_variants()) {
      if (variant.skinning != bounded || !variant.sound) continue;
      const auto balls = refit_all(c, variant, posed.palette);
      const std::string wrong = complaint(c, posed, [&](int n) { return balls[n]; });
      if (!wrong.empty()) out += variant.name + ": " + wrong;
    }
  }
  return out;
}

// Returns what is wrong, or nothing. It is also nothing for lengths that are refused for being too large.
template <class Work>
std::string complaint_or_refusal(const Character& c, const Pose& pose, const Work& work) {
  try {
    return work();
  } catch (const std::range_error& e) {
    const Posed posed(c, pose, Skinning::linear);
    const bool is_clear = std::string(e.what()).starts_with("refit in single precision: a length of ");
    return posed.size > 1e17 && is_clear ? "" : std::string("refused: ") + e.what();
  }
}

std::string batch_complaints(const Character& c, const Pose& pose) {
  BatchRefit batch(c.tree, c.sets);
  Posed linear(c, pose, Skinning::linear), spherical(c, pose, Skinning::spherical);
  std::string out;
  for (const Target target : available_targets()) {
    const PackedBalls& balls = batch.linear(linear.palette, target);
    out += complaint(c, linear, [&](int n) { return balls[n]; });
    const PackedBalls& again = batch.spherical(spherical.palette, target);
    out += complaint(c, spherical, [&](int n) { return again[n]; });
  }
  return out;
}

// Checks queries in which the second body stands a little beside the first, and so in contact.
std::string collision_complaints(const Character& c, const Pose& pose) {
  std::string out;
  for (const Skinning skinning : gen::all_skinnings) {
    const Posed posed(c, pose, skinning);
    const RigidTransform<double> beside{{0.6, 0.8, 0, 0}, {0.01 * posed.size, 0, 0}};
    const auto expected = oracle::all_pairs({c, pose, {}}, {c, pose, beside}, skinning);
    QueryCounts counts;
    if (skinning != Skinning::hejl) {
      const RefitVariant& variant = default_variant(skinning);
      Body body(c, variant);
      body.begin(pose);
      if (sorted(collide({body}, {body, beside}, Query::full, counts)) != expected) out += variant.name + ": other pairs; ";
    }
    const ClusterTree tree(c, {.most_triangles = 8, .most_children = 4});
    ClusterBody first(tree, skinning), second(tree, skinning);
    first.begin(pose, {}), second.begin(pose, beside);
    if (sorted(collide(first, second, Query::full, counts)) != expected) out += "clusters: other pairs; ";
  }
  return out;
}

Checked all_right(const SkinnedMesh& model, const Pose& pose) {
  const auto c = bake(model);
  const std::string wrong = refit_complaints(c, pose) + complaint_or_refusal(c, pose, [&] { return batch_complaints(c, pose); }) +
                            collision_complaints(c, pose);
  return {wrong.empty(), static_cast<long>(c.tree.nodes.size()), wrong};
}

// --- From files ---

struct ExtremeFile {
  const char* what;
  std::function<void(RiggedGltf&)> change;  // The change is one of bending_tube(3).
  // These are words of the refusal, and there are none if the file is to load.
  std::vector<std::string> words;
};

void scale_lengths(RiggedGltf& s, float factor) {
  for (auto& p : s.meshes[0].positions)
    for (float& x : p) x *= factor;
  for (auto& node : s.nodes)
    for (float& x : node.translation) x *= factor;
  for (auto& bind : s.skins[0].inverse_bind)
    for (int i = 12; i < 15; ++i) bind[i] *= factor;
  for (float& x : s.clips[0].tracks.back().values) x *= factor;
}

// Spreads the weights over four joints of each set.
void spread_weights(RiggedGltf& s, int sets) {
  s = gen::bending_tube(4 * sets);
  auto& mesh = s.meshes[0];
  mesh.joints.assign(sets, {}), mesh.weights.assign(sets, {});
  const float weight = 0.25f / static_cast<float>(sets);
  for (int set = 0; set < sets; ++set) {
    std::array<std::uint16_t, 4> joints;
    for (int i = 0; i < 4; ++i) joints[i] = static_cast<std::uint16_t>(4 * set + i);
    mesh.joints[set].assign(mesh.positions.size(), joints);
    mesh.weights[set].assign(mesh.positions.size(), {weight, weight, weight, weight});
  }
}

std::vector<ExtremeFile> extreme_files() {
  return {
      {"coordinates of 1e30", [](auto& s) { scale_lengths(s, 1e30f); }, {}},
      {"coordinates of 1e-30", [](auto& s) { scale_lengths(s, 1e-30f); }, {}},
      {"1000 joints", [](auto& s) { s = gen::bending_tube(1000); }, {}},
      {"40 influences of each vertex", [](auto& s) { spread_weights(s, 10); }, {}},
      {"64 influences of each vertex", [](auto& s) { spread_weights(s, 16); }, {}},
      {"all weights on one joint",
       [](auto& s) {
         s.meshes[0].joints[0].assign(s.meshes[0].positions.size(), {1, 0, 0, 0});
         s.meshes[0].weights[0].assign(s.meshes[0].positions.size(), {1, 0, 0, 0});
       },
       {}},
      {"all vertices in one point",
       [](auto& s) {
         s.meshes[0].positions.assign(s.meshes[0].positions.size(), {1, 2, 3});
       },
       {"no triangles"}},
      {"triangles without area",
       [](auto& s) {
         for (auto& p : s.meshes[0].positions) p = {0, p[1] + 0.1f * p[0] + 0.01f * p[2], 0};
       },
       {}},
      {"a NaN in a single frame",
       [](auto& s) {
         auto& track = s.clips[0].tracks[0];
         track.times = {0, 0.25f, 0.5f, 1};
         track.values = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, NAN, 1, 0, 0, 0, 1};
       },
       {"clip 'bend'", "joint 'j0'", "0.500000 s", "not finite"}},
      {"an infinite coordinate", [](auto& s) { s.meshes[0].positions[3][1] = INFINITY; }, {"vertex 3", "not finite"}},
      {"an infinite joint", [](auto& s) { s.skins[0].inverse_bind[1][12] = INFINITY; }, {"'j1'", "not finite"}},
      {"coordinates that are too large only when they are scaled",
       [](auto& s) {
         scale_lengths(s, 1e30f);
         s.nodes[0].scale = {1e20f, 1e20f, 1e20f};
       },
       {"out of range"}},
      {"no mesh", [](auto& s) { s.meshes.clear(), s.nodes.back().mesh = s.nodes.back().skin = -1; }, {"no mesh"}},
      {"no triangle", [](auto& s) { s.meshes[0].indices.assign(3, 0); }, {"no triangles"}},
  };
}

Checked check_file(const ExtremeFile& file) {
  const TemporaryFolder folder;
  RiggedGltf scene = gen::bending_tube(3);
  file.change(scene);
  write_glb(scene, folder.file("rig.glb"));
  try {
    const Model model = load_model(folder.file("rig.glb"));
    if (!file.words.empty()) return {false, 1, "it loads"};
    const auto c = bake(model);
    const Pose pose = model.clips[0].sample(0.7);
    const std::string wrong = refit_complaints(c, pose);
    return {wrong.empty(), static_cast<long>(c.tree.nodes.size()), wrong};
  } catch (const ModelError& e) {
    const std::string message = e.what();
    bool good = !file.words.empty() && message.starts_with(folder.file("rig.glb") + ": ");
    for (const auto& word : file.words) good = good && message.find(word) != std::string::npos;
    return {good, 1, message};
  }
}

}  // namespace

PROPTEST(extremes) {
  for (const ExtremeModel& extreme : gen::extreme_models())
    t.example(extreme.what + ": no ball misses a vertex, and queries find all pairs", {.number_type = "double"},
              [&] { return all_right(extreme.mesh, extreme.pose); });
  t.holds(
      "of what the interface accepts at its ends no sound variant's ball misses a vertex, be it skinned exactly: tiny, huge, "
      "both at once, of many joints, of quaternions off unit length",
      {.number_type = "double", .cases = 250, .degenerate_at_least = 0.3}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const gen::WideModel wide = gen::wide_model(random, random() % 8 ? 5 : 90);
        RC_CLASSIFY(wide.largest_length > 1e30 || wide.least_coordinate < 1e-70, "degenerate");
        RC_CLASSIFY(wide.largest_length < 1e-70, "all of it tiny");
        RC_CLASSIFY(wide.least_coordinate < 1e-150, "below the slack for underflow");
        const auto c = bake(wide.mesh, {.triangles_per_leaf = wide.triangles_per_leaf});
        if (const auto wrong = refit_complaints(c, wide.pose); !wrong.empty()) RC_FAIL(wrong + wide.what);
      });
  for (const ExtremeFile& file : extreme_files())
    t.example("a file: " + std::string(file.what) + (file.words.empty() ? " load" : ": refused"), {},
              [&] { return check_file(file); });
}

}  // namespace proptests::suite_extremes
