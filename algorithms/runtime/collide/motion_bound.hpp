// SPDX-License-Identifier: MIT
// MotionBound makes a box that holds all of a skinned character, from the transforms of its joints alone.
//
// A query computes it first. It needs no rotation centers and no blends, and its cost depends on the numbers of joints and
// joint-sets, not of vertices. By b7_motion_bound a vertex v of a joint-set is within ||v - f|| + s A of the hull of the
// images C_k f of any point f. Here A^2 is the sum of ||C_k f - C_l f||^2 over pairs of its joints, and s depends on the
// least (q_k, q_l). A bound for some joints also holds for fewer of them. So a joint-set whose joints are all in another
// one shares its f, and few groups are left.
#pragma once

#include <memory>
#include <optional>

#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/joint_anchors.hpp"
#include "algorithms/runtime/collide/motion_bound_packs.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

// Copies share what does not depend on the frame.
class MotionBound {
 public:
  // mesh and sets must outlive this.
  MotionBound(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning);

  // Returns a box in the world around everything that apply(placement, skin()) yields. pose and placement must be rigid, as
  // check_pose requires. The box is infinite where no bound is known: for dual quaternions more than half a turn apart, and for a
  // pose whose numbers are not finite or beyond 1e15 or whose rotations are not of unit length. Of the placement, nothing is
  // checked. Throws ModelError for a pose of the wrong length.
  Box<double> box(const Pose& pose, const RigidTransform<double>& placement, Target target = best_target()) {
    bool is_rigid;
    return box(pose, placement, is_rigid, target);
  }
  // Returns the same. is_rigid says that check_pose would accept the pose; if it is false, only check_pose can tell.
  Box<double> box(const Pose& pose, const RigidTransform<double>& placement, bool& is_rigid, Target target = best_target());
  // Returns the same for any pose. Throws ModelError for one that check_pose refuses.
  Box<double> checked_box(const Pose& pose, const RigidTransform<double>& placement);

  // Places the joints alone, for boxes() to go on from, as box does, which takes longer. Returns false if boxes() cannot. Throws
  // ModelError for a pose that check_pose refuses.
  bool place_checked(const Pose& pose, const RigidTransform<double>& placement);

  // A Posed is what PoseChange needs to know of a pose and a placement.
  struct Posed {
    Box<double> turned;     // the box, turned by the placement but not moved
    double cosine, spread;  // of all groups, c or a smaller number and the greatest A
    double farthest;        // the greatest length of a joint's translation
  };
  // Returns it for those of the last call of box, or nothing if that box was infinite, or if some group has more joints than a pack
  // takes. If some group is bounded by its rotation centers alone, the cosine is not positive.
  std::optional<Posed> posed() const;
  // The anchors of a joint are around the points f of its groups. most_joints is the most joints of any group, and deviates says
  // whether blends deviate from linear ones.
  const JointAnchors& anchors() const { return groups_->anchors; }
  int most_joints() const { return groups_->most_joints; }
  bool deviates() const { return skinning_ == Skinning::spherical || skinning_ == Skinning::dual_quaternion; }

  // Returns a box in the world around everything that apply(placement, skin()) yields, for linear skinning by affine joints. It
  // looks at all joints in double (affine_boxes.hpp). pose must be as check_pose requires; throws
  // ModelError for one of the wrong length.
  Box<double> box(const AffinePose& pose, const RigidTransform<double>& placement) const;

  // Makes boxes around the targets of packs, turned by the placement but not moved, in the pose and placement of the last call of
  // box, whose result must have been finite, or of place_checked, by the kernels of that call. They hold the targets once they are
  // grown by lost(). out is by target. If no bound is known for some target, it returns false, and out must not be used. It is not
  // for Skinning::hejl, because these packs do not have its rotation centers.
  bool boxes(std::span<const MotionBoundPiecePack> packs, const Pose& pose, std::span<FlippedBox> out);
  // Returns what rounding loses of each coordinate of these boxes, in that pose.
  double lost() const { return least_length + lost_of_joints_; }

 private:
  // A Group has joint-sets whose joints are all in one of them.
  struct Group {
    std::vector<int> sets;    // the largest first
    Ball3<double> reference;  // around their vertices; its center is f, which is the rotation center for Skinning::hejl
    Box<double> box;          // likewise around their vertices
    std::vector<int> joints;
    double to_prior;  // the farthest of their priors from f, for spherical skinning
    float radius;     // with an allowance for rounding
  };

  // These do not depend on the frame.
  struct Groups {
    std::vector<Group> all;  // those of most joints first
    std::vector<MotionBoundPack> packs;
    std::vector<int> others;  // groups that have too many joints for a pack
    JointAnchors anchors;
    int most_joints = 1;
    bool are_bounded = true;
  };

  std::vector<Group> make_groups() const;
  Groups pack(std::vector<Group> groups) const;
  JointAnchors make_anchors(const std::vector<Group>& groups) const;
  bool run(std::span<const MotionBoundPack> packs, const Pose& pose, const RigidTransform<double>& placement, bool& is_rigid,
           Target target);
  void add_about_centers(const Group& group, const Pose& pose, const Quaternion<double>& rotation, Box<double>& box) const;

  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const Skinning skinning_;
  const int padded_joints_;
  std::shared_ptr<const Groups> groups_;
  // These are the data of the current frame.
  std::vector<Lanes<float>> numbers_;  // of the placed joints, as the target's kernels keep them
  Target target_ = best_target();
  std::vector<std::uint32_t> unbounded_;
  MotionBoundBox bounds_{};
  bool is_bounded_ = false;
  double lost_of_joints_ = 0;
  std::optional<double> defect_;  // the largest | ||q||^2 - 1 | of the joints, once nodes are bounded
};

}  // namespace refitlab
