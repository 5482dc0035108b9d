// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/skinned_crowd.hpp"

#include "algorithms/runtime/collide/meeting_boxes.hpp"

namespace refitlab {

SkinnedCrowd::SkinnedCrowd(const ClusterTree& tree, int count) : tree_(tree) {
  for (int i = 0; i < count; ++i) members_.push_back(std::make_unique<Member>(tree));
}

void SkinnedCrowd::skin(Member& member, const Pose& pose, const RigidTransform<double>& placement) {
  SkinnedBody& body = member.body;
  body.clusters().begin(pose, placement, placement.translation);
  body.clusters().skin_all();
  body.refit();
  member.box = box_of<double>(body.wide_node_box(0));
  member.box.low += body.clusters().origin(), member.box.high += body.clusters().origin();
  member.box.grow(body.clusters().lost());
  member.is_skinned = true;
}

std::vector<Contact> SkinnedCrowd::frame(std::span<const Pose> poses, std::span<const RigidTransform<double>> placements,
                                         Skinned skinned, Query query, const Workers& workers) {
  for_each(workers, members_.size(), [&](std::size_t i) {
    Member& member = *members_[i];
    member.is_skinned = false;
    if (skinned == Skinned::all) {
      check_pose(tree_.character().mesh, poses[i]);
      skin(member, poses[i], placements[i]);
    } else {
      member.box = member.motion_bound.checked_box(poses[i], placements[i]);
    }
  });
  std::vector<Box<double>> boxes;
  for (const auto& member : members_) boxes.push_back(member->box);
  const auto pairs = meeting_boxes(boxes);
  std::vector<Contact> contacts(pairs.size());
  for_each(workers, pairs.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    Member &first = *members_[a], &second = *members_[b];
    const std::scoped_lock both(first.in_work, second.in_work);
    // A box of vertices is smaller than a motion bound, so the second body need not be skinned if the first one's is apart from it.
    for (const int k : {a, b}) {
      if (are_apart(first.box, second.box)) return;
      if (!members_[k]->is_skinned) skin(*members_[k], poses[k], placements[k]);
    }
    QueryCounts uncounted;
    ClusterPairs of_clusters(first.body.clusters(), second.body.clusters(), query, uncounted, first.scratch);
    contacts[i] = {a, b, ClusterTraversal(first.body, second.body, of_clusters, uncounted, first.hits).run()};
    if (query == Query::yes_no && contacts[i].pairs.size() > 1) contacts[i].pairs.resize(1);
  });
  std::erase_if(contacts, [](const Contact& contact) { return contact.pairs.empty(); });
  return contacts;
}

}  // namespace refitlab
