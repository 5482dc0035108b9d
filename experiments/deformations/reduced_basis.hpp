// SPDX-License-Identifier: GPL-3.0-or-later
// A reduced deformation makes the displacements of many frames sums of a few, by principal components.
#pragma once

#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// A ReducedBasis has vertices v_0 + sum q_k d_k for reduced coordinates q. The quadratic mean of a coordinate is 1 over the
// frames from which the basis was made.
struct ReducedBasis {
  MorphTargets targets;                          // the d_k
  std::vector<std::vector<double>> coordinates;  // the q of each frame, by target
  double share;                                  // of all squared displacements of the frames, what the basis has
};

// Returns the basis of this size that has the largest share. It consists of the first left singular vectors of the matrix that
// has a frame's displacements, relative to the reference pose, in each column. displacements are by frame and vertex, of at least
// `size` frames. Throws std::invalid_argument for fewer.
ReducedBasis reduced_basis(const std::vector<std::vector<Point3>>& displacements, int size);

}  // namespace refitlab
