// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the vertices of a polytope given by half-spaces, by trying every three planes: slow, obvious, exact.
#pragma once

#include <vector>

#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/cap.hpp"

namespace proptests::oracle {

using HalfSpaces = std::vector<refitlab::HalfSpace<refitlab::Rational, 3>>;

// Returns each vertex as often as three planes meet in it. It is empty only if the polytope, which is bounded, is.
inline std::vector<refitlab::Vec<refitlab::Rational, 3>> vertices(const HalfSpaces& polytope) {
  using namespace refitlab;
  std::vector<Vec<Rational, 3>> out;
  for (std::size_t i = 0; i < polytope.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const auto &a = polytope[i], &b = polytope[j], &c = polytope[k];
        const Vec<Rational, 3> bc = cross(b.normal, c.normal);
        const Rational determinant = dot(a.normal, bc);
        if (determinant == 0) continue;
        const Vec<Rational, 3> x =
            (bc * a.offset + cross(c.normal, a.normal) * b.offset + cross(a.normal, b.normal) * c.offset) / determinant;
        Verdict inside = Verdict::holds;
        for (const auto& h : polytope) inside &= contains(h, x);
        if (inside == Verdict::holds) out.push_back(x);
      }
  return out;
}

}  // namespace proptests::oracle
