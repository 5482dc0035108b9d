// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the values of a counterexample: 3, -7/25, (3/5, 4/5).
//
// RapidCheck finds showValue by argument-dependent lookup, so each overload stands in its type's own namespace.
#pragma once

#include <ostream>

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/rigid.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace CGAL {
void showValue(const Gmpq& x, std::ostream& out);
}  // namespace CGAL

namespace Eigen {
template <int D>
void showValue(const Matrix<CGAL::Gmpq, D, 1>& v, std::ostream& out) {
  out << '(';
  for (int i = 0; i < v.size(); ++i) {
    if (i > 0) out << ", ";
    showValue(v[i], out);
  }
  out << ')';
}
}  // namespace Eigen

namespace refitlab {
template <int D>
void showValue(const Ball<Rational, D>& ball, std::ostream& out) {
  out << "ball of center ";
  showValue(ball.center, out);
  out << " and radius ";
  showValue(ball.radius, out);
}

template <int D>
void showValue(const SquaredBall<Rational, D>& ball, std::ostream& out) {
  out << "ball of center ";
  showValue(ball.center, out);
  out << " and squared radius ";
  showValue(ball.squared_radius, out);
}

template <int D>
void showValue(const HalfSpace<Rational, D>& h, std::ostream& out) {
  out << "half-space {x : (x, ";
  showValue(h.normal, out);
  out << ") >= ";
  showValue(h.offset, out);
  out << '}';
}

template <int D>
void showValue(const Cap<Rational, D>& cap, std::ostream& out) {
  out << "cap of center ";
  showValue(cap.center, out);
  out << ", apex ";
  showValue(cap.apex, out);
  out << " and cosine ";
  showValue(cap.cos_angle, out);
}

void showValue(const RigidTransform<Rational>& c, std::ostream& out);
}  // namespace refitlab
