// SPDX-License-Identifier: MIT
// MotionBound: a box that holds all of a skinned character, from the transforms of its joints alone.
//
// What a query asks first: it needs no rotation centers and no blends, and its price goes by joints and joint-sets, not
// by vertices. By b7_motion_bound a vertex v of a joint-set is within ||v - f|| + s A of the hull of the images C_k f of any
// point f, where A^2 is the sum of ||C_k f - C_l f||^2 over pairs of its joints, and s goes by the least (q_k, q_l).
// What holds for some joints holds for fewer of them: so joint-sets all of whose joints another one has share its f,
// and few groups are left.
#pragma once

#include <optional>

#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/motion_bound_packs.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

class MotionBound {
 public:
  // model and sets outlive this.
  MotionBound(const SkinnedMesh& mesh, const JointSets& sets, Skinning skinning);

  // In the world, around all that apply(placement, skin()) yields. pose and placement are rigid, as check_pose
  // has it. Infinite where nothing is known: for dual quaternions more than half a turn apart, for numbers that are not
  // finite or beyond 1e15, and for rotations that are not of unit length.
  Box<double> box(const Pose& pose, const RigidTransform<double>& placement, Target target = best_target()) {
    bool is_rigid;
    return box(pose, placement, is_rigid, target);
  }
  // The same; is_rigid says that check_pose has nothing against the pose. If not, only check_pose knows.
  Box<double> box(const Pose& pose, const RigidTransform<double>& placement, bool& is_rigid, Target target = best_target());

  // Boxes in the world around the targets of packs, in the pose and placement of the last call of box, whose result
  // was finite. scratch and out are by target. False, and out is of no use, if nothing is known of one. Not for
  // Skinning::hejl, whose rotation centers these packs do not have.
  bool boxes(std::span<const MotionBoundPiecePack> packs, const Pose& pose, const RigidTransform<double>& placement,
             std::span<FlippedBox> scratch, std::span<Box<double>> out, Target target = best_target());

 private:
  // Joint-sets within one of them.
  struct Group {
    std::vector<int> sets;    // the largest first
    Ball3<double> reference;  // around their vertices: about f, which is the rotation center for Skinning::hejl
    std::vector<int> joints;
    double to_prior;  // the farthest of their priors from f, for spherical skinning
    float radius;     // with what may be lost
  };

  std::vector<Group> make_groups() const;
  void pack();
  void move(Box<double>& box, const Point3& by) const;
  bool deviates() const;
  void add_about_centers(const Group& group, const Pose& pose, const Quaternion<double>& rotation, Box<double>& box) const;

  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const Skinning skinning_;
  const int padded_joints_;
  std::vector<Group> groups_;  // those of most joints first
  std::vector<MotionBoundPack> packs_;
  std::vector<int> others_;  // groups that have too many joints for a pack
  int most_joints_ = 1;
  bool is_bounded_ = true;
  // Of the frame in work.
  std::vector<Lanes<float>> numbers_;
  std::vector<std::uint32_t> unbounded_;
  double lost_of_joints_ = 0;
  std::optional<double> defect_;  // the largest | ||q||^2 - 1 | of the joints, once nodes are bounded
};

}  // namespace refitlab
