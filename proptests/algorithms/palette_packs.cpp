// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/batch/palette_packs.hpp"

#include <random>

#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_palette_packs {
namespace {

using namespace refitlab;

template <int D>
bool equal_lists(std::span<const Vec<double, D>> a, std::span<const Vec<double, D>> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// Says whether all numbers of rigid joints are equal, but for the sign of a zero. There are none of affine joints.
bool are_equal(const SkinningPalette<double>& a, const SkinningPalette<double>& b) {
  if (a.size() != b.size() || a.is_affine() || b.is_affine()) return false;
  for (std::size_t s = 0; s < a.size(); ++s) {
    const PaletteEntry<double> p = a[s], q = b[s];
    if (p.rotation_center != q.rotation_center || p.transforms.size() != q.transforms.size()) return false;
    for (std::size_t i = 0; i < p.transforms.size(); ++i)
      if (p.transforms[i].rotation != q.transforms[i].rotation || p.transforms[i].translation != q.transforms[i].translation)
        return false;
    if (!equal_lists(p.center_images, q.center_images) || !equal_lists(p.duals, q.duals)) return false;
    if (!p.maps.empty() || !p.stretches.empty() || !q.maps.empty() || !q.stretches.empty()) return false;
  }
  return true;
}

// Returns a palette that holds nothing yet, joints of another mesh, or affine ones of this mesh, all of which are measured.
SkinningPalette<double> used_palette(const SkinnedMesh& mesh, const JointSets& sets, std::mt19937& random) {
  switch (random() % 3) {
    case 0: return {};
    case 1: {
      const SkinnedMesh other = gen::make_mesh({gen::MeshKind::tube, 5, 5, 4, static_cast<unsigned>(random())});
      return make_skinning_palette(other, JointSets(other), gen::random_pose(other, random, 1), Skinning::spherical);
    }
    default: return make_skinning_palette(mesh, sets, gen::random_affine_pose(mesh, gen::JointKind::shear, random));
  }
}

bool same(const PaletteRounding<double>& a, const PaletteRounding<double>& b) {
  return a.vertex.per_length == b.vertex.per_length && a.vertex.per_radius == b.vertex.per_radius &&
         a.vertex.offset == b.vertex.offset && a.weight_vertices.per_length == b.weight_vertices.per_length &&
         a.weight_vertices.per_radius == b.weight_vertices.per_radius && a.weight_vertices.offset == b.weight_vertices.offset;
}

// Says whether the palette is still to be measured, and then has the roundings of one that make_skinning_palette fills.
bool is_measured_anew(SkinningPalette<double>& palette, const SkinningPalette<double>& expected) {
  if (palette.is_measured()) return false;
  palette.measure();
  for (std::size_t s = 0; s < palette.size(); ++s)
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion})
      if (!same(palette.rounding(s, skinning), expected.rounding(s, skinning))) return false;
  return palette.is_measured();
}

}  // namespace

PROPTEST(palette_packs) {
  t.holds(
      "the numbers are those of make_skinning_palette, in every skinning and for every target, one pose after the "
      "other, whatever the palette held before, and so are the roundings once they are measured",
      {.number_type = "double", .cases = 300, .degenerate_at_least = 0.3}, [] {
        const auto plan = *gen::mesh_plan();
        const SkinnedMesh model = gen::make_mesh(plan);
        const JointSets sets(model);
        std::mt19937 random(plan.seed);
        const double spread = *rc::gen::element(0.0, 1e-5, 1e-3, 0.5, 3.0);
        RC_CLASSIFY(spread < 0.1 || gen::is_degenerate(plan), "degenerate");
        for (const Skinning skinning : gen::all_skinnings) {
          const PalettePacks packs(model, sets, skinning);
          SkinningPalette<double> palette = used_palette(model, sets, random);
          for (const Target target : available_targets()) {
            const Pose pose = gen::random_pose(model, random, spread);
            packs.make(pose, palette, target);
            const auto expected = make_skinning_palette(model, sets, pose, skinning);
            RC_ASSERT(are_equal(palette, expected));
            RC_ASSERT(is_measured_anew(palette, expected));
          }
        }
      });
  t.holds("also at the ends of what is accepted: up to 90 joints a joint-set, tiny and huge, quaternions off unit length",
          {.number_type = "double", .cases = 200}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const gen::WideModel wide = gen::wide_model(random);
            const JointSets sets(wide.mesh);
            for (const Skinning skinning : gen::all_skinnings) {
              const PalettePacks packs(wide.mesh, sets, skinning);
              const auto expected = make_skinning_palette(wide.mesh, sets, wide.pose, skinning);
              SkinningPalette<double> palette;
              for (const Target target : available_targets()) {
                packs.make(wide.pose, palette, target);
                RC_ASSERT(are_equal(palette, expected));
              }
            }
          });
  t.example("also those of a man who walks, with joint-sets of one to four joints", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    const PalettePacks packs(man, sets, Skinning::spherical);
    SkinningPalette<double> palette;
    long wrong = 0;
    for (int i = 0; i < 20; ++i) {
      const Pose pose = man.clips[0].sample(i / 20.0 * man.clips[0].duration);
      packs.make(pose, palette);
      wrong += !are_equal(palette, make_skinning_palette(man, sets, pose, Skinning::spherical));
    }
    return Checked(wrong == 0, 20, std::to_string(sets.count()) + " joint-sets");
  });
  t.example("a pose that make_skinning_palette refuses is refused, and the palette stays", {}, [] {
    const SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
    const JointSets sets(model);
    const PalettePacks packs(model, sets, Skinning::spherical);
    SkinningPalette<double> palette;
    const Pose good = reference_pose(model);
    packs.make(good, palette);
    Pose bad = good;
    bad[1].rotation *= 2;
    try {
      packs.make(bad, palette);
      return Checked(false);
    } catch (const ModelError& e) {
      return Checked(are_equal(palette, make_skinning_palette(model, sets, good, Skinning::spherical)), 1, e.what());
    }
  });
}

}  // namespace proptests::suite_palette_packs
