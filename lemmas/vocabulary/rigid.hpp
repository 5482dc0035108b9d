// SPDX-License-Identifier: MIT
// The rigid transform C_j maps x -> R(rotation) x + translation, from the reference pose to the animated one (paper 3).
#pragma once

#include <span>
#include <vector>

#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab {

template <class S>
struct RigidTransform {
  Quaternion<S> rotation = identity_quaternion<S>();  // of unit length; its sign is the skinning's
  Vec<S, 3> translation = {S(0), S(0), S(0)};         // length units of the model
};

template <class S>
Vec<S, 3> apply(const RigidTransform<S>& c, const Vec<S, 3>& x) {
  const Vec<S, 3> turned = rotate(c.rotation, x);
  return turned + c.translation;
}

// Returns the images of one point by several transforms.
template <class S>
std::vector<Vec<S, 3>> images_of(std::span<const RigidTransform<S>> transforms, const Vec<S, 3>& point) {
  std::vector<Vec<S, 3>> images;
  for (const auto& c : transforms) images.push_back(apply(c, point));
  return images;
}

// Returns x -> a(b(x)).
template <class S>
RigidTransform<S> compose(const RigidTransform<S>& a, const RigidTransform<S>& b) {
  return {multiply(a.rotation, b.rotation), apply(a, b.translation)};
}

template <class S>
RigidTransform<S> inverse(const RigidTransform<S>& a) {
  const Quaternion<S> back = conjugate(a.rotation);
  return {back, -rotate(back, a.translation)};
}

}  // namespace refitlab
