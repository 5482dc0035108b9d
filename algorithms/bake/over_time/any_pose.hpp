// SPDX-License-Identifier: GPL-3.0-or-later
// However the nodes are turned, vertices are in a ball about a joint, which follows from bone lengths and scales alone
// (c8_any_pose).
#pragma once

#include <optional>
#include <span>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/mesh/joint_sets.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

// All vertices are within the radius of the node's origin, wherever that is.
struct AnyPoseBound {
  int node;       // of the model's skeleton: the deepest one that is above all of the vertices' joints, or one of them
  double radius;  // in the scene's units
};

// Returns the bound of some vertices, at least one, whatever the rotations of all nodes. Nodes are translated and scaled as in
// the rest pose or in one of the model's clips, and morph targets have weights as there; but these may come from different clips.
// skinning is linear, dual_quaternion or spherical. For the latter two, skin matrices must be rigid within rigidity_tolerance:
// they are replaced by the nearest rigid transforms. There is no bound if no node is above all joints, and none for the latter
// two if a vertex has three joints or more, because the blend of their rotations may vanish.
// renderer_rounding is what vertices and the node's origin may be off by, each as a share of the sum of the lengths that they are
// made of, from the scene's origin: 0 for exact arithmetic. Throws ModelError for a model without a skeleton of keys.
std::optional<AnyPoseBound> bound_any_pose(const Model& model, const JointSets& sets, std::span<const int> vertices,
                                           Skinning skinning, double renderer_rounding = 0);

}  // namespace refitlab
