// SPDX-License-Identifier: MIT
// The refits to volumes other than balls, by name: like those of variants.hpp each node by itself in any order, no
// vertex touched.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "algorithms/methods/volumes/aabb.hpp"
#include "algorithms/methods/volumes/obb.hpp"
#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

using Volume = std::variant<Aabb<double>, KDop<double, 14>, KDop<double, 18>, KDop<double, 26>, Obb<double>>;

struct VolumeVariant {
  std::string name;         // as in result files: snake_case, fixed
  std::string description;  // one line for tables and reports
  Pieces pieces;
  // Of one node, under spherical blending in the pose of node.palette. Thread-safe, and proved to enclose.
  Volume (*refit)(const RefitNode<double>& node);
  // Of the same kind around balls; balls is not empty.
  Volume (*around)(std::span<const Ball3<double>> balls);
};

const std::vector<VolumeVariant>& volume_variants();

}  // namespace refitlab
