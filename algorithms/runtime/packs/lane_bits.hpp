// SPDX-License-Identifier: MIT
// A mask of lanes becomes bits, so that one can go through its lanes one by one.
#pragma once

#include <bit>
#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "algorithms/runtime/packs/pack.hpp"

namespace refitlab {

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
#if defined(__AVX512F__)
  // There is no branch for each lane, which nothing could foretell.
  const __m512i all =
      _mm512_add_epi32(_mm512_set1_epi32(first), _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), all));
  return std::popcount(bits);
#else
  int count = 0;
  for (; bits; bits &= bits - 1) out[count++] = first + std::countr_zero(bits);
  return count;
#endif
}

}  // namespace refitlab
