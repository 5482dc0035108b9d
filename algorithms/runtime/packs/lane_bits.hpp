// SPDX-License-Identifier: MIT
// A mask of lanes becomes bits, so that one can go through its lanes one by one.
#pragma once

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

}  // namespace refitlab
