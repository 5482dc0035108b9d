// bound_rotations (algorithms/refit/rotation_bound.hpp) in packs: where that returns early, lanes are selected.
#pragma once

#include "algorithms/packs/pack.hpp"
#include "algorithms/refit/rotation_bound.hpp"

namespace refitlab {

// As bound_rotations, lane by lane. Lanes whose unit quaternions are not numbers get all rotations.
template <class T, class Abi>
RotationBound<std::experimental::simd<T, Abi>> bound_rotations_packs(
    std::span<const Quaternion<std::experimental::simd<T, Abi>>> unit,
    const Quaternion<std::experimental::simd<T, Abi>>& direction) {
  using S = std::experimental::simd<T, Abi>;
  RotationBound<S> bound{direction * (S(1) / root(squared_norm(direction))), S(0), S(0)};
  S s2 = squared_distance(unit[0], bound.apex);
  for (const Quaternion<S>& q : unit.subspan(1)) s2 = max_of(s2, squared_distance(q, bound.apex));
  s2 = s2 / S(4);
  const S one_minus_cos = std::experimental::min(S(8) * s2 * (S(1) - s2), S(1));
  bound.center_ratio = S(1) - one_minus_cos;
  bound.radius_ratio = root(S(one_minus_cos * (S(2) - one_minus_cos)));
  const auto is_any = !(s2 < S(T(0.5)));  // true for a NaN
  where(is_any, bound.center_ratio) = S(0);
  where(is_any, bound.radius_ratio) = S(1);
  for (int i = 0; i < 4; ++i) where(is_any, bound.apex[i]) = S(i == 0 ? T(1) : T(0));
  return bound;
}

}  // namespace refitlab
