// SPDX-License-Identifier: MIT
// Pack: as many numbers as the processor handles at once, as one number type S of refitlab's templates.
//
// Lemmas, quaternions, blends and refits run in it unchanged, one case a lane, where they decide nothing: a comparison has
// an answer a lane. Its width is that of the translation unit's target (targets.hpp) unless it is given, and its type names the width, so
// that what is instantiated for one target never stands in for another's. Operations are those of the scalars, one
// rounding each: lanes of a double pack are bit-identical to doubles.
//
// Not Google's Highway (1.0.3): its vectors are no number types. They are not made of a number nor multiplied by one, masks
// have no ||, so each template would need a wrapper with all that std::experimental::simd has; and what is
// compiled for x86-64-v3 alone gets 16 bytes of them, as Highway's AVX2 asks for AES too.
#pragma once

#include <Eigen/Core>
#include <experimental/simd>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class T, int lanes = static_cast<int>(std::experimental::native_simd<T>::size())>
using Pack = std::experimental::simd<T, std::experimental::simd_abi::deduce_t<T, lanes>>;

template <class T, class Abi>
struct NumberTraits<std::experimental::simd<T, Abi>> {
  using S = std::experimental::simd<T, Abi>;
  static S square(const S& x) { return x * x; }
  static S sqrt(const S& x) { return std::experimental::sqrt(x); }
  static S max(const S& a, const S& b) { return std::experimental::max(a, b); }
  static S min(const S& a, const S& b) { return std::experimental::min(a, b); }
  static S choose(const typename S::mask_type& first, const S& a, const S& b) {
#if defined(__clang__) && defined(__AVX512F__)
    // Where libstdc++ 12's where() assigns nothing.
    return S([&](auto lane) { return first[lane] ? a[lane] : b[lane]; });
#else
    S out = b;
    where(first, out) = a;
    return out;
#endif
  }
};

}  // namespace refitlab

// Eigen's vectors of packs.
template <class T, class Abi>
struct Eigen::NumTraits<std::experimental::simd<T, Abi>> : Eigen::GenericNumTraits<std::experimental::simd<T, Abi>> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};
// Eigen aligns its arrays by EIGEN_MAX_ALIGN_BYTES at most, which may be less than a pack is aligned to: C++ forbids that
// ([dcl.align]), and Clang refuses it. Packs bring their own alignment.
template <class T, class Abi, int size>
struct Eigen::internal::compute_default_alignment<std::experimental::simd<T, Abi>, size> {
  enum { value = 0 };
};
