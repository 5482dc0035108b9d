// SPDX-License-Identifier: MIT
// A mask of lanes becomes bits, so that one can go through its lanes one by one, or keep what they have.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "algorithms/runtime/packs/pack.hpp"

namespace refitlab {

#if defined(__AVX2__) && !defined(__AVX512F__)
namespace avx2 {

// For each subset of eight lanes, this has the numbers of those in it, a byte each, the first lowest. A table is as fast as pdep
// and pext where these are fast, and they take hundreds of cycles on AMD's processors before Zen 3.
inline constexpr std::array<std::uint64_t, 256> numbers_of_lanes = [] {
  std::array<std::uint64_t, 256> numbers{};
  for (std::uint32_t bits = 0; bits < 256; ++bits)
    for (std::uint32_t rest = bits, at = 0; rest; rest &= rest - 1, at += 8)
      numbers[bits] |= static_cast<std::uint64_t>(std::countr_zero(rest)) << at;
  return numbers;
}();

// Returns the numbers of the lanes whose bits are set, of eight lanes, in the lowest lanes.
[[gnu::always_inline]] inline __m256i set_lanes(std::uint32_t bits) {
  return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<std::int64_t>(numbers_of_lanes[bits])));
}

}  // namespace avx2
#endif

// Returns the bits for a pack of floats: bit i says whether the mask holds in lane i, the first lane lowest. The other bits are
// 0.
[[gnu::always_inline]] inline std::uint32_t lane_bits(const Pack<float>::mask_type& mask) {
#if defined(__AVX512F__)
  return static_cast<std::uint16_t>(static_cast<__mmask16>(std::experimental::__data(mask)));
#elif defined(__AVX2__)
  const auto lanes = std::experimental::__data(mask);
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(lanes._M_data)));
#else
  std::uint32_t bits = 0;
  for (int lane = 0; lane < static_cast<int>(mask.size()); ++lane) bits |= static_cast<std::uint32_t>(mask[lane]) << lane;
  return bits;
#endif
}

// Writes the numbers of the lanes whose bits are set, of a pack of floats, counted from first on. Returns how many these are. out
// has room for all lanes, and what is behind those may be overwritten.
[[gnu::always_inline]] inline int write_lanes(std::uint32_t bits, std::int32_t first, std::int32_t* out) {
  // Where there are instructions for it, there is no branch for each lane, which nothing could foretell.
#if defined(__AVX512F__)
  const __m512i all =
      _mm512_add_epi32(_mm512_set1_epi32(first), _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), all));
  return std::popcount(bits);
#elif defined(__AVX2__)
  const __m256i lanes = _mm256_add_epi32(_mm256_set1_epi32(first), avx2::set_lanes(bits));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), lanes);
  return std::popcount(bits);
#else
  int count = 0;
  for (; bits; bits &= bits - 1) out[count++] = first + std::countr_zero(bits);
  return count;
#endif
}

// Does the same with the numbers that such a pack has in memory, which out may be, or come before.
template <class T>
[[gnu::always_inline]] inline int keep_lanes(std::uint32_t bits, const T* pack, T* out) {
  static_assert(sizeof(T) == 4);
#if defined(__AVX512F__)
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), _mm512_loadu_si512(pack)));
  return std::popcount(bits);
#elif defined(__AVX2__)
  const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(pack));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_permutevar8x32_epi32(all, avx2::set_lanes(bits)));
  return std::popcount(bits);
#else
  int count = 0;
  for (; bits; bits &= bits - 1) out[count++] = pack[std::countr_zero(bits)];
  return count;
#endif
}

}  // namespace refitlab
