// SPDX-License-Identifier: MIT
// Each lane reads a number of a table from a place of its own.
#pragma once

#include <cstdint>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "algorithms/runtime/packs/pack.hpp"

namespace refitlab {

// Returns how many places a table for look_up has at least. They are full registers, two at a time.
constexpr int look_up_size(int count) { return (count + 31) / 32 * 32; }

// table has look_up_size(count) floats, aligned as packs are. index is aligned likewise, and each number is in [0, count). few
// says that count is at most 32.
template <bool few>
[[gnu::always_inline]] inline Pack<float> look_up(const float* table, [[maybe_unused]] int count, const std::int32_t* index) {
#ifdef __AVX512F__
  const __m512i at = _mm512_load_si512(index);
  const auto among = [&](const float* part) {  // what at modulo 32 says
    return _mm512_permutex2var_ps(_mm512_load_ps(part), at, _mm512_load_ps(part + 16));
  };
  __m512 found = among(table);
  for (int first = 32; !few && first < count; first += 32)
    found = _mm512_mask_mov_ps(found, _mm512_cmpge_epi32_mask(at, _mm512_set1_epi32(first)), among(table + first));
  return Pack<float>(found);
#else
  return Pack<float>([&](int lane) { return table[index[lane]]; });
#endif
}

}  // namespace refitlab
