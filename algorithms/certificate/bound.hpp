// SPDX-License-Identifier: GPL-3.0-or-later
// A Bound says how it can be proved that a ball holds all that skinning makes of a piece. It is found by exact trials.
//
// A refit's own bound is always among those tried (its axes, and its simplices halved at the same edges), so there is a bound for
// every ball that a refit proves. For balls from elsewhere (of batches, of descendants, of deformed vertices with a margin) there
// is one too if these bounds are tight enough.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algorithms/runtime/tree/refit_node.hpp"
#include "lemmas/exact/exact.hpp"

namespace refitlab {

struct Bound {
  enum class By {
    control,        // the control points of all weight vertices (b1, b2; s42 of linear blending)
    cap,            // the rotations' cap about an axis (t3, b4), spherical blending only
    all_rotations,  // the whole sphere of them (b4), spherical blending only
    reach,          // b6, dual quaternions only
    stretch,        // the control balls of all weight vertices, stretched (a1), affine joints only
    halves          // two simplices (b3): the middle of an edge stands in place of its first weight vertex, and of its second
  };
  By by;
  Quaternion<double> axis = identity_quaternion<double>();  // of cap and reach, of any length
  Vec<double, 3> center = {0, 0, 0};                        // of reach
  std::array<std::size_t, 2> edge = {0, 0};                 // of halves, whose bounds follow
  std::vector<Bound> halves = {};
  std::vector<Rational> of_joints = {},
                        of_weight_vertices = {};  // of stretch: no less than what each makes differences longer by
};

// Returns nothing if no bound that is tried proves it. All numbers are taken as exact rationals; they must be finite.
std::optional<Bound> find_bound(const RefitNode<double>& node, std::size_t piece, Skinning skinning, const Ball3<double>& ball);

}  // namespace refitlab
