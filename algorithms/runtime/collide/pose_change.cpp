// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/pose_change.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/collide/pose_change_kernel.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "lemmas/b9_pose_change.hpp"

namespace refitlab {
namespace {

// Returns ||p - q||, of the sign of p that makes it less.
double distance_of_rotations(const Quaternion<double>& p, const Quaternion<double>& q) {
  return std::sqrt(std::min(squared_norm(Quaternion<double>(p - q)), squared_norm(Quaternion<double>(p + q))));
}

double share_at(double cosine) { return std::sqrt(squared_deviation_share(cosine)); }

// Returns the greatest length of a point of a box, or a little more.
double farthest_from_origin(const Box<double>& box) {
  return box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() * (1 + lost_of_motion_bound);
}

}  // namespace

PoseChange::PoseChange(const MotionBound& bound)
    : deviates_(bound.deviates()),
      most_joints_(bound.most_joints()),
      anchors_(&bound.anchors()),
      kept_(rows_of_kept_pose * anchors_->stride / Lanes<float>::count) {}

void PoseChange::start(const MotionBound& bound, const Pose& pose, const RigidTransform<double>& placement) {
  const DefaultFloatEnvironment environment;
  is_started_ = false;
  if (rests_ > 0) {
    --rests_;
    return;
  }
  const auto posed = bound.posed();
  if (!posed) return;
  pose_change_kernels(best_target())
      .keep(pose[0].rotation.data(), anchors_->joint_count, anchors_->stride, anchors_->rows(), kept_.data()->lane.data());
  posed_ = *posed;
  rotation_ = placement.rotation;
  is_started_ = true;
  boxes_ = 0;
}

std::optional<Box<double>> PoseChange::box(const Pose& pose, const RigidTransform<double>& placement, Target target) {
  const DefaultFloatEnvironment environment;
  if (!is_started_ || static_cast<int>(pose.size()) != anchors_->joint_count) return {};
  JointChange change;
  pose_change_kernels(target).compare(pose[0].rotation.data(), anchors_->joint_count, anchors_->stride, anchors_->rows(),
                                      kept_.data()->lane.data(), change);
  if (!(change.defect <= surely_rigid)) return {};
  double growth = change.moved;
  if (deviates_) {
    const double cosine = cosine_after_change(posed_.cosine, change.turned + lost_of_turn) - lost_of_cosine;
    if (!(cosine > 0)) return {};
    const double share = share_at(cosine) + error_share(1e-6);
    growth = has_sharp_share(cosine)
                 ? growth_of_bound<double>(growth, share_at(1 - (posed_.cosine - cosine)), posed_.spread, share, most_joints_)
                 : growth_by_change(growth, share, spread_after_change<double>(posed_.spread, most_joints_, growth));
  }
  growth =
      growth * (1 + lost_of_motion_bound) + least_length +
      lost_of_growth(most_joints_, anchors_->farthest, posed_.farthest, std::sqrt(static_cast<double>(change.squared_farthest)));
  if (!(growth < infinite)) return {};  // as for translations that are too long, or no numbers
  Box<double> out = posed_.turned;
  out.grow(growth);
  const double turned = distance_of_rotations(placement.rotation, rotation_);
  if (turned > 0) out.grow(moved_at_most(0.0, turned + lost_of_turn, farthest_from_origin(out)));
  move_box(out, placement.translation, 0);
  ++boxes_;
  return out;
}

void PoseChange::give_up() {
  if (boxes_ <= 1) rests_ = rests_after_failure;
  is_started_ = false;
}

}  // namespace refitlab
