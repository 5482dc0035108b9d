// SPDX-License-Identifier: MIT
// A Ball is the paper's "sphere" [c, r], a solid ball {x : ||x - c|| <= r} of R^d.
//
// The paper says sphere for both the surface and the solid; here Ball is the solid, and a surface is always named so.
#pragma once

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class S, int D>
struct Ball {
  Vec<S, D> center;  // length units of the model
  S radius;          // the same; non-negative for a ball that means something
};

template <class S>
using Ball3 = Ball<S, 3>;

// ||x - c|| <= r. This is decided without a square root. A negative radius encloses nothing.
template <class S, int D>
Verdict encloses(const Ball<S, D>& ball, const Vec<S, D>& x) {
  return less_equal(S(0), ball.radius) & less_equal(squared_distance(x, ball.center), sq(ball.radius));
}

// inner is inside outer: ||c_o - c_i|| + r_i <= r_o. This is decided in squared form.
template <class S, int D>
Verdict encloses(const Ball<S, D>& outer, const Ball<S, D>& inner) {
  const S slack = outer.radius - inner.radius;
  return less_equal(S(0), slack) & less_equal(squared_distance(outer.center, inner.center), sq(slack));
}

// Returns ball (+) [0, r], the Minkowski sum with a ball about the origin.
template <class S, int D>
Ball<S, D> inflate(const Ball<S, D>& ball, const S& r) {
  return {ball.center, ball.radius + r};
}

}  // namespace refitlab
