// SPDX-License-Identifier: MIT
// A Pack is as many numbers as the processor handles at once. It is a number type S for refitlab's templates.
//
// Lemmas, quaternions, blends and refits run in it unchanged, one case a lane, as long as they decide nothing, because a
// comparison has an answer for each lane. Its width is that of the translation unit's target (targets.hpp) unless it is given,
// and its type names the width, so that a template for one target never stands in for another's. Operations are those of the
// scalars, with one rounding each, so that lanes of a double pack are bit-identical to doubles.
//
// Google's Highway (1.0.3) is not used, because its vectors are no number types. They are not made of a number nor multiplied by
// one, and masks have no ||. So each template would need a wrapper with all that std::experimental::simd has. And code for
// x86-64-v3 alone gets vectors of 16 bytes, as Highway's AVX2 asks for AES too.
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
  using Lane = T;
  static S square(const S& x) { return x * x; }
  static S sqrt(const S& x) { return std::experimental::sqrt(x); }
  static S max(const S& a, const S& b) { return std::experimental::max(a, b); }
  static S min(const S& a, const S& b) { return std::experimental::min(a, b); }
  static S absolute(const S& x) { return std::experimental::abs(x); }
  static S choose(const typename S::mask_type& first, const S& a, const S& b) {
#if defined(__clang__) && defined(__AVX512F__)
    // This is for targets on which libstdc++ 12's where() assigns nothing.
    return S([&](auto lane) { return first[lane] ? a[lane] : b[lane]; });
#else
    S out = b;
    where(first, out) = a;
    return out;
#endif
  }
};

}  // namespace refitlab

// This lets Eigen have vectors of packs.
template <class T, class Abi>
struct Eigen::NumTraits<std::experimental::simd<T, Abi>> : Eigen::GenericNumTraits<std::experimental::simd<T, Abi>> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};
// Eigen aligns its arrays by EIGEN_MAX_ALIGN_BYTES at most, which may be less than a pack's alignment. C++ forbids that
// ([dcl.align]), and Clang refuses it. Packs bring their own alignment.
template <class T, class Abi, int size>
struct Eigen::internal::compute_default_alignment<std::experimental::simd<T, Abi>, size> {
  enum { value = 0 };
};
