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

// Returns what each of several tables has at the indices of each of several packs. Tables are aligned as packs are, and
// look_up_size(count) floats of each can be read. Each index is in [0, count).
template <Table kind, std::size_t tables, std::size_t packs>
[[gnu::always_inline]] inline std::array<std::array<Pack<float>, packs>, tables> look_up(
    const std::array<const float*, tables>& table, [[maybe_unused]] int count,
    const std::array<const std::int32_t*, packs>& index) {
  std::array<std::array<Pack<float>, packs>, tables> out;
#ifdef __AVX512F__
  if constexpr (kind != Table::in_memory) {
    // found begins with the indices. Each is read modulo 32, and then is what was found, or stays as it is where a lane's index is
    // not in a part of the table.
    __m512i found[tables][packs], part_of[packs];
    for (std::size_t k = 0; k < packs; ++k) {
      const __m512i at = _mm512_loadu_si512(index[k]);
      part_of[k] = _mm512_srli_epi32(at, 5);
      for (std::size_t t = 0; t < tables; ++t) found[t][k] = at;
    }
    for (int first = 0; first < (kind == Table::of_few ? 1 : count); first += 32) {
      __mmask16 is_here[packs];
      for (std::size_t k = 0; k < packs; ++k) is_here[k] = _mm512_cmpeq_epi32_mask(part_of[k], _mm512_set1_epi32(first / 32));
      for (std::size_t t = 0; t < tables; ++t) {
        const __m512i low = _mm512_load_si512(table[t] + first), high = _mm512_load_si512(table[t] + first + 16);
        for (std::size_t k = 0; k < packs; ++k)
          found[t][k] = kind == Table::of_few ? _mm512_permutex2var_epi32(low, found[t][k], high)
                                              : _mm512_mask2_permutex2var_epi32(low, found[t][k], is_here[k], high);
      }
    }
    for (std::size_t t = 0; t < tables; ++t)
      for (std::size_t k = 0; k < packs; ++k) out[t][k] = Pack<float>(_mm512_castsi512_ps(found[t][k]));
    return out;
  }
#endif
  for (std::size_t t = 0; t < tables; ++t)
    for (std::size_t k = 0; k < packs; ++k) out[t][k] = Pack<float>([&](int lane) { return table[t][index[k][lane]]; });
  return out;
}

// Writes what a table of short integers has at a pack's indices to out. short_look_up_size(count) of it can be read.
template <Table kind>
[[gnu::always_inline]] inline void look_up(const std::uint16_t* table, [[maybe_unused]] int count, const std::int32_t* index,
                                           std::int32_t* out) {
#ifdef __AVX512BW__
  if constexpr (kind != Table::in_memory) {
    // As above, with an index in the lower half of each lane.
    __m512i found = _mm512_loadu_si512(index);
    const __m512i part_of = _mm512_srli_epi16(found, 6);
    for (int first = 0; first < count; first += 64)
      found = _mm512_mask2_permutex2var_epi16(_mm512_loadu_si512(table + first), found,
                                              _mm512_cmpeq_epi16_mask(part_of, _mm512_set1_epi16(static_cast<short>(first / 64))),
                                              _mm512_loadu_si512(table + first + 32));
    _mm512_storeu_si512(out, _mm512_and_si512(found, _mm512_set1_epi32(0xffff)));
    return;
  }
#endif
  for (int lane = 0; lane < static_cast<int>(Pack<float>::size()); ++lane) out[lane] = table[index[lane]];
}

}  // namespace refitlab
