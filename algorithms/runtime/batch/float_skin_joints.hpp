// SPDX-License-Identifier: MIT
// FloatJointSet has the formula of float_palette.hpp in any number type. It is for the kernel, and for what derives its rounding
// errors (proptests/algorithms/float_budgets.cpp).
#pragma once

#include "algorithms/runtime/batch/float_palette.hpp"
#include "algorithms/runtime/packs/targets.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

template <class S, int D>
[[gnu::always_inline]] inline Vec<S, D> broadcast(const float* numbers) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S(numbers[i]);
  return out;
}

// There is one joint-set of N joints in each lane. weight(j) is the weight of joint j + 1.
template <class S, int N>
struct FloatJointSet {
  Quaternion<S> rotation, rotation_from[N - 1];
  Vec<S, 3> center, image, image_from[N - 1];

  FloatJointSet() = default;
  explicit FloatJointSet(const FloatPaletteEntry& entry)
      : rotation(broadcast<S, 4>(entry.first)),
        center(broadcast<S, 3>(entry.center)),
        image(broadcast<S, 3>(entry.first + 4)) {
    for (int j = 0; j < N - 1; ++j)
      rotation_from[j] = broadcast<S, 4>(entry.more[j]), image_from[j] = broadcast<S, 3>(entry.more[j] + 4);
  }

  template <class Weight>
  [[gnu::always_inline]] Vec<S, 3> skin(const Vec<S, 3>& p, const Weight& weight) const {
    Quaternion<S> q = rotation;
    Vec<S, 3> c = image;
    for (int j = 0; j < N - 1; ++j) {
      const S w = weight(j);
      for (int i = 0; i < 4; ++i) q[i] = w * rotation_from[j][i] + q[i];
      for (int i = 0; i < 3; ++i) c[i] = w * image_from[j][i] + c[i];
    }
    return turn_and_add(q, p - center, c);
  }
  // Returns x turned by q, plus c.
  [[gnu::always_inline]] static Vec<S, 3> turn_and_add(const Quaternion<S>& q, const Vec<S, 3>& x, const Vec<S, 3>& c) {
    return rotation_displacement(q, S(S(2.f) / squared_norm(q)), x) + (x + c);
  }
};

template <class S>
struct FloatJointSet<S, 1> {
  Vec<S, 4> row[3];

  FloatJointSet() = default;
  explicit FloatJointSet(const FloatPaletteEntry& entry) {
    for (int i = 0; i < 3; ++i) row[i] = broadcast<S, 4>(entry.more[0] + 4 * i);
  }
  template <class Weight>
  [[gnu::always_inline]] Vec<S, 3> skin(const Vec<S, 3>& p, const Weight&) const {
    Vec<S, 3> out;
    for (int i = 0; i < 3; ++i) out[i] = row[i][0] * p[0] + (row[i][1] * p[1] + (row[i][2] * p[2] + row[i][3]));
    return out;
  }
};

}  // namespace
}  // namespace refitlab::REFITLAB_TARGET
