// SPDX-License-Identifier: MIT
// Converts a joint-set's palette from one number type to another, for example doubles to the exact numbers that they are.
#pragma once

#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

template <class T, class S>
OwnedPaletteEntry<T> convert(const PaletteEntry<S>& palette) {
  OwnedPaletteEntry<T> out;
  for (const auto& c : palette.transforms) out.transforms.push_back({convert<T>(c.rotation), convert<T>(c.translation)});
  out.rotation_center = convert<T>(palette.rotation_center);
  for (const auto& image : palette.center_images) out.center_images.push_back(convert<T>(image));
  for (const auto& dual : palette.duals) out.duals.push_back(convert<T>(dual));
  for (const auto& map : palette.maps) out.maps.push_back(convert<T>(map));
  for (const auto& stretch : palette.stretches) out.stretches.push_back(T(stretch));
  return out;
}

}  // namespace refitlab
