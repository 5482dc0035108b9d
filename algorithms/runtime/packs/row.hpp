// SPDX-License-Identifier: MIT
// Row: the few numbers of one record (a point, a quaternion, a ball, a box), side by side in registers.
//
// The counterpart of a pack: that has one number of as many records as the processor handles at once, a row has all numbers
// of one record, for every processor the same. So rows lie in memory that translation units for different targets
// share, which packs do not.
#pragma once

namespace refitlab {

// The vector extensions of GCC and Clang: n numbers, a power of two, with the operators of numbers, one rounding each; min_of
// and max_of take them too. A template, because an alias of T alone would lose the attribute as an argument.
template <class T, int n>
struct RowOf {
  typedef T Type __attribute__((vector_size(n * sizeof(T))));
  typedef T InArray __attribute__((vector_size(n * sizeof(T)), aligned(alignof(T))));
};
template <class T, int n>
using Row = typename RowOf<T, n>::Type;

// From and to numbers of an array, whatever that is aligned to. (How a function would return a wide row goes by the target.)
template <class Row, class T>
[[gnu::always_inline]] inline void read_row(const T* first, Row& row) {
  row = *reinterpret_cast<const typename RowOf<T, sizeof(Row) / sizeof(T)>::InArray*>(first);
}
template <class Row, class T>
[[gnu::always_inline]] inline void write_row(const Row& row, T* first) {
  *reinterpret_cast<typename RowOf<T, sizeof(Row) / sizeof(T)>::InArray*>(first) = row;
}

}  // namespace refitlab
