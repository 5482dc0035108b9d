// SPDX-License-Identifier: MIT
// Each lane reads a number of a table from a place of its own.
#pragma once

#include <array>
#include <cstdint>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "algorithms/runtime/packs/pack.hpp"

namespace refitlab {

// Returns how many places a table for look_up has at least. They are full registers, two at a time.
constexpr int look_up_size(int count) { return (count + 31) / 32 * 32; }
constexpr int short_look_up_size(int count) { return (count + 63) / 64 * 64; }  // of short integers

// A Table is of at most 32 numbers, or of so few that it is faster to go through it in registers than to read each lane's number,
// or any.
enum class Table { of_few, in_registers, in_memory };
inline constexpr int most_in_registers = 512;

// Returns what a table has at the indices of n packs. The table is aligned as packs are, and look_up_size(count) floats of it can be
// read. Each index is in [0, count).
template <Table kind, std::size_t n>
[[gnu::always_inline]] inline std::array<Pack<float>, n> look_up(const float* table, [[maybe_unused]] int count,
                                                                 const std::array<const std::int32_t*, n>& index) {
  std::array<Pack<float>, n> out;
#ifdef __AVX512F__
  if constexpr (kind != Table::in_memory) {
    __m512i at[n];
    __m512 found[n];
    for (std::size_t k = 0; k < n; ++k) at[k] = _mm512_loadu_si512(index[k]);
    const auto take = [&](const float* part, const auto& put) {
      const __m512 low = _mm512_load_ps(part), high = _mm512_load_ps(part + 16);
      for (std::size_t k = 0; k < n; ++k) put(k, _mm512_permutex2var_ps(low, at[k], high));  // what at modulo 32 says
    };
    take(table, [&](std::size_t k, __m512 among) { found[k] = among; });
    for (int first = 32; kind != Table::of_few && first < count; first += 32)
      take(table + first, [&](std::size_t k, __m512 among) {
        found[k] = _mm512_mask_mov_ps(found[k], _mm512_cmpge_epi32_mask(at[k], _mm512_set1_epi32(first)), among);
      });
    for (std::size_t k = 0; k < n; ++k) out[k] = Pack<float>(found[k]);
    return out;
  }
#endif
  for (std::size_t k = 0; k < n; ++k) out[k] = Pack<float>([&](int lane) { return table[index[k][lane]]; });
  return out;
}
template <Table kind>
[[gnu::always_inline]] inline Pack<float> look_up(const float* table, int count, const std::int32_t* index) {
  return look_up<kind, 1>(table, count, {index})[0];
}

// Writes what a table of short integers has at a pack's indices to out. short_look_up_size(count) of it can be read.
template <Table kind>
[[gnu::always_inline]] inline void look_up(const std::uint16_t* table, [[maybe_unused]] int count, const std::int32_t* index,
                                           std::int32_t* out) {
#ifdef __AVX512BW__
  if constexpr (kind != Table::in_memory) {
    const __m512i at = _mm512_loadu_si512(index);
    const auto among = [&](const std::uint16_t* part) {  // what at modulo 64 says, in the lower half of each lane
      return _mm512_permutex2var_epi16(_mm512_loadu_si512(part), at, _mm512_loadu_si512(part + 32));
    };
    __m512i found = among(table);
    for (int first = 64; kind != Table::of_few && first < count; first += 64)
      found = _mm512_mask_mov_epi32(found, _mm512_cmpge_epi32_mask(at, _mm512_set1_epi32(first)), among(table + first));
    _mm512_storeu_si512(out, _mm512_and_si512(found, _mm512_set1_epi32(0xffff)));
    return;
  }
#endif
  for (int lane = 0; lane < static_cast<int>(Pack<float>::size()); ++lane) out[lane] = table[index[lane]];
}

}  // namespace refitlab
