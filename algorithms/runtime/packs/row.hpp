// SPDX-License-Identifier: MIT
// A Row has the few numbers of one record (a point, a quaternion, a ball, a box) side by side in registers.
//
// It is the counterpart of a pack. A pack has one number of as many records as the processor handles at once. A row has all
// numbers of one record, and is the same for every processor. So rows lie in memory that translation units for different targets
// share, which packs do not.
#pragma once

namespace refitlab {

// These are the vector extensions of GCC and Clang. There are n numbers, a power of two, with the operators of numbers and one
// rounding each. min_of and max_of take them too. This is a template, because an alias of T alone would lose the attribute as an
// argument.
template <class T, int n>
struct RowOf {
  typedef T Type __attribute__((vector_size(n * sizeof(T))));
  typedef T InArray __attribute__((vector_size(n * sizeof(T)), aligned(alignof(T))));
};
template <class T, int n>
using Row = typename RowOf<T, n>::Type;

// These copy numbers from and to an array of any alignment. (They return nothing, because how a function returns a wide row
// depends on the target.)
template <class Row, class T>
[[gnu::always_inline]] inline void read_row(const T* first, Row& row) {
  row = *reinterpret_cast<const typename RowOf<T, sizeof(Row) / sizeof(T)>::InArray*>(first);
}
template <class Row, class T>
[[gnu::always_inline]] inline void write_row(const Row& row, T* first) {
  *reinterpret_cast<typename RowOf<T, sizeof(Row) / sizeof(T)>::InArray*>(first) = row;
}

// Reads four doubles and rounds them.
[[gnu::always_inline]] inline void read_floats(const double* first, Row<float, 4>& row) {
  Row<double, 4> doubles;
  read_row(first, doubles);
  row = __builtin_convertvector(doubles, decltype(row + row));  // that of row alone is a reference
}

}  // namespace refitlab
