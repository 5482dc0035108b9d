// bound_rotations (lemmas/rotation_bound.hpp) in packs: where that returns early, lanes are selected.
#pragma once

#include "algorithms/runtime/packs/pack.hpp"
#include "lemmas/rotation_bound.hpp"

namespace refitlab {

// As bound_rotations, lane by lane. Lanes whose unit quaternions are not numbers get all rotations.
template <class T, class Abi>
RotationBound<std::experimental::simd<T, Abi>> bound_rotations_packs(
    std::span<const Quaternion<std::experimental::simd<T, Abi>>> unit,
    const Quaternion<std::experimental::simd<T, Abi>>& direction) {
  using S = std::experimental::simd<T, Abi>;
  const Quaternion<S> apex = direction * (S(1) / root(squared_norm(direction)));
  const S s2 = squared_half_chord(unit, apex);
  RotationBound<S> bound = bound_of_cap(apex, s2);
  const RotationBound<S> any = all_rotations<S>();
  const auto is_any = !(s2 < S(T(0.5)));  // true for a NaN
  where(is_any, bound.center_ratio) = any.center_ratio;
  where(is_any, bound.radius_ratio) = any.radius_ratio;
  for (int i = 0; i < 4; ++i) where(is_any, bound.apex[i]) = any.apex[i];
  return bound;
}

}  // namespace refitlab
