// Eight rows of eight numbers to eight columns: what brings a record a lane into packs, and back, without gathering
// numbers one by one.
#pragma once

namespace refitlab {

template <class T>
struct EightOf;
template <>
struct EightOf<float> {
  typedef float Row __attribute__((vector_size(32), aligned(4)));
};
template <>
struct EightOf<double> {
  typedef double Row __attribute__((vector_size(64), aligned(8)));
};

// Pairs of rows, pairs of pairs, and halves change places.
// to: eight rows, to_stride numbers apart, none of them one of from.
template <class T>
[[gnu::always_inline]] inline void transpose(const typename EightOf<T>::Row (&from)[8], T* to, int to_stride) {
  using Row = typename EightOf<T>::Row;
  Row a[8], b[8];
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
    *reinterpret_cast<Row*>(to + i * to_stride) = __builtin_shufflevector(b[i], b[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    *reinterpret_cast<Row*>(to + (i + 4) * to_stride) =
        __builtin_shufflevector(b[i], b[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

// The rows wherever they lie.
template <class T>
[[gnu::always_inline]] inline void transpose(const T* const (&from)[8], T* to, int to_stride) {
  using Row = typename EightOf<T>::Row;
  Row rows[8];
  for (int i = 0; i < 8; ++i) rows[i] = *reinterpret_cast<const Row*>(from[i]);
  transpose<T>(rows, to, to_stride);
}

}  // namespace refitlab
