// SPDX-License-Identifier: MIT
// Affine transforms x -> A x + b stand for joints that scale, shear and mirror.
#pragma once

#include <array>
#include <span>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class S>
struct AffineMap {
  std::array<Vec<S, 3>, 3> columns;  // of A
  Vec<S, 3> offset;                  // b, length units of the model
};

template <class S>
AffineMap<S> identity_map() {
  return {{Vec<S, 3>(S(1), S(0), S(0)), Vec<S, 3>(S(0), S(1), S(0)), Vec<S, 3>(S(0), S(0), S(1))}, Vec<S, 3>(S(0), S(0), S(0))};
}

template <class S>
Vec<S, 3> turned_by(const AffineMap<S>& map, const Vec<S, 3>& x) {
  return map.columns[0] * x[0] + map.columns[1] * x[1] + map.columns[2] * x[2];
}
template <class S>
Vec<S, 3> apply(const AffineMap<S>& map, const Vec<S, 3>& x) {
  return turned_by(map, x) + map.offset;
}

// Returns x -> a(b(x)).
template <class S>
AffineMap<S> compose(const AffineMap<S>& a, const AffineMap<S>& b) {
  return {{turned_by(a, b.columns[0]), turned_by(a, b.columns[1]), turned_by(a, b.columns[2])}, apply(a, b.offset)};
}

// Returns sum w_i C_i, whose image of a point is the blend of the point's images.
template <class S>
AffineMap<S> blended_map(std::span<const AffineMap<S>> maps, std::span<const S> w) {
  AffineMap<S> sum{{maps[0].columns[0] * w[0], maps[0].columns[1] * w[0], maps[0].columns[2] * w[0]}, maps[0].offset * w[0]};
  for (std::size_t i = 1; i < w.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum.columns[j] = sum.columns[j] + maps[i].columns[j] * w[i];
    sum.offset = sum.offset + maps[i].offset * w[i];
  }
  return sum;
}

// Returns sum w_i C_i v, as the blend of the images.
template <class S>
Vec<S, 3> linear_blend(std::span<const AffineMap<S>> maps, std::span<const S> w, const Vec<S, 3>& v) {
  Vec<S, 3> sum = apply(maps[0], v) * w[0];
  for (std::size_t i = 1; i < w.size(); ++i) sum = sum + apply(maps[i], v) * w[i];
  return sum;
}

template <class T, class S>
AffineMap<T> convert(const AffineMap<S>& map) {
  return {{convert<T>(map.columns[0]), convert<T>(map.columns[1]), convert<T>(map.columns[2])}, convert<T>(map.offset)};
}

}  // namespace refitlab
