// SPDX-License-Identifier: MIT
// These functions blend one vertex, over any number type: linearly, spherically by Equation (1), or by dual quaternions.
#pragma once

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/vocabulary/affine.hpp"
#include "lemmas/vocabulary/blending.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

// Returns sum w_i C_{j_i} v, where w is by position in the joint-set.
template <class S>
Vec<S, 3> blend_linear(const PaletteEntry<S>& palette, std::span<const S> w, const Vec<S, 3>& v) {
  if (!palette.maps.empty()) [[unlikely]]
    return linear_blend(palette.maps, w, v);
  Vec<S, 3> sum = apply(palette.transforms[0], v) * w[0];
  for (std::size_t i = 1; i < w.size(); ++i) sum = sum + apply(palette.transforms[i], v) * w[i];
  return sum;
}

// Returns sum w_i q_i, which is not normalised.
template <class S>
Quaternion<S> blend_quaternion(const PaletteEntry<S>& palette, std::span<const S> w) {
  return blended_rotation<S>(palette.transforms, w);
}

// Returns sum w_i C_{j_i} r_c, the linear part of Equation (1).
template <class S>
Vec<S, 3> blend_center(const PaletteEntry<S>& palette, std::span<const S> w) {
  return combine<S, 3>(w, palette.center_images);
}

// Computes both sums in one pass.
template <class S>
BlendedJoints<S> blend_joints(const PaletteEntry<S>& palette, std::span<const S> w) {
  BlendedJoints<S> sum{palette.transforms[0].rotation * w[0], palette.center_images[0] * w[0]};
  for (std::size_t i = 1; i < w.size(); ++i) {
    sum.rotation = sum.rotation + palette.transforms[i].rotation * w[i];
    sum.center_image = sum.center_image + palette.center_images[i] * w[i];
  }
  return sum;
}

// Applies Equation (1). The blended quaternion must not be zero; consistent signs and w_1 > 0 ensure this.
template <class S>
Vec<S, 3> blend_spherical(const PaletteEntry<S>& palette, std::span<const S> w, const Vec<S, 3>& v) {
  const BlendedJoints<S> blend = blend_joints(palette, w);
  return turn_and_place<S>(blend, squared_norm(blend.rotation), v - palette.rotation_center);
}

template <class S>
BlendedDuals<S> blend_duals(const PaletteEntry<S>& palette, std::span<const S> w) {
  return {blend_quaternion(palette, w), combine<S, 4>(w, palette.duals)};
}

// Blends dual quaternions. The blended q must not be zero.
template <class S>
Vec<S, 3> blend_dual_quaternion(const PaletteEntry<S>& palette, std::span<const S> w, const Vec<S, 3>& v) {
  const BlendedDuals<S> blend = blend_duals(palette, w);
  return move_rigidly<S>(blend, squared_norm(blend.rotation), v);
}

// Blends the vertex by the given kind of skinning.
template <class S>
Vec<S, 3> blend(Skinning skinning, const PaletteEntry<S>& palette, std::span<const S> w, const Vec<S, 3>& v) {
  switch (skinning) {
    case Skinning::linear: return blend_linear(palette, w, v);
    case Skinning::dual_quaternion: return blend_dual_quaternion(palette, w, v);
    case Skinning::spherical:
    case Skinning::hejl: break;
  }
  return blend_spherical(palette, w, v);
}

}  // namespace refitlab
