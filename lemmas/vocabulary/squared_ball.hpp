// SPDX-License-Identifier: MIT
// A SquaredBall is a ball of R^d known by its squared radius, {x : ||x - c||^2 <= r^2}.
//
// Most radii of the paper are roots of rational numbers. Their squares are rational, so statements about such a ball
// are decided without a root. A negative squared radius encloses nothing. Where a lemma speaks of a sphere's surface,
// the same two numbers describe it: {x : ||x - c||^2 = r^2}.
#pragma once

#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

template <class S, int D>
struct SquaredBall {
  Vec<S, D> center;  // length units of the model
  S squared_radius;  // their square
};

template <class S, int D>
Verdict encloses(const SquaredBall<S, D>& ball, const Vec<S, D>& x) {
  return less_equal(squared_distance(x, ball.center), ball.squared_radius);
}

template <class S, int D>
Verdict on_surface(const SquaredBall<S, D>& ball, const Vec<S, D>& x) {
  return equal(squared_distance(x, ball.center), ball.squared_radius);
}

template <class S, int D>
SquaredBall<S, D> squared(const Ball<S, D>& ball) {
  return {ball.center, sq(ball.radius)};
}

}  // namespace refitlab
