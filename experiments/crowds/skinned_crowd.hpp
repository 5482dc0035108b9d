// SPDX-License-Identifier: GPL-3.0-or-later
// A SkinnedCrowd finds the contacts of many bodies without bounds of parts: it skins whole bodies in float, as skin_all_float does,
// and goes on with those whose boxes meet.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/collide/motion_bound.hpp"
#include "experiments/baselines/skinned_body.hpp"

namespace refitlab {

class SkinnedCrowd {
 public:
  // Which bodies are skinned.
  enum class Skinned { all, where_motion_bounds_meet };

  // tree must outlive this.
  SkinnedCrowd(const ClusterTree& tree, int count);

  // Returns what collide_all does, from poses and placements.
  std::vector<Contact> frame(std::span<const Pose> poses, std::span<const RigidTransform<double>> placements, Skinned skinned);

 private:
  void skin(int body, const Pose& pose, const RigidTransform<double>& placement);
  Box<double> box(int body) const;

  const ClusterTree& tree_;
  MotionBound motion_bound_;
  std::vector<std::unique_ptr<SkinnedBody>> bodies_;
  std::vector<Box<double>> boxes_;
  std::vector<bool> is_skinned_;
  ClusterPairScratch scratch_;
  std::vector<int> hits_;
};

}  // namespace refitlab
