// SPDX-License-Identifier: GPL-3.0-or-later
// Model: a skinned mesh, and the clips that pose its joints.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

struct Clip {
  std::string name;
  double duration;                     // seconds
  std::function<Pose(double)> sample;  // at a time in [0, duration]; throws ModelError for a pose that is not rigid
  Animation animation = {};            // of the model's skeleton; without tracks where there is no skeleton
};

struct Model : SkinnedMesh {
  std::vector<Clip> clips = {};
  // How far the skin matrices M of a file, its scale s taken out, are from rotations: the largest Frobenius norm of
  // M^T M / s^2 - I over the joints and the times that were checked on loading. 0 where clips are made of rotations.
  double rigidity_defect = 0;
  // What the clips' animations move: of models from files. Its joints are the mesh's.
  BoundSkeleton skeleton = {};
};

}  // namespace refitlab
