// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the refits' balls without nested roots: rational centers, and radii that are a sum of two square roots.
//
// An axis of rotations that is rational up to a factor makes all of the repaired Algorithm 1 rational but for the last radius, by
// the one cap lemma and Lemma 5 in squared form. So equality is decided, where the algorithm's own nested roots are beyond exact
// arithmetic.
#pragma once

#include <optional>
#include <vector>

#include "proptests/gen/refit_case.hpp"

namespace proptests::oracle {

// The radius is the greatest sqrt(squared_distance) + sqrt(squared_radius), plus extra.
struct RootBall {
  struct MotionBound {
    gen::Rational squared_distance, squared_radius;
  };
  gen::RationalVec<3> center;
  std::vector<MotionBound> reaches;
  gen::Rational extra;
};

// Says whether the ball encloses the point, which is always decided.
bool encloses(const RootBall& ball, const gen::RationalVec<3>& point);

// Says where the balls of a list are gathered, and the quaternions of a joint-set: at their mean, or at the first of them.
enum class Gather { at_mean, at_first };

// Returns the ball of the repaired Algorithm 1, or nothing if a mean of unit quaternions is not rational up to a factor.
std::optional<RootBall> repaired_ball(const gen::RefitCase& c, Gather gather);

// Returns the ball for linear blending.
RootBall linear_ball(const gen::RefitCase& c);

}  // namespace proptests::oracle
