// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/allocations.hpp"

#include <algorithm>
#include <bit>
#include <random>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_allocations {
namespace {

using namespace refitlab;
using oracle::allocations_in;

constexpr int frames = 12;

Pose step(const AnimatedCharacter& c, int frame, double share) {
  const Clip& walk = c.clips[0];
  return walk.sample(std::fmod(frame / static_cast<double>(frames) + share, 1.0) * walk.duration);
}

// Two bodies that overlap, and queries of which one allocation fails. Returns how many queries failed; -1 if one of them, asked again in the
// same frame, did not find the pairs that it should. skins_rather: whether clusters are skinned where wide nodes are bounded.
long failed_queries(const ClusterTree& tree, Skinning skinning, const Pose& pose, bool skins_rather) {
  const RigidTransform<double> beside{identity_quaternion<double>(), {0.125, 0.0625, 0.03125}};
  std::vector<TrianglePair> expected;
  for (long after = -1;; ++after) {
    ClusterBody a(tree, skinning), b(tree, skinning);
    a.begin(pose, {}), b.begin(pose, beside);
    if (skins_rather) a.skin_rather(), b.skin_rather();
    QueryCounts counts;
    bool has_failed = false;
    if (after >= 0) try {
        const oracle::FailingAllocation failing(after);
        collide(a, b, Query::full, counts);
      } catch (const std::bad_alloc&) {
        has_failed = true;
      }
    std::vector<TrianglePair> found = collide(a, b, Query::full, counts);
    std::sort(found.begin(), found.end());
    if (after < 0) expected = found;
    if (found != expected || expected.empty()) return -1;
    if (after >= 0 && !has_failed) return after;
  }
}

}  // namespace

PROPTEST(allocations) {
  if (oracle::allocations_can_fail)
    t.example("a query that runs out of memory at any allocation finds all pairs when it is asked again in the frame", {}, [] {
      const auto c = bake(gen::make_mesh({gen::MeshKind::many_influences, 6, 6, 4, 2006}));
      const ClusterTree tree(c, {.most_triangles = 4, .most_children = 2});
      std::mt19937 random(2006);
      const Pose pose = gen::random_pose(c.mesh, random);
      long failed = 0;
      for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion})
        for (const bool skins_rather : {false, true}) {
          const long of_skinning = failed_queries(tree, skinning, pose, skins_rather);
          if (of_skinning < 20) return Checked(false, failed, std::to_string(of_skinning));
          failed += of_skinning;
        }
      return Checked(true, failed);
    });
  t.example("the counter sees what a container and an aligned object take", {.number_type = "heap"}, [] {
    struct alignas(64) Wide {
      char of[64];
    };
    const long list = allocations_in([] { std::vector<int>(100); }), wide = allocations_in([] { std::vector<Wide>(3); }),
               none = allocations_in([] {});
    return Checked(list == 1 && wide == 1 && none == 0, 3);
  });
  t.example("a query takes nothing from the heap but its answer, once it was asked in each place", {}, [] {
    const auto man = bake(make_man());
    const ClusterTree tree(man);
    ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical);
    bool ok = true;
    long asked = 0, pairs_found = 0;
    for (const double distance : {5.0, 0.6, 0.35, 0.1})
      for (const Query query : {Query::full, Query::yes_no})
        for (const bool has_memory : {false, true}) {
          PairMemory memory;
          QueryCounts counts;
          const RigidTransform<double> at{identity_quaternion<double>(), {distance, 0, 0}};
          for (int frame = 0; frame < 2 * frames; ++frame) {  // twice around: the first time may make room
            const Pose first = step(man, frame, 0.2), second = step(man, frame, 0.7);
            std::size_t found = 0;
            const long allocations = allocations_in([&] {
              a.begin(first, {}), b.begin(second, at);
              found = collide(a, b, query, counts, has_memory ? &memory : nullptr).size();
            });
            // A list that doubles as it grows.
            const long for_answer = query == Query::full ? static_cast<long>(std::bit_width(2 * found)) : 10;
            if (frame >= frames) ok = ok && allocations <= (found > 0 ? for_answer : 0), ++asked, pairs_found += found;
          }
        }
    return Checked(ok && pairs_found > 1000, asked);
  });
  t.example(
      "a frame of poses takes nothing from the heap after the first one, and a batch three times a "
      "kernel",
      {}, [] {
        const auto man = bake(make_man());
        BatchRefit batch(man.tree, man.sets);
        const PalettePacks packs(man.mesh, man.sets, Skinning::spherical);
        SkinningPalette<double> palette;
        long taken = 0, of_batch = 0;
        float sum = 0;
        for (int frame = 0; frame < frames; ++frame) {
          const Pose pose = step(man, frame, 0);
          const long allocations = allocations_in([&] { packs.make(pose, palette); });
          const long batches =
              allocations_in([&] { sum += batch.spherical(palette)[0].radius + batch.linear(palette)[0].radius; });
          if (frame > 0) taken += allocations, of_batch = std::max(of_batch, batches);
        }
        return Checked(taken == 0 && of_batch <= 12 && sum > 0, frames - 1, "a batch " + std::to_string(of_batch));
      });
}

}  // namespace proptests::suite_allocations
