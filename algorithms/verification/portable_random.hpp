// SPDX-License-Identifier: GPL-3.0-or-later
// PortableRandom is a stream of integers that is the same on every machine. std::mt19937_64 is standardised, but its
// distributions are not.
#pragma once

#include <cstdint>
#include <random>

namespace refitlab {

class PortableRandom {
 public:
  // There is a stream for each number of a seed (the finaliser of splitmix64 spreads them).
  PortableRandom(std::uint64_t seed, std::uint64_t number) : engine_(mix(mix(seed) + number)) {}

  // Returns a number with low <= result <= high. The bias of the remainder is below 2^-50 for the small ranges in use.
  int between(int low, int high) { return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1)); }
  bool one_in(int n) { return between(1, n) == 1; }

 private:
  static std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }
  std::mt19937_64 engine_;
};

}  // namespace refitlab
