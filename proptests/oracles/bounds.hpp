// SPDX-License-Identifier: GPL-3.0-or-later
// Computes what the bounds of a certificate prove, in double and written anew: the least radius that each leaves to a ball.
#pragma once

#include <vector>

#include "algorithms/certificate/bound.hpp"

namespace proptests::oracle {

// Holds a piece of rigid blending: the weight vertices' quaternions, of any length, their center images or dual parts (none of
// the other), and x, the reference center minus the rotation center, if there is one. All bounds are of where x is carried,
// without the reference radius.
struct BlendsAtWeightVertices {
  std::vector<refitlab::Quaternion<double>> rotations;
  std::vector<refitlab::Vec<double, 3>> center_images;
  std::vector<refitlab::Quaternion<double>> duals;
  refitlab::Vec<double, 3> x;
};
BlendsAtWeightVertices blend_at_weight_vertices(const refitlab::PaletteEntry<double>& palette,
                                                const std::vector<std::vector<double>>& weight_vertices,
                                                const refitlab::Vec<double, 3>& p, refitlab::Skinning skinning);

// Returns the radius that a bound needs, which is infinite if it proves nothing at all.
double needed_radius(const BlendsAtWeightVertices& weight_vertices, const refitlab::Bound& bound,
                     const refitlab::Vec<double, 3>& center);

// Returns the bounds that are tried before the control points, with the axes and centers that they are to have.
std::vector<refitlab::Bound> first_tried(const BlendsAtWeightVertices& weight_vertices);

// Returns the least radius for which find_bound finds something: the best of all bounds that it is to try, halvings included.
double least_found_radius(const BlendsAtWeightVertices& weight_vertices, const refitlab::Vec<double, 3>& center, int halvings);

// Returns the radius that linear blending needs, the reference radius included.
double needed_radius_linear(const refitlab::PaletteEntry<double>& palette,
                            const std::vector<std::vector<double>>& weight_vertices, const refitlab::Ball3<double>& reference,
                            const refitlab::Vec<double, 3>& center);

}  // namespace proptests::oracle
