// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/triangles_meet.hpp"

#include "proptests/oracles/convex_combination.hpp"

namespace proptests::oracle {

using namespace refitlab;

bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b) {
  std::vector<Row> rows;
  for (const auto& p : a)
    for (const auto& q : b) {
      Row row;
      Rational last(1);
      for (int i = 0; i < 3; ++i) row.push_back(Rational(p[i]) - Rational(q[i])), last -= row.back();
      row.push_back(last);
      rows.push_back(row);
    }
  return as_convex_combination(rows, {Rational(0), Rational(0), Rational(0), Rational(1)}).has_value();
}

}  // namespace proptests::oracle
