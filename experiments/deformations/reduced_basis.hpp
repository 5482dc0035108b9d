// SPDX-License-Identifier: GPL-3.0-or-later
// Reduced deformations: displacements of many frames as sums of a few, by principal components.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// Vertices v_0 + sum q_k d_k of reduced coordinates q. A coordinate is 1 on (quadratic) average over the frames that it was made from.
struct ReducedBasis {
  MorphTargets targets;                          // the d_k
  std::vector<std::vector<double>> coordinates;  // the q of each frame, by target
  double share;                                  // of all squared displacements of the frames, what the basis has
};

// Returns the basis of this size that has the largest share: the first left singular vectors of the matrix that has a frame's
// displacements, relative to the reference pose, in each column. displacements: by frame and vertex; at least `size` frames.
// Throws std::invalid_argument for fewer.
ReducedBasis reduced_basis(const std::vector<std::vector<Point3>>& displacements, int size);

}  // namespace refitlab
