// SPDX-License-Identifier: MIT
// These are the directions of k-DOPs, which are bounded by k/2 pairs of parallel planes of fixed directions [Klosowski et al.
// 1998, "Efficient collision detection using bounding volume hierarchies of k-DOPs"].
//
// They are integer vectors that are not normalised, so that all but the length of a direction is rational.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

using SlabDirection = std::array<int, 3>;  // of -1, 0, 1; the first that is not 0 is 1

constexpr int squared_length(const SlabDirection& d) { return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; }

// Returns a double that is not below ||d||, and at most 2e-16 above it. So radii grow and never shrink, in any number type.
constexpr double length_bound(const SlabDirection& d) {
  return std::array{1.0, 1.4142135623730951, 1.7320508075688774}[squared_length(d) - 1];
}

// Returns one of each pair of opposite directions. For k = 6 they are the axes, for 14 also the cube's corners, for 18 the axes
// and the cube's edges, and for 26 all of them. The axes x, y, z come first.
template <int k>
constexpr std::array<SlabDirection, k / 2> slab_directions() {
  static_assert(k == 6 || k == 14 || k == 18 || k == 26);
  std::array<SlabDirection, k / 2> out{};
  std::size_t count = 0;
  for (int length = 1; length <= 3; ++length) {
    if ((length == 2 && k != 18 && k != 26) || (length == 3 && k != 14 && k != 26)) continue;
    for (int code = 26; code > 13; --code) {  // whose digits to the base 3 are d + 1
      const SlabDirection d{code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1};
      if (squared_length(d) == length) out[count++] = d;
    }
  }
  return out;
}

// Returns (x, d) by additions alone.
template <SlabDirection d, class S>
S along(const Vec<S, 3>& x) {
  constexpr int first = d[0] ? 0 : d[1] ? 1 : 2;
  S sum = x[first];
  for (int i = first + 1; i < 3; ++i)
    if (d[i] != 0) sum = d[i] > 0 ? S(sum + x[i]) : S(sum - x[i]);
  return sum;
}

inline constexpr std::array<int, 4> dop_sizes = {6, 14, 18, 26};
constexpr bool is_dop_size(int k) { return std::find(dop_sizes.begin(), dop_sizes.end(), k) != dop_sizes.end(); }
// Returns slab_directions<k>() for a k that is known at run time and one of dop_sizes.
inline std::span<const SlabDirection> slab_directions(int k) {
  static constexpr auto of_14 = slab_directions<14>();
  static constexpr auto of_18 = slab_directions<18>();
  static constexpr auto of_26 = slab_directions<26>();
  if (k == 14) return of_14;
  if (k == 18) return of_18;
  return std::span(of_26).first(k == 26 ? 13 : 3);
}

}  // namespace refitlab
