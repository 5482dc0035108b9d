// SPDX-License-Identifier: GPL-3.0-or-later
// A SkinnedCrowd finds the contacts of many bodies without bounds of parts: it skins whole bodies in float, as skin_all_float does,
// and goes on with those whose boxes meet.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "algorithms/runtime/collide/cluster_pairs.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/collide/motion_bound.hpp"

namespace refitlab {

class SkinnedCrowd {
 public:
  // Which bodies are skinned.
  enum class Skinned { all, where_motion_bounds_meet };

  // tree must outlive this.
  SkinnedCrowd(const ClusterTree& tree, int count);

  // Returns what collide_all does, from a pose and a placement for each body. Throws ModelError for a pose that check_pose refuses.
  std::vector<Contact> frame(std::span<const Pose> poses, std::span<const RigidTransform<double>> placements, Skinned skinned,
                             Query query, const Workers& workers);

 private:
  // A Member is a body with what only one thread at a time may use.
  struct Member {
    explicit Member(const ClusterTree& tree) : clusters(tree, Skinning::spherical) {}

    SkinnedClusters clusters;
    ClusterPairScratch scratch;
    std::mutex in_work;
  };

  void skin(std::size_t i, const Pose& pose, const RigidTransform<double>& placement);

  const ClusterTree& tree_;
  std::vector<std::unique_ptr<Member>> members_;
  // What all bodies are asked for first is side by side.
  std::vector<Box<double>> boxes_;  // around them in the world: motion bounds, or boxes of vertices
  std::vector<char> is_skinned_;
  std::vector<MotionBound> motion_bounds_;  // each is for some bodies, one after the other
};

}  // namespace refitlab
