// ClusterBody: a placed character in one frame, as the fast queries see it: at first only how far it can reach; then
// fans bounded and clusters skinned where a query gets to.
#pragma once

#include "algorithms/runtime/batch/pose_packs.hpp"
#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/cluster_tree.hpp"
#include "algorithms/runtime/collide/reach.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/refit/frame_stamps.hpp"

namespace refitlab {

class ClusterBody {
 public:
  // tree outlives this.
  ClusterBody(const ClusterTree& tree, Skinning skinning);
  ClusterBody(const ClusterBody&) = delete;  // a copy would write into the arrays of this one

  // Starts a frame, of which nothing is worked out yet. placement takes model space to the world. Throws ModelError for
  // a posture that make_skinning_pose refuses, std::invalid_argument for a placement that is not rigid.
  void begin(const Posture& posture, const RigidTransform<double>& placement);

  const ClusterTree& tree() const { return tree_; }

  // A box in the world around all of it, from the joints alone; see Reach.
  const Box<double>& reach() const { return reach_box_; }

  // Boxes in the world around all vertices below: of a fan's children, in blocks, and of one of them.
  const BoxBlock<double>* fan_boxes(int fan);
  Box<double> child_box(int fan, int child) { return get_box(fan_boxes(fan), child); }
  // Around all of a fan.
  const Box<double>& fan_box(int fan);

  // Boxes in the world around the skinned vertices of a cluster's groups, in blocks, and of all of it.
  const BoxBlock<double>* group_boxes(int cluster) { return skinned(cluster).groups.data(); }
  const Box<double>& cluster_box(int cluster) { return skinned(cluster).box; }
  // Around the triangles of a group.
  const BoxBlock<double>& triangle_boxes(int cluster, int group);

  // By place in the cluster, in the world: the very doubles that apply(placement, skin()) yields.
  const Corner* corners(int cluster) { return skinned(cluster).corners.data(); }

  // A triangle of the model by itself, in the world: the same doubles, without its cluster.
  TrianglePoints triangle(int triangle);

  // For one query at a time, so that it need not make room of its own: positions of boxes, pairs of triangles whose
  // boxes meet, and what the filter says of them.
  struct QueryRoom {
    std::vector<int> hits;
    std::vector<CornerPair> pairs;
    std::vector<Filtered> answers;
  };
  QueryRoom& query_room() { return query_room_; }

  // Since begin.
  long nodes_bounded() const { return nodes_bounded_; }
  long clusters_skinned() const { return clusters_skinned_; }
  long corners_skinned() const { return corners_skinned_; }

 private:
  // What was skinned of a cluster; room for it is made when a query first gets there.
  struct Skinned {
    std::vector<Corner> corners;      // by place
    std::vector<BoxBlock<double>> groups;     // their boxes, in blocks
    std::vector<BoxBlock<double>> triangles;  // by group
    Box<double> box;
  };

  void make_poses(std::span<const int> parts);
  void bound_fan(int fan);
  void bound_by_control_points(const Fan& fan, std::span<FlippedBox> flipped, std::span<Box<double>> boxes);
  void skin_cluster(int cluster);
  const Skinned& skinned(int cluster) {
    if (!clusters_made_.is_made(cluster)) skin_cluster(cluster);
    return skinned_[cluster];
  }

  const ClusterTree& tree_;
  const Skinning skinning_;
  const BoxKernels& kernels_;
  Reach reach_;
  const PosePacks pose_packs_;
  Posture posture_;
  RigidTransform<double> placement_;
  Box<double> reach_box_;
  SkinningPose<double> pose_;  // of what parts were made
  const SkinningPose<double>::Arrays pose_arrays_;
  FrameStamps poses_made_;                          // by part of pose_packs_
  std::vector<std::vector<int>> parts_of_cluster_;  // of pose_packs_
  std::vector<int> all_parts_;
  JointFloats joints_;
  bool are_joints_placed_ = false, are_floats_filled_ = false;
  FrameStamps fans_made_, clusters_made_, groups_made_;
  std::vector<int> first_block_of_fan_;
  std::vector<BoxBlock<double>> fan_blocks_;
  std::vector<Box<double>> fan_boxes_;
  SkinnedVertices unplaced_;         // of the cluster in work, in model space
  std::vector<Skinned> skinned_;     // by cluster
  std::vector<FlippedBox> flipped_;  // of the fan in work, and its boxes
  std::vector<Box<double>> boxes_;
  QueryRoom query_room_;
  long nodes_bounded_ = 0, clusters_skinned_ = 0, corners_skinned_ = 0;
};

}  // namespace refitlab
