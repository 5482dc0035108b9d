#include "algorithms/runtime/batch/pose_packs.hpp"

#include <random>

#include "algorithms/model/procedural/procedural.hpp"
#include "proptests/gen/random_posture.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_pose_packs {
namespace {

using namespace refitlab;

template <int D>
bool equal_lists(std::span<const Vec<double, D>> a, std::span<const Vec<double, D>> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// Every number, but for the sign of a zero.
bool are_equal(const SkinningPose<double>& a, const SkinningPose<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t s = 0; s < a.size(); ++s) {
    const JointSetPose<double> p = a[s], q = b[s];
    if (p.rotation_center != q.rotation_center || p.transforms.size() != q.transforms.size()) return false;
    for (std::size_t i = 0; i < p.transforms.size(); ++i)
      if (p.transforms[i].rotation != q.transforms[i].rotation ||
          p.transforms[i].translation != q.transforms[i].translation)
        return false;
    if (!equal_lists(p.center_images, q.center_images) || !equal_lists(p.duals, q.duals)) return false;
  }
  return true;
}

constexpr Skinning all_skinnings[] = {Skinning::linear, Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion};

}  // namespace

PROPTEST(pose_packs) {
  t.holds(
      "the numbers are those of make_skinning_pose, in every skinning and for every target, one posture after the "
      "other",
      {.number_type = "double", .cases = 300, .degenerate_at_least = 0.3}, [] {
        const auto plan = *gen::mesh_plan();
        const SkinnedMesh model = gen::make_mesh(plan);
        const JointSets sets(model);
        std::mt19937 random(plan.seed);
        const double spread = *rc::gen::element(0.0, 1e-5, 1e-3, 0.5, 3.0);
        RC_CLASSIFY(spread < 0.1 || gen::is_degenerate(plan), "degenerate");
        for (const Skinning skinning : all_skinnings) {
          const PosePacks packs(model, sets, skinning);
          SkinningPose<double> pose;
          for (const Target target : available_targets()) {
            const Posture posture = gen::random_posture(model, random, spread);
            packs.make(posture, pose, target);
            RC_ASSERT(are_equal(pose, make_skinning_pose(model, sets, posture, skinning)));
          }
        }
      });
  t.holds("also at the ends of what is accepted: up to 90 joints a joint-set, tiny and huge, quaternions off unit length",
          {.number_type = "double", .cases = 200}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const gen::WideModel wide = gen::wide_model(random);
            const JointSets sets(wide.mesh);
            for (const Skinning skinning : all_skinnings) {
              const PosePacks packs(wide.mesh, sets, skinning);
              const auto expected = make_skinning_pose(wide.mesh, sets, wide.posture, skinning);
              SkinningPose<double> pose;
              for (const Target target : available_targets()) {
                packs.make(wide.posture, pose, target);
                RC_ASSERT(are_equal(pose, expected));
              }
            }
          });
  t.example("also those of a man who walks, with joint-sets of one to four joints", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    const PosePacks packs(man, sets, Skinning::spherical);
    SkinningPose<double> pose;
    long wrong = 0;
    for (int i = 0; i < 20; ++i) {
      const Posture posture = man.clips[0].sample(i / 20.0 * man.clips[0].duration);
      packs.make(posture, pose);
      wrong += !are_equal(pose, make_skinning_pose(man, sets, posture, Skinning::spherical));
    }
    return Checked(wrong == 0, 20, std::to_string(sets.count()) + " joint-sets");
  });
  t.example("a posture that make_skinning_pose refuses is refused, and the pose stays", {}, [] {
    const SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
    const JointSets sets(model);
    const PosePacks packs(model, sets, Skinning::spherical);
    SkinningPose<double> pose;
    const Posture good = reference_posture(model);
    packs.make(good, pose);
    Posture bad = good;
    bad[1].rotation *= 2;
    try {
      packs.make(bad, pose);
      return Checked(false);
    } catch (const ModelError& e) {
      return Checked(are_equal(pose, make_skinning_pose(model, sets, good, Skinning::spherical)), 1, e.what());
    }
  });
}

}  // namespace proptests::suite_pose_packs
