// SPDX-License-Identifier: MIT
// Three bytes of a table are looked up for each of many lanes, which have three places each, and the lanes are told apart by
// whether the three have a bit in common.
#pragma once

#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace refitlab {

// This is how many lanes there are at once. So many places can be read, however few lanes are asked for.
inline constexpr int byte_lanes = 32;

// Returns the room that a table of so many bytes needs.
constexpr int byte_table_size(int count) { return (count + 63) / 64 * 64; }

#ifdef __AVX512BW__
// Beyond this size it takes longer to go through a table in registers than to read each lane's bytes.
inline constexpr int most_bytes_in_registers = 1024;

[[gnu::always_inline]] inline std::uint32_t no_common_bit_in_registers(const std::uint8_t* table, int count,
                                                                       const std::uint16_t* const (&places)[3]) {
  __m512i found[3], part_of[3];  // as in look_up.hpp
  for (int k = 0; k < 3; ++k) found[k] = _mm512_loadu_si512(places[k]), part_of[k] = _mm512_srli_epi16(found[k], 6);
  for (int first = 0; first < count; first += 64) {
    const auto part = [&](int i) {
      return _mm512_cvtepu8_epi16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(table + first + i)));
    };
    const __m512i low = part(0), high = part(32), here = _mm512_set1_epi16(static_cast<short>(first / 64));
    for (int k = 0; k < 3; ++k)
      found[k] = _mm512_mask2_permutex2var_epi16(low, found[k], _mm512_cmpeq_epi16_mask(part_of[k], here), high);
  }
  return _mm512_testn_epi16_mask(_mm512_and_si512(found[0], found[1]), found[2]);
}
#elif defined(__AVX2__)
inline constexpr int most_bytes_in_registers = 256;  // whose places are bytes, too

[[gnu::always_inline]] inline std::uint32_t no_common_bit_in_registers(const std::uint8_t* table, int count,
                                                                       const std::uint16_t* const (&places)[3]) {
  __m256i at[3], found[3];
  for (int k = 0; k < 3; ++k) {
    const auto half = [&](int i) { return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(places[k] + i)); };
    at[k] = _mm256_permute4x64_epi64(_mm256_packus_epi16(half(0), half(16)), 0xd8);
    found[k] = _mm256_setzero_si256();
  }
  for (int first = 0; first < count; first += 16) {
    const __m256i part = _mm256_broadcastsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(table + first)));
    for (int k = 0; k < 3; ++k) {
      // A lane whose place is not among these 16 gets its highest bit set here, and so a byte that is 0.
      const __m256i among = _mm256_adds_epu8(at[k], _mm256_set1_epi8(0x70));
      found[k] = _mm256_or_si256(found[k], _mm256_shuffle_epi8(part, among));
      at[k] = _mm256_sub_epi8(at[k], _mm256_set1_epi8(16));
    }
  }
  const __m256i common = _mm256_and_si256(_mm256_and_si256(found[0], found[1]), found[2]);
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(_mm256_cmpeq_epi8(common, _mm256_setzero_si256())));
}
#endif

// Returns bits of which the lowest lanes, at most byte_lanes, count: bit i is set if table[a[i]] & table[b[i]] & table[c[i]] is 0.
// The places of lanes that are asked for are in [0, count).
[[gnu::always_inline]] inline std::uint32_t have_no_common_bit(const std::uint8_t* table, [[maybe_unused]] int count,
                                                               const std::uint16_t* a, const std::uint16_t* b,
                                                               const std::uint16_t* c, int lanes) {
#ifdef __AVX2__
  if (count <= most_bytes_in_registers) return no_common_bit_in_registers(table, count, {a, b, c});
#endif
  std::uint32_t bits = 0;
  for (int i = 0; i < lanes; ++i) bits |= static_cast<std::uint32_t>((table[a[i]] & table[b[i]] & table[c[i]]) == 0) << i;
  return bits;
}

}  // namespace refitlab
