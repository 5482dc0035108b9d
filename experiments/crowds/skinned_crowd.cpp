// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/skinned_crowd.hpp"

#include "algorithms/runtime/collide/meeting_boxes.hpp"

namespace refitlab {

SkinnedCrowd::SkinnedCrowd(const ClusterTree& tree, int count)
    : tree_(tree),
      motion_bound_(tree.way_of(Skinning::spherical).motion_bound),
      boxes_(count),
      is_skinned_(count) {
  for (int i = 0; i < count; ++i) bodies_.push_back(std::make_unique<SkinnedBody>(tree));
}

void SkinnedCrowd::skin(int i, const Pose& pose, const RigidTransform<double>& placement) {
  SkinnedBody& body = *bodies_[i];
  body.clusters().begin(pose, placement, placement.translation);
  body.clusters().skin_all();
  body.refit();
  is_skinned_[i] = true;
}

Box<double> SkinnedCrowd::box(int i) const {
  SkinnedBody& body = *bodies_[i];
  Box<double> box = box_of<double>(body.wide_node_box(0));
  box.low += body.clusters().origin(), box.high += body.clusters().origin();
  box.grow(body.clusters().lost());
  return box;
}

std::vector<Contact> SkinnedCrowd::frame(std::span<const Pose> poses, std::span<const RigidTransform<double>> placements,
                                         Skinned skinned) {
  const int count = static_cast<int>(bodies_.size());
  is_skinned_.assign(count, false);
  for (int i = 0; i < count; ++i)
    if (skinned == Skinned::all) {
      check_pose(tree_.character().mesh, poses[i]);
      skin(i, poses[i], placements[i]);
      boxes_[i] = box(i);
    } else {
      bool is_rigid;
      boxes_[i] = motion_bound_.box(poses[i], placements[i], is_rigid);
      if (!is_rigid) check_pose(tree_.character().mesh, poses[i]);
    }
  std::vector<Contact> contacts;
  QueryCounts uncounted;
  for (const auto& [a, b] : meeting_boxes(boxes_)) {
    for (const int i : {a, b})
      if (!is_skinned_[i]) skin(i, poses[i], placements[i]);
    ClusterPairs pairs(bodies_[a]->clusters(), bodies_[b]->clusters(), Query::full, uncounted, scratch_);
    auto found = ClusterTraversal(*bodies_[a], *bodies_[b], pairs, uncounted, hits_).run();
    if (!found.empty()) contacts.push_back({a, b, std::move(found)});
  }
  return contacts;
}

}  // namespace refitlab
