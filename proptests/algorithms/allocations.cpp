// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what queries of collisions and refits take from the heap: nothing but their answers. One that runs out of memory leaves
// bodies as they were.
#include "proptests/oracles/allocations.hpp"

#include <algorithm>
#include <bit>
#include <random>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_allocations {
namespace {

using namespace refitlab;
using oracle::allocations_in;

constexpr int frames = 12;

Pose step(const AnimatedCharacter& c, int frame, double share) {
  const Clip& walk = c.clips[0];
  return walk.sample(std::fmod(frame / static_cast<double>(frames) + share, 1.0) * walk.duration);
}

std::vector<TrianglePair> sorted_pairs(ClusterBody& a, ClusterBody& b) {
  QueryCounts counts;
  std::vector<TrianglePair> found = collide(a, b, Query::full, counts);
  std::sort(found.begin(), found.end());
  return found;
}

// Returns how many queries of two bodies that overlap fail if one allocation fails in each, or -1 if one of them, asked again in
// the same frame, does not find the pairs that it should. skins_rather says whether clusters are skinned where wide nodes are
// bounded.
long failed_queries(const ClusterTree& tree, Skinning skinning, const Pose& pose, bool skins_rather) {
  const RigidTransform<double> beside{identity_quaternion<double>(), {0.125, 0.0625, 0.03125}};
  std::vector<TrianglePair> expected;
  for (long after = -1;; ++after) {
    ClusterBody a(tree, skinning), b(tree, skinning);
    a.begin(pose, {}), b.begin(pose, beside);
    if (skins_rather) a.skin_rather(), b.skin_rather();
    bool has_failed = false;
    if (after >= 0) try {
        QueryCounts counts;
        const oracle::FailingAllocation failing(after);
        collide(a, b, Query::full, counts);
      } catch (const std::bad_alloc&) {
        has_failed = true;
      }
    const std::vector<TrianglePair> found = sorted_pairs(a, b);
    if (after < 0) expected = found;
    if (found != expected || expected.empty()) return -1;
    if (after >= 0 && !has_failed) return after;
  }
}

// Makes a flat sheet of squares. Floats and packs of doubles leave most pairs of two such sheets in one plane to the exact test.
SkinnedMesh sheet(int squares) {
  SkinnedMesh mesh;
  mesh.name = "sheet";
  mesh.joints = {{"first", -1, {0, 0, 0}}, {"second", 0, {0, 0, 0}}};
  for (int y = 0; y <= squares; ++y)
    for (int x = 0; x <= squares; ++x) {
      mesh.vertices.emplace_back(x / 4.0, y / 4.0, 0);
      if (x % 2) mesh.influences.push_back({{0, 0.5}, {1, 0.5}});
      else mesh.influences.push_back({{0, 1.0}});
    }
  for (int y = 0; y < squares; ++y)
    for (int x = 0; x < squares; ++x) {
      const int v = y * (squares + 1) + x;
      mesh.triangles.push_back({v, v + 1, v + squares + 2}), mesh.triangles.push_back({v, v + squares + 2, v + squares + 1});
    }
  mesh.targets.count = 1;
  mesh.targets.of_vertex.assign(mesh.vertices.size(), {{0, {0, 0, 1}}});
  return mesh;
}

// Checks that a body whose query ran out of memory at any allocation answers in another frame, against another body.
Checked check_next_frame() {
  const Character large = bake(sheet(3)), small = bake(sheet(1));
  const ClusterTree of_large(large, {.most_triangles = 8, .most_children = 4}), of_small(small);
  const Pose still(2);
  long failed = 0;
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
    ClusterBody fresh(of_large, skinning), other(of_small, skinning);
    fresh.begin(still, {}), other.begin(still, {});
    const std::vector<TrianglePair> expected = sorted_pairs(fresh, other);
    // The exact test takes many thousands, of which some are tried.
    for (long after = 0;; after = after < 70 ? after + 1 : after * 5 / 4) {
      ClusterBody a(of_large, skinning), b(of_large, skinning);
      a.begin(still, {}), b.begin(still, {});
      QueryCounts counts;
      try {
        const oracle::FailingAllocation failing(after);
        collide(a, b, Query::full, counts);
        break;
      } catch (const std::bad_alloc&) {
        ++failed;
      }
      a.begin(still, {});
      if (sorted_pairs(a, other) != expected || expected.empty()) return Checked(false, failed);
    }
  }
  return Checked(failed > 3 * 70, failed);
}

// Begins a frame of rigid or affine joints, which are this high, with a morph target or without.
struct Frame {
  bool is_affine, has_weight;
  double height;

  void begin(ClusterBody& body, const RigidTransform<double>& placement) const {
    const Pose rigid(2, {identity_quaternion<double>(), {0, 0, height}});
    AffinePose affine(2, identity_map<double>());
    for (auto& joint : affine) joint.offset = {0, 0, height};
    const std::vector<double> weights = {1.0 / 256};
    if (is_affine) body.begin(affine, placement, has_weight ? weights : std::vector<double>{});
    else body.begin(rigid, placement, has_weight ? Deformation{weights, {}} : Deformation{});
  }
};

// Checks that a body whose next frame cannot begin for want of memory is in none, or still in the one before, and that the next
// one may begin then.
Checked check_frames_that_fail() {
  const Character c = bake(sheet(3));
  const ClusterTree tree(c, {.most_triangles = 2, .most_children = 2});
  const RigidTransform<double> away{identity_quaternion<double>(), {50, 0, 0}};
  long failed = 0, in_none = 0;
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical})
    for (int kinds = 0; kinds < 16; ++kinds) {
      const bool has_weight = kinds & 1;
      const Frame before{(kinds & 2) != 0, has_weight, has_weight ? -1.0 / 256 : 0}, next{(kinds & 4) != 0, (kinds & 8) != 0, 7};
      ClusterBody b(tree, skinning);
      b.begin(Pose(2), {});
      for (long after = 0;; ++after) {
        ClusterBody a(tree, skinning);
        before.begin(a, {});
        const std::vector<TrianglePair> expected = sorted_pairs(a, b);
        before.begin(a, {});
        try {
          const oracle::FailingAllocation failing(after);
          next.begin(a, away);
          break;
        } catch (const std::bad_alloc&) {
          ++failed;
        }
        try {
          if (sorted_pairs(a, b) != expected || expected.empty()) return Checked(false, failed, "another frame's pairs");
        } catch (const std::logic_error&) {
          ++in_none;
        }
        next.begin(a, away);
        if (!sorted_pairs(a, b).empty()) return Checked(false, failed, "pairs of bodies that are apart");
        before.begin(a, {});
        if (sorted_pairs(a, b) != expected) return Checked(false, failed, "not the pairs of the frame that is begun again");
      }
    }
  return Checked(failed > 200 && in_none > 0, failed, std::to_string(in_none) + " in no frame");
}

// Checks that a body by sphere trees whose next frame cannot begin is in no frame, or has the balls and triangles of the frame
// before.
Checked check_bodies_that_fail() {
  const Character c = bake(sheet(3));
  long failed = 0, in_none = 0;
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical})
    for (int kinds = 0; kinds < 8; ++kinds) {
      Pose rigid(2);
      AffinePose affine(2);
      for (int j = 0; j < 2; ++j) rigid[j].translation[0] = affine[j].offset[0] = 100;
      const auto deformed = kinds & 1 ? Deformation{{1.0 / 256}, {}} : Deformation{};
      const auto next = [&](Body& body) {
        if (kinds & 2) body.begin(affine, deformed.weights);
        else body.begin(rigid, deformed);
      };
      for (long after = 0;; ++after) {
        Body body(c, default_variant(skinning));
        body.begin(Pose(2), kinds & 4 ? Deformation{{-1.0 / 256}, {}} : Deformation{});
        const Ball3<double> ball = body.ball(0);
        try {
          const oracle::FailingAllocation failing(after);
          next(body);
          break;
        } catch (const std::bad_alloc&) {
          ++failed;
        }
        try {
          const bool is_as_before = body.ball(0).center == ball.center && body.ball(0).radius == ball.radius;
          if (!is_as_before || body.triangle(0)[0][0] > 50) return Checked(false, failed, "half in another frame");
        } catch (const std::logic_error&) {
          ++in_none;
        }
        next(body);
        if (body.triangle(0)[0][0] < 50 || body.ball(0).center[0] < 50)
          return Checked(false, failed, "not in the frame begun again");
      }
    }
  return Checked(failed > 100 && in_none > 0, failed, std::to_string(in_none) + " in no frame");
}

}  // namespace

PROPTEST(allocations) {
  if (oracle::allocations_can_fail) {
    t.example("after a query that runs out of memory, another frame has the pairs of its own bodies alone", {}, check_next_frame);
    t.example("a body is in no wrong frame after one that runs out of memory", {}, check_frames_that_fail);
    t.example("nor is a body by sphere trees", {}, check_bodies_that_fail);
  }
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
    [[maybe_unused]] const void* volatile kept;  // No compiler may do without what is written here.
    const auto made = [&](const auto& list) { kept = list.data(); };
    const long list = allocations_in([&] { made(std::vector<int>(100)); }),
               wide = allocations_in([&] { made(std::vector<Wide>(3)); }), none = allocations_in([] {});
    return Checked(list == 1 && wide == 1 && none == 0, 3);
  });
  t.example("a query takes nothing from the heap but its answer, once it was asked in each place", {}, [] {
    const auto man = bake_animated(make_man());
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
          // The frames are gone through twice, because the first time may make room.
          for (int frame = 0; frame < 2 * frames; ++frame) {
            const Pose first = step(man, frame, 0.2), second = step(man, frame, 0.7);
            std::size_t found = 0;
            const long allocations = allocations_in([&] {
              a.begin(first, {}), b.begin(second, at);
              found = collide(a, b, query, counts, has_memory ? &memory : nullptr).size();
            });
            // The answer is a list that doubles as it grows.
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
        const auto man = bake_animated(make_man());
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
