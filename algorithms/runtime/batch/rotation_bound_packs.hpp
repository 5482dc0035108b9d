// SPDX-License-Identifier: MIT
// This is bound_rotations (lemmas/rotation_bound.hpp) in packs. Where that returns early, lanes are selected.
#pragma once

#include "algorithms/runtime/packs/pack.hpp"
#include "lemmas/lemma4_quaternion_hull.hpp"
#include "lemmas/rotation_bound.hpp"

namespace refitlab {

// Does what bound_rotations does, lane by lane. Lanes whose unit quaternions are not numbers get all rotations.
template <class T, class Abi>
RotationBound<std::experimental::simd<T, Abi>> bound_rotations_packs(
    std::span<const Quaternion<std::experimental::simd<T, Abi>>> unit,
    const Quaternion<std::experimental::simd<T, Abi>>& direction) {
  using S = std::experimental::simd<T, Abi>;
  const Quaternion<S> apex = direction * (S(1) / root(squared_norm(direction)));
  const S s2 = squared_half_chord(unit, apex);
  RotationBound<S> bound = bound_of_cap(apex, s2);
  const RotationBound<S> any = all_rotations<S>();
  const auto is_any = !(s2 < S(T(squared_half_chord_of_half_sphere)));  // true for a NaN
  bound.center_ratio = choose(is_any, any.center_ratio, bound.center_ratio);
  bound.radius_ratio = choose(is_any, any.radius_ratio, bound.radius_ratio);
  bound.apex = choose(is_any, any.apex, bound.apex);
  return bound;
}

}  // namespace refitlab
