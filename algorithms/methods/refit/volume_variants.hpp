// SPDX-License-Identifier: MIT
// These are the refits to volumes other than balls, by name. Like those of variants.hpp, they refit each node by itself, in any
// order, and touch no vertex.
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
  Skinning skinning;        // whose vertices it bounds
  Pieces pieces;
  // Refits one node in the pose of node.palette, whose joints may be affine if skinning is linear. It is thread-safe and proved
  // to enclose the vertices, skinned exactly or by skin(). It is all of space if some admissible blend of dual quaternions may be
  // 0.
  Volume (*refit)(const RefitNode<double>& node);
  // Returns a volume of the same kind around balls. balls is not empty.
  Volume (*around)(std::span<const Ball3<double>> balls);
};

const std::vector<VolumeVariant>& volume_variants();

}  // namespace refitlab
