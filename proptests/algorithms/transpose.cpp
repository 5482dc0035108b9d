// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/packs/transpose.hpp"

#include "proptests/harness/harness.hpp"

namespace proptests::suite_transpose {
namespace {

using namespace refitlab;

template <int width>
bool doubles_turn() {
  double from[8][8], to[8][11] = {};
  const double* rows[8];
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 8; ++k) from[i][k] = 8 * i + k + 1;
    rows[7 - i] = from[i];
  }
  transpose<width>(rows, &to[0][1], 11);
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 11; ++k)
      if (to[i][k] != (k == 0 || k > 8 ? 0 : from[8 - k][i])) return false;
  return true;
}

template <int records>
bool records_turn() {
  float from[records][8], to[8][records + 3] = {};
  for (int k = 0; k < records; ++k)
    for (int i = 0; i < 8; ++i) from[k][i] = static_cast<float>(8 * k + i + 1);
  const auto read = [&](int k, int i, Row<float, 4>& four) { read_row(from[records - 1 - k] + i, four); };
  transpose_records<records>(read, &to[0][1], records + 3);
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < records + 3; ++k)
      if (to[i][k] != (k == 0 || k > records ? 0 : from[records - k][i])) return false;
  return true;
}

}  // namespace

PROPTEST(transpose) {
  t.example("a transposition of four rows makes the columns rows", {.number_type = "float"}, [] {
    Row<float, 4> rows[4];
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) rows[i][k] = static_cast<float>(4 * i + k);
    transpose(rows);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k)
        if (rows[i][k] != static_cast<float>(4 * k + i)) return false;
    return true;
  });
  t.example(
      "eight rows of doubles from anywhere become eight columns, by registers of any width, and nothing beside them is written",
      {}, [] { return Checked(doubles_turn<2>() && doubles_turn<4>() && doubles_turn<8>(), 3 * 64); });
  t.example("so do records of eight floats, in any number that packs have lanes", {.number_type = "float"},
            [] { return Checked(records_turn<4>() && records_turn<8>() && records_turn<16>(), 8 * (4 + 8 + 16)); });
  t.example("doubles are read as the floats next to them", {}, [] {
    const double doubles[] = {1, -2.5, 1 + 0x1p-25, 1e-60, 7};
    Row<float, 4> row;
    read_floats(doubles + 1, row);
    return row[0] == -2.5f && row[1] == 1 && row[2] == 0 && row[3] == 7;
  });
}

}  // namespace proptests::suite_transpose
