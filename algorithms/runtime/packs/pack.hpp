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
  static S choose(const typename S::mask_type& first, const S& a, const S& b) {
    S out = b;
    where(first, out) = a;
    return out;
  }
};

}  // namespace refitlab

// Eigen's vectors of packs.
template <class T, class Abi>
struct Eigen::NumTraits<std::experimental::simd<T, Abi>> : Eigen::GenericNumTraits<std::experimental::simd<T, Abi>> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};
