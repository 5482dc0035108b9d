// SPDX-License-Identifier: GPL-3.0-or-later
// Draws exactly skinned vertices of a refit case: its joint-sets' admissible weights, and vertices in its reference ball.
#pragma once

#include <optional>

#include "proptests/gen/refit_case.hpp"

namespace proptests::gen {

struct Sample {
  int joint_set;            // position in the case
  RationalWeights weights;  // admitted by the joint-set's bounds
  RationalVec<3> vertex;    // in the reference ball
};

using Blending = refitlab::Skinning;

// Returns the exact image of the sample, or nothing if its blend of quaternions vanishes, so that it has no rotation.
std::optional<RationalVec<3>> skinned(const RefitCase& c, const Sample& sample, Blending blending);

// Draws samples of each joint-set: a weight vertex, a point of an edge, the mean of all weight vertices, and weights made without
// the weight vertices, with the center of S, a random point of its surface and the surface's point that is carried farthest from
// far_from; and the weights that a few steps of ascent find to carry it farthest. It is to be called inside a property.
std::vector<Sample> samples(const RefitCase& c, Blending blending, const refitlab::Point3& far_from);

}  // namespace proptests::gen
