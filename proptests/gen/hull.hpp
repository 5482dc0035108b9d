// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational convex hulls of R^d with an element of each: scaled unit vectors (Lemma 2), unit vectors in a ball (Lemma 4).
#pragma once

#include "lemmas/vocabulary/squared_ball.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weights.hpp"

namespace proptests::gen {

// Holds one to four vectors with their rational lengths, and convex weights. The blend is 0 in about a tenth of the cases.
template <int D>
struct ScaledHull {
  std::vector<RationalVec<D>> vectors;
  std::vector<Rational> lengths, weights;
};
template <int D>
rc::Gen<ScaledHull<D>> scaled_hull();

// Holds one to four unit vectors, convex weights, and a ball that holds the vectors: about their mean, or about any point; as
// small as it can be, or larger.
template <int D>
struct EnclosedHull {
  refitlab::SquaredBall<Rational, D> ball;
  std::vector<RationalVec<D>> units;
  std::vector<Rational> weights;
};
template <int D>
rc::Gen<EnclosedHull<D>> enclosed_hull();

template <int D>
void showValue(const ScaledHull<D>& hull, std::ostream& out) {
  out << "vectors ";
  rc::show(hull.vectors, out);
  out << ", lengths ";
  rc::show(hull.lengths, out);
  out << ", weights ";
  rc::show(hull.weights, out);
}

template <int D>
void showValue(const EnclosedHull<D>& hull, std::ostream& out) {
  rc::show(hull.ball, out);
  out << ", unit vectors ";
  rc::show(hull.units, out);
  out << ", weights ";
  rc::show(hull.weights, out);
}

}  // namespace proptests::gen
