// The greatest of numbers that belong to points, looked for two points at a time.
#pragma once

#include <cstdint>
#include <type_traits>

#include "algorithms/runtime/balls/quad.hpp"

namespace refitlab {

// Two points, coordinate by coordinate.
template <class S, int D>
struct TwoPoints {
  Pair<S> row[D];
};

template <class S, int D>
TwoPoints<S, D> two_points(const Vec<S, D>& a, const Vec<S, D>& b) {
  if constexpr (D == 3)
    return {{Pair<S>{a[0], b[0]}, Pair<S>{a[1], b[1]}, Pair<S>{a[2], b[2]}}};
  else
    return {{Pair<S>{a[0], b[0]}, Pair<S>{a[1], b[1]}, Pair<S>{a[2], b[2]}, Pair<S>{a[3], b[3]}}};
}

template <int D, class S>
TwoPoints<S, D> same_point_twice(const Quad<S>& p) {
  if constexpr (D == 3)
    return {{both(p[0]), both(p[1]), both(p[2])}};
  else
    return {{both(p[0]), both(p[1]), both(p[2]), both(p[3])}};
}

// To the last bit what squared_distance of vector.hpp computes.
template <class S, int D>
Pair<S> squared_distances(const TwoPoints<S, D>& a, const TwoPoints<S, D>& b) {
  const Pair<S> x = a.row[0] - b.row[0], y = a.row[1] - b.row[1], z = a.row[2] - b.row[2];
  Pair<S> sum = x * x + y * y + z * z;
  if constexpr (D == 4) {
    const Pair<S> w = a.row[3] - b.row[3];
    sum += w * w;
  }
  return sum;
}

// Of at most so many non-negative numbers, a power of two.
template <class S, int most>
class Farthest {
 public:
  void see(const Pair<S>& values) {
    const Pair<Int> key = ((Pair<Int>)values & ~index_bits) | next_;
    greatest_ = greatest_ < values ? values : greatest_;
    // Chosen as integers: a maximum of two numbers is 0 where the processor takes both for zeros, and keeps no index.
    const Pair<Int> is_greater = (Pair<S>)greatest_key_ < (Pair<S>)key;
    greatest_key_ = (is_greater & key) | (~is_greater & greatest_key_);
    next_ -= Int(2);
  }
  S value() const { return max_of(S(greatest_[0]), S(greatest_[1])); }
  // Its index, or that of another that differs only in its last bits; the smallest index of equal ones. Of what was seen,
  // whatever the numbers were: NaNs, or keys that the processor takes for zeros, leave the first one.
  int index() const {
    const Int greatest = greatest_key_[0] < greatest_key_[1] ? greatest_key_[1] : greatest_key_[0];
    return most - 1 - static_cast<int>(greatest & Int(most - 1));
  }

 private:
  // Non-negative numbers are in the order of their bits; the last bits of a key are the index, counted down.
  using Int = std::conditional_t<sizeof(S) == 8, std::int64_t, std::int32_t>;
  static_assert((most & (most - 1)) == 0);
  static constexpr Pair<Int> index_bits{most - 1, most - 1};
  Pair<Int> next_{most - 1, most - 2}, greatest_key_ = next_;
  Pair<S> greatest_{};
};

}  // namespace refitlab
