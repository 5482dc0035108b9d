// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/packs/transpose.hpp"

#include "proptests/harness/harness.hpp"

namespace proptests::suite_transpose {
namespace {

template <class T>
bool turns_rows_into_columns() {
  T from[8][8], to[8][11] = {};
  const T* rows[8];
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 8; ++k) from[i][k] = static_cast<T>(8 * i + k + 1);
    rows[7 - i] = from[i];
  }
  refitlab::transpose<T>(rows, &to[0][1], 11);
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 11; ++k)
      if (to[i][k] != (k == 0 || k > 8 ? 0 : from[8 - k][i])) return false;
  return true;
}

}  // namespace

PROPTEST(transpose) {
  t.example("a transposition of four rows makes the columns rows", {.number_type = "float"}, [] {
    refitlab::Row<float, 4> rows[4];
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) rows[i][k] = static_cast<float>(4 * i + k);
    refitlab::transpose(rows);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k)
        if (rows[i][k] != static_cast<float>(4 * k + i)) return false;
    return true;
  });
  t.example("eight rows from anywhere become eight columns, and nothing beside them is written", {},
            [] { return Checked(turns_rows_into_columns<float>() && turns_rows_into_columns<double>(), 2 * 64); });
}

}  // namespace proptests::suite_transpose
