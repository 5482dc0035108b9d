#include "algorithms/collide/reach_packs.hpp"

#include <algorithm>

namespace refitlab {

void put_lane(ReachPack& pack, int lane, std::span<const int> joints, const Ball3<double>& ball, double to_prior,
              int target) {
  const int n = static_cast<int>(joints.size());
  pack.slot_count = lane == 0 ? n : std::max(pack.slot_count, n);
  for (int to = lane; to < reach_lanes; ++to) {
    for (int k = 0; k < most_reach_joints; ++k) pack.joint[k][to] = joints[k < n ? k : 0];
    for (int i = 0; i < 3; ++i) pack.center[i][to] = static_cast<float>(ball.center[i]);
    pack.radius[to] = static_cast<float>(ball.radius * (1 + lost_of_reach) + lost_of_reach * n * ball.center.norm());
    pack.unsolved[to] = n > 1 ? static_cast<float>(to_prior * n / 64) : 0.f;
    pack.joint_count[to] = static_cast<float>(n);
    pack.target[to] = target;
  }
}

std::vector<ReachPack> make_reach_packs(const Character& c, std::span<const NodePiece> pieces) {
  std::vector<const NodePiece*> sorted;
  for (const NodePiece& p : pieces) {
    if (p.low.size() > most_reach_joints || !can_be_reached(p.reference)) return {};
    sorted.push_back(&p);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](auto* a, auto* b) { return a->low.size() > b->low.size(); });
  std::vector<ReachPack> packs;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const NodePiece& p = *sorted[i];
    const int lane = static_cast<int>(i % reach_lanes);
    if (lane == 0) packs.emplace_back();
    const auto joints = c.sets.joints(p.joint_set);
    const Point3 prior = center_prior(c.model, joints, Skinning::spherical);
    put_lane(packs.back(), lane, joints, p.reference, (p.reference.center - prior).norm(), p.target);
  }
  return packs;
}

}  // namespace refitlab
