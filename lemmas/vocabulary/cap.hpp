// SPDX-License-Identifier: MIT
// A Cap is the part of a sphere surface in a half-space (paper 4.3), in the paper's second form: center, apex and angle.
//
// The angle is kept as its cosine, so that a cap is an algebraic object: {x : ||x - c|| = r, (x - c, a - c) >= r^2 cos},
// with r = ||a - c||. HalfSpace is {x : (x, d) >= D}.
#pragma once

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class S, int D>
struct HalfSpace {
  Vec<S, D> normal;  // d, pointing into the half-space; any positive length
  S offset;          // D
};

template <class S, int D>
Verdict contains(const HalfSpace<S, D>& h, const Vec<S, D>& x) {
  return less_equal(h.offset, dot(x, h.normal));
}

template <class S, int D>
struct Cap {
  Vec<S, D> center;
  Vec<S, D> apex;  // a point on the sphere's surface
  S cos_angle;     // in [-1, 1]: 1 is the apex alone, -1 the whole surface
};

template <class S, int D>
S squared_radius(const Cap<S, D>& cap) {
  return squared_distance(cap.apex, cap.center);
}

// x is on the surface and within the angle of the apex.
template <class S, int D>
Verdict contains(const Cap<S, D>& cap, const Vec<S, D>& x) {
  const S r2 = squared_radius(cap);
  const Vec<S, D> to_x = x - cap.center, to_apex = cap.apex - cap.center;
  return equal(squared_norm(to_x), r2) & less_equal(S(r2 * cap.cos_angle), dot(to_x, to_apex));
}

}  // namespace refitlab
