// Pack: as many numbers as the processor handles at once, as one number type S of refitlab's templates.
//
// Lemmas, quaternions, blends and refits run in it unchanged, one case a lane, where they decide nothing: a comparison has
// an answer a lane. Its width is that of the translation unit's target (see kernels.hpp), and its type names the width, so
// that what is instantiated for one target never stands in for another's. Operations are those of the scalars, one
// rounding each: lanes of a double pack are bit-identical to doubles.
#pragma once

#include <Eigen/Core>
#include <experimental/simd>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class T>
using Pack = std::experimental::native_simd<T>;

template <class T, class Abi>
struct NumberTraits<std::experimental::simd<T, Abi>> {
  using S = std::experimental::simd<T, Abi>;
  static S square(const S& x) { return x * x; }
  static S sqrt(const S& x) { return std::experimental::sqrt(x); }
  static S max(const S& a, const S& b) { return std::experimental::max(a, b); }
  static S min(const S& a, const S& b) { return std::experimental::min(a, b); }
};

// Lane by lane, the first where the mask is true.
template <class T, class Abi>
std::experimental::simd<T, Abi> choose(const std::experimental::simd_mask<T, Abi>& first, const std::experimental::simd<T, Abi>& a,
                                       const std::experimental::simd<T, Abi>& b) {
  std::experimental::simd<T, Abi> out = b;
  where(first, out) = a;
  return out;
}
template <class T, class Abi, int D>
Vec<std::experimental::simd<T, Abi>, D> choose(const std::experimental::simd_mask<T, Abi>& first,
                                               const Vec<std::experimental::simd<T, Abi>, D>& a,
                                               const Vec<std::experimental::simd<T, Abi>, D>& b) {
  Vec<std::experimental::simd<T, Abi>, D> out;
  for (int i = 0; i < D; ++i) out[i] = choose(first, a[i], b[i]);
  return out;
}

}  // namespace refitlab

// Eigen's vectors of packs.
template <class T, class Abi>
struct Eigen::NumTraits<std::experimental::simd<T, Abi>> : Eigen::GenericNumTraits<std::experimental::simd<T, Abi>> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};
