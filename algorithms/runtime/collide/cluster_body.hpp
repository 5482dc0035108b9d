// SPDX-License-Identifier: MIT
// ClusterBody is a placed character in one frame, as the fast queries see it. At first only its motion bound is known. Then wide
// nodes are bounded and clusters are skinned where a query reaches them.
#pragma once

#include <optional>

#include "algorithms/runtime/collide/cluster_pairs.hpp"
#include "algorithms/runtime/collide/pose_change.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"

namespace refitlab {

class ClusterBody {
 public:
  // Once a query has skinned so many clusters of a body, bounds of the others spare little.
  static constexpr int least_clusters_of_contact = 60;

  // tree must outlive this.
  ClusterBody(const ClusterTree& tree, Skinning skinning);
  ClusterBody(const ClusterBody&) = delete;  // a copy would write into the arrays of this one

  // Starts a frame, of which nothing is computed yet. placement takes model space to the world. A deformation is that of this
  // frame; then nodes are bounded by balls, with the pieces of the default variant, and all skinning is in double. Throws
  // ModelError for a pose that make_skinning_palette refuses and for a deformation that check_deformation refuses, and
  // std::invalid_argument for a placement that is not rigid, and for a deformation of a character that was baked without those
  // pieces. If it throws one of these, the body is still in the frame before. If memory runs out, the body is in no frame.
  void begin(const Pose& pose, const RigidTransform<double>& placement, const Deformation& deformation = {});
  // Starts a frame of affine joints, and of morph targets if there are weights. Linear skinning blends these transforms; other
  // skinning has two phases of them (split, in runtime/skinning/deformation.hpp). Throws the same.
  void begin(const AffinePose& pose, const RigidTransform<double>& placement, const std::vector<double>& weights = {});

  const ClusterTree& tree() const { return tree_; }
  const WayOfSkinning& way() const { return way_; }

  // All functions below that make boxes or skin throw std::logic_error if the body is in no frame.

  // Returns a box in the world around the whole body. While it is far from others, that is the one of PoseChange, and else the
  // motion bound.
  const Box<double>& coarse_bound() { return coarse_bound_ ? *coarse_bound_ : motion_bound(); }
  // Returns a box in the world around the whole body, made from the joints alone; see MotionBound. With a deformation, it is
  // around the root's ball, which has all triangles.
  const Box<double>& motion_bound() {
    if (!is_motion_bound_made_) make_motion_bound();
    return motion_bound_box_;
  }
  // What queries will need first of a body: its bound, or the boxes of nodes, since it is near, or neither, since they skin.
  enum class Need { bound, nodes, skin };
  // Says what queries of the next frame will need first, as far as is known. The begin() of that frame makes no more, and what is asked
  // for anyway is made then. Unless this is called again, frames after that one begin with the bound.
  void expect(Need need) { need_ = need; }

  // These are boxes around all vertices below: those of a wide node's children, in blocks, and that around all of them. They
  // are seen from clusters().origin(), as ClusterTraversal takes them.
  const BoxBlock<float>* wide_node_boxes(int wide_node) {
    if (!wide_nodes_made_.is_made(wide_node)) bound_wide_node(wide_node);
    return wide_node_blocks(wide_node);
  }
  const Box<float>& wide_node_box(int wide_node) {
    if (!wide_nodes_made_.is_made(wide_node)) bound_wide_node(wide_node);
    return wide_node_boxes_[wide_node];
  }

  // Returns a box around the whole body, seen likewise.
  const Box<float>& box() { return is_all_skinned() ? clusters_.box_around_all() : wide_node_box(0); }

  // Cuts the bound of a cluster that a query has skinned to its vertices' box, so that less of the other body need be skinned. From
  // several such clusters on, clusters are skinned rather than bounded. Nothing changes if the body is shared.
  void tighten(int cluster) {
    if (is_shared_ || is_all_skinned()) return;  // in the latter case, boxes are around skinned vertices already
    if (clusters_.clusters_skinned() >= least_clusters_of_contact && is_skinned_in_float()) skin_rather();
    cut_box(tree_.clusters()[cluster].place, clusters_.cluster(cluster).box);
  }
  // Says that queries of this frame may come in any order, and that its boxes must not depend on that.
  void share() { is_shared_ = true; }
  // Returns coarse_bound() of a frame that the body does not begin, by a motion bound of its way() of skinning. is_coarse says
  // whether motion_bound() would be tighter. Throws what begin does.
  Box<double> coarse_bound_of(const Pose& pose, const RigidTransform<double>& placement, MotionBound& motion_bound,
                              bool& is_coarse);
  bool is_coarse_bound_made() const { return coarse_bound_.has_value(); }
  // Says that the last coarse bound was too large.
  void give_up_coarse_bound() { pose_change_.give_up(), coarse_bound_.reset(); }
  // Remembers whether collide_all found the body's motion bound to meet another one's. It then begins the next frame for it at once.
  void set_neighbours(bool has) { has_neighbours_ = has; }
  bool has_neighbours() const { return has_neighbours_; }

  // Returns whether clusters are skinned in float, except joint-sets for which this is not known to be right.
  bool is_skinned_in_float() const { return !is_deformed_ && (skinning_ == Skinning::spherical || skinning_ == Skinning::hejl); }

  // Lets clusters be skinned rather than bounded from now on in this frame, where all children of a wide node are clusters. In
  // float this takes about as long, and boxes are tighter, also the one that the parent has of such a wide node; but more is
  // skinned where little touches.
  void skin_rather() { is_rather_skinned_ = true; }

  // Skins everything. From now on in this frame, all boxes are around skinned vertices.
  void skin_all();
  bool is_all_skinned() const { return clusters_.is_all_skinned(); }

  // Returns the clusters, as seen from where the placement puts the model's origin.
  SkinnedClusters& clusters() { return clusters_; }

  // Returns the vertices of a single triangle of the model in the world, without its cluster: the very doubles that
  // apply(placement, skin()) yields.
  TrianglePoints triangle(int triangle) { return clusters_.triangle(triangle); }

  // QueryScratch is working storage for one query at a time, so that the query need not allocate its own.
  struct QueryScratch {
    std::vector<int> hits;
    ClusterPairScratch pairs;
  };
  QueryScratch& query_scratch() { return query_scratch_; }

  // Returns how much more work was done since begin than skinning everything takes, in the unit of SkinnedClusters.
  long excess_work() const { return work_ + clusters_.work() - work_of_all(); }
  // Returns the work of skinning everything, in this unit.
  long work_of_all() const { return clusters_.work_of_all(); }

  // These counts are since begin.
  long nodes_bounded() const { return nodes_bounded_; }
  long clusters_skinned() const { return clusters_.clusters_skinned(); }
  long vertices_skinned() const { return clusters_.vertices_skinned(); }

 private:
  // Deformed has what frames of a deformed reference pose need.
  struct Deformed {
    Deformed(const Character& character, const RefitVariant& variant)
        : reference(character, variant.pieces),
          balls(character, variant) {}

    DeformedReference reference;
    FrameRefits balls;
    bool are_balls_begun = false;
  };

  const DeformedReference* deform(const Deformation& deformation);
  Box<double> box_of_deformed(int node);
  void start();
  void lose_frame();
  void make_motion_bound();
  bool place_joints();
  void set_motion_bound(const Box<double>& box);
  void bound_wide_node(int wide_node);
  void bound_in_double(int wide_node);
  double bound_in_float(const WideNode& wide_node);
  bool has_only_clusters(int wide_node) const;
  BoxBlock<float>* wide_node_blocks(int wide_node) { return &wide_node_blocks_[first_block_of_wide_node_[wide_node]]; }
  void cut_box(ChildPlace place, const Box<float>& to);
  void box_skinned(const WideNode& wide_node, BoxBlock<float>* blocks, Box<float>& whole);

  // What a body that is far from others is asked for is side by side.
  const ClusterTree& tree_;
  const WayOfSkinning& way_;
  bool has_neighbours_ = false;
  Need need_ = Need::bound;
  PoseChange pose_change_;
  const Skinning skinning_;
  MotionBound motion_bound_;
  SkinnedClusters clusters_;
  Pose pose_;
  RigidTransform<double> placement_;
  Box<double> motion_bound_box_;
  std::optional<Box<double>> coarse_bound_;
  JointFloats joints_;
  bool is_motion_bound_made_ = false, is_affine_ = false, are_joints_placed_ = false, are_floats_filled_ = false,
       is_rather_skinned_ = false, is_shared_ = false, is_deformed_ = false;
  std::optional<Deformed> deformed_;  // made when a frame first needs it
  FrameStamps wide_nodes_made_;
  std::vector<int> first_block_of_wide_node_;
  std::vector<BoxBlock<float>> wide_node_blocks_;
  std::vector<Box<float>> wide_node_boxes_;
  std::vector<FlippedBox> flipped_;  // of the wide node in work, and its boxes
  std::vector<Box<double>> boxes_;
  QueryScratch query_scratch_;
  long nodes_bounded_ = 0, work_ = 0;  // of bounds
};

}  // namespace refitlab
