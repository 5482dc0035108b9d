// SPDX-License-Identifier: MIT
// Lanes are how numbers for packs lie in memory: aligned, and padded to the widest pack. They are the same for every width of a
// pack.
#pragma once

#include <array>

namespace refitlab {

template <class T>
struct alignas(64) Lanes {
  static constexpr int count = 64 / sizeof(T);
  std::array<T, count> lane;
};

// Returns how many Lanes hold so many numbers.
template <class T>
constexpr int blocks_for(int numbers) {
  return (numbers + Lanes<T>::count - 1) / Lanes<T>::count;
}

}  // namespace refitlab
