// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/skinned_crowd.hpp"

#include <algorithm>

#include "algorithms/runtime/collide/meeting_boxes.hpp"

namespace refitlab {
namespace {

constexpr std::size_t bodies_at_once = 16;  // of a task that makes their boxes

}  // namespace

SkinnedCrowd::SkinnedCrowd(const ClusterTree& tree, int count)
    : tree_(tree),
      boxes_(count),
      is_skinned_(count),
      motion_bounds_((count + bodies_at_once - 1) / bodies_at_once, tree.way_of(Skinning::spherical).motion_bound) {
  for (int i = 0; i < count; ++i) members_.push_back(std::make_unique<Member>(tree));
}

void SkinnedCrowd::skin(std::size_t i, const Pose& pose, const RigidTransform<double>& placement) {
  SkinnedClusters& clusters = members_[i]->clusters;
  clusters.begin(pose, placement, placement.translation);
  clusters.skin_all();
  Box<double>& box = boxes_[i];
  box = box_of<double>(clusters.box_around_all());
  box.low += clusters.origin(), box.high += clusters.origin();
  box.grow(clusters.lost());
  is_skinned_[i] = true;
}

std::vector<Contact> SkinnedCrowd::frame(std::span<const Pose> poses, std::span<const RigidTransform<double>> placements,
                                         Skinned skinned, Query query, const Workers& workers) {
  std::fill(is_skinned_.begin(), is_skinned_.end(), false);
  for_each(workers, motion_bounds_.size(), [&](std::size_t task) {
    const std::size_t end = std::min(members_.size(), (task + 1) * bodies_at_once);
    for (std::size_t i = task * bodies_at_once; i < end; ++i)
      if (skinned == Skinned::all) {
        check_pose(tree_.character().mesh, poses[i]);
        skin(i, poses[i], placements[i]);
      } else {
        boxes_[i] = motion_bounds_[task].checked_box(poses[i], placements[i]);
      }
  });
  const auto pairs = meeting_boxes(boxes_);
  std::vector<Contact> contacts(pairs.size());
  for_each(workers, pairs.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    Member &first = *members_[a], &second = *members_[b];
    const std::scoped_lock both(first.in_work, second.in_work);
    // A box of vertices is smaller than a motion bound, so the second body need not be skinned if the first one's is apart from it.
    for (const int k : {a, b}) {
      if (are_apart(boxes_[a], boxes_[b])) return;
      if (!is_skinned_[k]) skin(k, poses[k], placements[k]);
    }
    QueryCounts uncounted;
    ClusterPairs of_clusters(first.clusters, second.clusters, query, uncounted, first.scratch);
    of_clusters.add_all();
    contacts[i] = {a, b, of_clusters.take_found()};
  });
  std::erase_if(contacts, [](const Contact& contact) { return contact.pairs.empty(); });
  return contacts;
}

}  // namespace refitlab
