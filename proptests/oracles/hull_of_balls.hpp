// SPDX-License-Identifier: GPL-3.0-or-later
// Asks along one direction whether a point is in the convex hull of balls: the best direction that a search in double finds.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/model/model.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace proptests::oracle {

// Returns the direction from the hull's point nearest to v towards v, in double [Gilbert 1966]. If v is outside, this direction
// shows it.
inline refitlab::Point3 direction_away(const std::vector<refitlab::Ball3<double>>& balls, const refitlab::Point3& v) {
  using refitlab::Point3;
  Point3 nearest = balls[0].center;
  for (int step = 0; step < 60; ++step) {
    const Point3 d = v - nearest;
    const refitlab::Ball3<double>* best = &balls[0];
    for (const auto& b : balls)
      if (b.center.dot(d) + b.radius * d.norm() > best->center.dot(d) + best->radius * d.norm()) best = &b;
    const Point3 edge = best->center - nearest;
    if (edge.squaredNorm() < 1e-28) break;
    nearest += edge * std::clamp(edge.dot(d) / edge.squaredNorm(), 0.0, 1.0);
  }
  return v - nearest;
}

// Judges whether (v, d) <= max over the balls of (center, d) + radius ||d||.
template <class S>
refitlab::Verdict reaches(const std::vector<refitlab::Ball3<S>>& balls, const refitlab::Vec<S, 3>& v,
                          const refitlab::Vec<S, 3>& d) {
  using namespace refitlab;
  Verdict any = Verdict::fails;
  const S length = squared_norm(d);
  for (const auto& b : balls) {
    const S beyond = dot<S, 3>(v - b.center, d);
    any |= less_equal(beyond, S(0)) | less_equal(sq(beyond), S(sq(b.radius) * length));
  }
  return any;
}

}  // namespace proptests::oracle
