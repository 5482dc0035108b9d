// SPDX-License-Identifier: MIT
// Rows become columns. This brings a record of each lane into packs and back, without gathering numbers one by one.
#pragma once

#include "algorithms/runtime/packs/row.hpp"

namespace refitlab {

// Row i becomes column i.
inline void transpose(Row<float, 4> (&rows)[4]) {
  using Four = Row<float, 4>;
  const Four low = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
             high = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Four low2 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5),
             high2 = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  rows[0] = __builtin_shufflevector(low, low2, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(low, low2, 2, 3, 6, 7);
  rows[2] = __builtin_shufflevector(high, high2, 0, 1, 4, 5);
  rows[3] = __builtin_shufflevector(high, high2, 2, 3, 6, 7);
}

// Records of eight floats become eight rows with a number of each record: number i of record k
// goes to to[i * to_stride + k]. read(k, i, four) reads four numbers of record k, from number i on.
template <int records, class Read>
[[gnu::always_inline]] inline void transpose_records(const Read& read, float* to, int to_stride) {
  using Four = Row<float, 4>;
  using Eight = Row<float, 8>;
  static_assert(records % 4 == 0);
  // The halves of eight records are put together as they are read, because to exchange halves of registers takes long.
  constexpr int at_once = records % 8 == 0 ? 8 : 4;
  for (int i = 0; i < 8; i += 4)
    for (int k = 0; k < records; k += at_once) {
      Four own[at_once];
      for (int r = 0; r < at_once; ++r) read(k + r, i, own[r]);
      float* const out = to + i * to_stride + k;
      if constexpr (at_once == 4) {
        transpose(own);
        for (int r = 0; r < 4; ++r) write_row(own[r], out + r * to_stride);
      } else {
        Eight rows[4];
        for (int r = 0; r < 4; ++r) rows[r] = __builtin_shufflevector(own[r], own[4 + r], 0, 1, 2, 3, 4, 5, 6, 7);
        const Eight low = __builtin_shufflevector(rows[0], rows[1], 0, 8, 1, 9, 4, 12, 5, 13),
                    high = __builtin_shufflevector(rows[0], rows[1], 2, 10, 3, 11, 6, 14, 7, 15);
        const Eight low2 = __builtin_shufflevector(rows[2], rows[3], 0, 8, 1, 9, 4, 12, 5, 13),
                    high2 = __builtin_shufflevector(rows[2], rows[3], 2, 10, 3, 11, 6, 14, 7, 15);
        write_row(__builtin_shufflevector(low, low2, 0, 1, 8, 9, 4, 5, 12, 13), out);
        write_row(__builtin_shufflevector(low, low2, 2, 3, 10, 11, 6, 7, 14, 15), out + to_stride);
        write_row(__builtin_shufflevector(high, high2, 0, 1, 8, 9, 4, 5, 12, 13), out + 2 * to_stride);
        write_row(__builtin_shufflevector(high, high2, 2, 3, 10, 11, 6, 7, 14, 15), out + 3 * to_stride);
      }
    }
}

// Eight rows of eight doubles, which lie anywhere, become columns: row i becomes column i. to has eight rows, to_stride numbers apart.
// They do not overlap from. A register has width numbers.
template <int width>
[[gnu::always_inline]] inline void transpose(const double* const (&from)[8], double* to, int to_stride) {
  if constexpr (width >= 8) {
    // Pairs of rows, pairs of pairs, and halves change places.
    Row<double, 8> rows[8], a[8], b[8];
    for (int i = 0; i < 8; ++i) read_row(from[i], rows[i]);
#pragma GCC unroll 4
    for (int i = 0; i < 8; i += 2) {
      a[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
      a[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
#pragma GCC unroll 4
    for (int i = 0; i < 6; i += i == 1 ? 3 : 1) {
      b[i] = __builtin_shufflevector(a[i], a[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      b[i + 2] = __builtin_shufflevector(a[i], a[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      write_row(__builtin_shufflevector(b[i], b[i + 4], 0, 1, 2, 3, 8, 9, 10, 11), to + i * to_stride);
      write_row(__builtin_shufflevector(b[i], b[i + 4], 4, 5, 6, 7, 12, 13, 14, 15), to + (i + 4) * to_stride);
    }
  } else {
    // GCC moves the numbers of rows that are wider than registers one by one. So two numbers of four rows become two rows of four, and
    // the halves of those are put together as they are read.
    for (int i = 0; i < 8; i += 2)
      for (int k = 0; k < 8; k += 4) {
        Row<double, 2> own[4];
        for (int r = 0; r < 4; ++r) read_row(from[k + r] + i, own[r]);
        const Row<double, 4> even = __builtin_shufflevector(own[0], own[2], 0, 1, 2, 3),
                             odd = __builtin_shufflevector(own[1], own[3], 0, 1, 2, 3);
        write_row(__builtin_shufflevector(even, odd, 0, 4, 2, 6), to + i * to_stride + k);
        write_row(__builtin_shufflevector(even, odd, 1, 5, 3, 7), to + (i + 1) * to_stride + k);
      }
  }
}

}  // namespace refitlab
