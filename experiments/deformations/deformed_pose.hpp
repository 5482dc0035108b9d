// SPDX-License-Identifier: GPL-3.0-or-later
// A DeformedPose is a pose of joints that may scale, with weights of morph targets. A DeformedFrame is what refits take from it.
#pragma once

#include "algorithms/runtime/skinning/deformation.hpp"
#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

struct DeformedPose {
  Pose rigid;                   // of the second phase
  AffinePose scales = {};       // of the first; none where no joint scales
  AffinePose joints = {};       // the products of both, for linear skinning; none where no joint scales
  std::vector<double> weights;  // by morph target; none where none moves
};

// Returns the pose of these joints in both phases.
DeformedPose deformed_pose(const SkinnedMesh& mesh, AffinePose joints, std::vector<double> weights);

// A DeformedFrame is what a refit takes from a pose.
struct DeformedFrame {
  Deformation deformation;
  SkinningPalette<double> palette;
};

DeformedFrame frame_of(const Character& character, const DeformedPose& pose, Skinning skinning);

}  // namespace refitlab
