// SPDX-License-Identifier: MIT
// Rows become columns: there are as many rows as a row has numbers. This brings a record of each lane into packs and back,
// without gathering numbers one by one.
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

// Pairs of rows, pairs of pairs, and halves change places. to has eight rows, to_stride numbers apart. They do not overlap from.
template <class T>
[[gnu::always_inline]] inline void transpose(const Row<T, 8> (&from)[8], T* to, int to_stride) {
  Row<T, 8> a[8], b[8];
#pragma GCC unroll 4
  for (int i = 0; i < 8; i += 2) {
    a[i] = __builtin_shufflevector(from[i], from[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[i + 1] = __builtin_shufflevector(from[i], from[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
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
}

// Does the same for rows that lie anywhere.
template <class T>
[[gnu::always_inline]] inline void transpose(const T* const (&from)[8], T* to, int to_stride) {
  Row<T, 8> rows[8];
  for (int i = 0; i < 8; ++i) read_row(from[i], rows[i]);
  transpose<T>(rows, to, to_stride);
}

}  // namespace refitlab
