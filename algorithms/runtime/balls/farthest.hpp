// SPDX-License-Identifier: MIT
// Farthest finds the greatest of some numbers that belong to points. It takes two points at a time.
#pragma once

#include <cstdint>
#include <type_traits>

#include "algorithms/runtime/balls/quad.hpp"

namespace refitlab {

// Two points are stored coordinate by coordinate.
template <class S, int D>
struct TwoPoints {
  Row<S, 2> row[D];
};

template <class S, int D>
TwoPoints<S, D> two_points(const Vec<S, D>& a, const Vec<S, D>& b) {
  if constexpr (D == 3) return {{Row<S, 2>{a[0], b[0]}, Row<S, 2>{a[1], b[1]}, Row<S, 2>{a[2], b[2]}}};
  else return {{Row<S, 2>{a[0], b[0]}, Row<S, 2>{a[1], b[1]}, Row<S, 2>{a[2], b[2]}, Row<S, 2>{a[3], b[3]}}};
}

template <int D, class S>
TwoPoints<S, D> same_point_twice(const Quad<S>& p) {
  const auto both = [&](int i) { return Row<S, 2>{p[i], p[i]}; };
  if constexpr (D == 3) return {{both(0), both(1), both(2)}};
  else return {{both(0), both(1), both(2), both(3)}};
}

// Returns to the last bit what squared_distance of vector.hpp computes.
template <class S, int D>
Row<S, 2> squared_distances(const TwoPoints<S, D>& a, const TwoPoints<S, D>& b) {
  const Row<S, 2> x = a.row[0] - b.row[0], y = a.row[1] - b.row[1], z = a.row[2] - b.row[2];
  Row<S, 2> sum = x * x + y * y + z * z;
  if constexpr (D == 4) {
    const Row<S, 2> w = a.row[3] - b.row[3];
    sum += w * w;
  }
  return sum;
}

// The numbers are not negative. There are at most `most`, which is a power of two.
template <class S, int most>
class Farthest {
 public:
  void see(const Row<S, 2>& values) {
    const Row<Int, 2> key = ((Row<Int, 2>)values & ~index_bits) | next_;
    greatest_ = greatest_ < values ? values : greatest_;
    // The keys are chosen as integers. A maximum of two floating-point numbers is 0 if the processor takes both for zeros, and
    // keeps no index.
    const Row<Int, 2> is_greater = (Row<S, 2>)greatest_key_ < (Row<S, 2>)key;
    greatest_key_ = (is_greater & key) | (~is_greater & greatest_key_);
    next_ -= Int(2);
  }
  S value() const { return max_of(S(greatest_[0]), S(greatest_[1])); }
  // Returns the index of the greatest number, or of another that differs only in its last bits. Among equal numbers it is the
  // smallest index. The index is one that was seen, whatever the numbers were: NaNs, or keys that the processor takes for zeros,
  // leave the first one.
  int index() const {
    const Int greatest = greatest_key_[0] < greatest_key_[1] ? greatest_key_[1] : greatest_key_[0];
    return most - 1 - static_cast<int>(greatest & Int(most - 1));
  }

 private:
  // Non-negative numbers are in the order of their bits; the last bits of a key are the index, counted down.
  using Int = std::conditional_t<sizeof(S) == 8, std::int64_t, std::int32_t>;
  static_assert((most & (most - 1)) == 0);
  static constexpr Row<Int, 2> index_bits{most - 1, most - 1};
  Row<Int, 2> next_{most - 1, most - 2}, greatest_key_ = next_;
  Row<S, 2> greatest_{};
};

}  // namespace refitlab
