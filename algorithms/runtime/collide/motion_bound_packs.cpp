// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_bound_packs.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/b7_motion_bound.hpp"

namespace refitlab {

void put_lane(MotionBoundPack& pack, int lane, std::span<const int> joints, const Ball3<double>& ball, double to_prior,
              int target) {
  const int n = static_cast<int>(joints.size());
  for (int four = 0; four < motion_bound_lanes / 4; ++four) {
    if (lane == 0) pack.slot_count[four] = 0;
    if (four <= lane / 4) pack.slot_count[four] = std::max(pack.slot_count[four], n);
  }
  for (int to = lane; to < motion_bound_lanes; ++to) {
    for (int k = 0; k < most_motion_bound_joints; ++k) pack.joint[k][to] = joints[k < n ? k : 0];
    for (int i = 0; i < 3; ++i) pack.center[i][to] = static_cast<float>(ball.center[i]);
    pack.radius[to] =
        static_cast<float>(ball.radius * (1 + lost_of_motion_bound) + lost_of_motion_bound * n * ball.center.norm());
    pack.unsolved[to] = static_cast<float>(to_prior * n / 64);
    pack.joint_count[to] = static_cast<float>(n);
    pack.target[to] = target;
  }
}

namespace {

// Does for the piece's box what put_lane does for its ball.
void put_box(MotionBoundPiecePack& pack, int lane, int n, const Box<double>& box, const Ball3<double>& ball) {
  const Point3 center = box.center(), half = (box.high - box.low) / 2;
  const double length = std::max(center.norm(), ball.center.norm());  // of a point whose images are looked at
  for (int to = lane; to < motion_bound_lanes; ++to) {
    for (int i = 0; i < 3; ++i) {
      pack.box_center[i][to] = static_cast<float>(center[i]);
      pack.half[i][to] = static_cast<float>(half[i]);
    }
    pack.lost[to] = static_cast<float>(lost_of_motion_bound * (n * length + half.norm()));
    pack.spin[to] = static_cast<float>(std::sqrt(squared_turn_of_count<double>(n)) * ball.radius * (1 + 1e-6));
    pack.unsolved_more[to] = static_cast<float>(ball.radius * n / 64);
  }
}

// Does the same for what is known of its weights.
void put_weights(MotionBoundPiecePack& pack, int lane, const PieceWeights& weights) {
  double rest = 1;
  for (int k = 0; k < most_motion_bound_joints; ++k) {
    const bool is_joint = k < static_cast<int>(weights.least.size());
    const float least = is_joint ? std::max(0.f, float_below(weights.least[static_cast<std::size_t>(k)])) : 0;
    rest -= least;
    for (int to = lane; to < motion_bound_lanes; ++to) pack.least[k][to] = least;
  }
  for (int to = lane; to < motion_bound_lanes; ++to) {
    pack.rest[to] = float_above(std::max(0., rest));
    pack.products[to] = float_above(weights.products * (1 + 1e-15));
    pack.squared_products[to] = float_above(weights.squared_products * (1 + 1e-15));
  }
}

}  // namespace

std::vector<MotionBoundPiecePack> make_motion_bound_packs(const Character& c, std::span<const MotionPiece> pieces) {
  const DefaultFloatEnvironment environment;
  const auto joints_of = [&](const MotionPiece& p) { return c.sets.joints(p.joint_set); };
  std::vector<const MotionPiece*> sorted;
  for (const MotionPiece& p : pieces) {
    if (joints_of(p).size() > most_motion_bound_joints || !can_be_bounded(p.reference)) return {};
    sorted.push_back(&p);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [&](auto* a, auto* b) { return joints_of(*a).size() > joints_of(*b).size(); });
  std::vector<MotionBoundPiecePack> packs;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const MotionPiece& p = *sorted[i];
    const int lane = static_cast<int>(i % motion_bound_lanes);
    if (lane == 0) packs.emplace_back();
    const auto joints = joints_of(p);
    put_lane(packs.back().ball, lane, joints, p.reference, p.to_prior, p.target);
    put_box(packs.back(), lane, static_cast<int>(joints.size()), p.box, p.reference);
    put_weights(packs.back(), lane, p.weights);
  }
  return packs;
}

}  // namespace refitlab
