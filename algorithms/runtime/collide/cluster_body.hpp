// SPDX-License-Identifier: MIT
// ClusterBody: a placed character in one frame, as the fast queries see it. At first only its motion bound is known. Then
// wide nodes are bounded and clusters are skinned where a query reaches them.
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
  // tree must outlive this.
  ClusterBody(const ClusterTree& tree, Skinning skinning);
  ClusterBody(const ClusterBody&) = delete;  // a copy would write into the arrays of this one

  // Starts a frame, of which nothing is computed yet. placement takes model space to the world. Throws ModelError for a
  // pose that make_skinning_palette refuses, and std::invalid_argument for a placement that is not rigid.
  void begin(const Pose& pose, const RigidTransform<double>& placement);

  const ClusterTree& tree() const { return tree_; }

  // Returns a box in the world around the whole body, made from the joints alone; see MotionBound.
  const Box<double>& motion_bound() const { return motion_bound_box_; }

  // These are boxes in the world around all vertices below: those of a wide node's children, in blocks, and that of one
  // child.
  const BoxBlock<double>* wide_node_boxes(int wide_node);
  Box<double> child_box(int wide_node, int child) { return get_box(wide_node_boxes(wide_node), child); }
  // Returns the box around all of a wide node.
  const Box<double>& wide_node_box(int wide_node);

  // These are boxes in the world around the skinned vertices of a cluster's groups, in blocks, and of the whole cluster.
  const BoxBlock<double>* group_boxes(int cluster) { return skinned(cluster).groups.data(); }
  const Box<double>& cluster_box(int cluster) { return skinned(cluster).box; }
  // Returns the boxes around the triangles of a group.
  const BoxBlock<double>& triangle_boxes(int cluster, int group);

  // Returns a cluster's skinned corners in the world, by position in the cluster: the very doubles that apply(placement,
  // skin()) yields.
  const PaddedVertex* corners(int cluster) { return skinned(cluster).corners.data(); }

  // Returns the corners of a single triangle of the model in the world: the same doubles, but without its cluster.
  TrianglePoints triangle(int triangle);

  // Working storage for one query at a time, so that the query need not allocate its own: positions of boxes, pairs of
  // triangles whose boxes meet, and the filter's answers.
  struct QueryScratch {
    std::vector<int> hits;
    std::vector<TrianglePairCandidate> pairs;
    std::vector<Filtered> answers;
  };
  QueryScratch& query_scratch() { return query_scratch_; }

  // These counts are since begin.
  long nodes_bounded() const { return nodes_bounded_; }
  long clusters_skinned() const { return clusters_skinned_; }
  long corners_skinned() const { return corners_skinned_; }

 private:
  // The skinned part of a cluster. Its storage is allocated when a query first reaches the cluster.
  struct Skinned {
    std::vector<PaddedVertex> corners;        // by place
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
