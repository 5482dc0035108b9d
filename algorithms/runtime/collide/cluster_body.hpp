// SPDX-License-Identifier: MIT
// ClusterBody: a placed character in one frame, as the fast queries see it: at first only how far it can reach; then
// wide nodes bounded and clusters skinned where a query gets to.
#pragma once

#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/cluster_tree.hpp"
#include "algorithms/runtime/collide/motion_bound.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/refit/frame_stamps.hpp"

namespace refitlab {

class ClusterBody {
 public:
  // tree outlives this.
  ClusterBody(const ClusterTree& tree, Skinning skinning);
  ClusterBody(const ClusterBody&) = delete;  // a copy would write into the arrays of this one

  // Starts a frame, of which nothing is worked out yet. placement takes model space to the world. Throws ModelError for
  // a pose that make_skinning_palette refuses, std::invalid_argument for a placement that is not rigid.
  void begin(const Pose& pose, const RigidTransform<double>& placement);

  const ClusterTree& tree() const { return tree_; }

  // A box in the world around all of it, from the joints alone; see MotionBound.
  const Box<double>& reach() const { return motion_bound_box_; }

  // Boxes in the world around all vertices below: of a wide node's children, in blocks, and of one of them.
  const BoxBlock<double>* wide_node_boxes(int wide_node);
  Box<double> child_box(int wide_node, int child) { return get_box(wide_node_boxes(wide_node), child); }
  // Around all of a wide node.
  const Box<double>& wide_node_box(int wide_node);

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
  struct QueryScratch {
    std::vector<int> hits;
    std::vector<TrianglePairCandidate> pairs;
    std::vector<Filtered> answers;
  };
  QueryScratch& query_scratch() { return query_scratch_; }

  // Since begin.
  long nodes_bounded() const { return nodes_bounded_; }
  long clusters_skinned() const { return clusters_skinned_; }
  long corners_skinned() const { return corners_skinned_; }

 private:
  // What was skinned of a cluster; room for it is made when a query first gets there.
  struct Skinned {
    std::vector<Corner> corners;              // by place
    std::vector<BoxBlock<double>> groups;     // their boxes, in blocks
    std::vector<BoxBlock<double>> triangles;  // by group
    Box<double> box;
  };

  void make_palettes(std::span<const int> parts);
  void bound_wide_node(int wide_node);
  void bound_by_control_points(const WideNode& wide_node, std::span<FlippedBox> flipped, std::span<Box<double>> boxes);
  void skin_cluster(int cluster);
  const Skinned& skinned(int cluster) {
    if (!clusters_made_.is_made(cluster)) skin_cluster(cluster);
    return skinned_[cluster];
  }

  const ClusterTree& tree_;
  const Skinning skinning_;
  const BoxKernels& kernels_;
  MotionBound motion_bound_;
  const PalettePacks palette_packs_;
  Pose pose_;
  RigidTransform<double> placement_;
  Box<double> motion_bound_box_;
  SkinningPalette<double> palette_;  // of what parts were made
  const SkinningPalette<double>::Arrays palette_arrays_;
  FrameStamps palettes_made_;                       // by part of palette_packs_
  std::vector<std::vector<int>> parts_of_cluster_;  // of palette_packs_
  std::vector<int> all_parts_;
  JointFloats joints_;
  bool are_joints_placed_ = false, are_floats_filled_ = false;
  FrameStamps wide_nodes_made_, clusters_made_, groups_made_;
  std::vector<int> first_block_of_wide_node_;
  std::vector<BoxBlock<double>> wide_node_blocks_;
  std::vector<Box<double>> wide_node_boxes_;
  SkinnedVertices unplaced_;         // of the cluster in work, in model space
  std::vector<Skinned> skinned_;     // by cluster
  std::vector<FlippedBox> flipped_;  // of the wide node in work, and its boxes
  std::vector<Box<double>> boxes_;
  QueryScratch query_scratch_;
  long nodes_bounded_ = 0, clusters_skinned_ = 0, corners_skinned_ = 0;
};

}  // namespace refitlab
