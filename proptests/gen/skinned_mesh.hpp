// SPDX-License-Identifier: GPL-3.0-or-later
// Draws small skinned meshes for trees: a tube of one to four joints with random weights, and what is awkward about meshes.
#pragma once

#include <rapidcheck.h>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

enum class MeshKind { tube, one_triangle, one_point, flat, repeated_triangles, many_influences };
inline constexpr int mesh_kind_count = 6;

struct MeshPlan {
  MeshKind kind;
  // There are 2 (rings - 1) sides triangles, but for one_triangle.
  int rings, sides, joints;
  unsigned seed;  // of positions and weights
};

// Draws up to 12 rings of up to 8 vertices; more than half are plain tubes.
rc::Gen<MeshPlan> mesh_plan();

// Makes a valid model without clips. With many_influences the weights spread over eight joints, more than can be enumerated.
refitlab::SkinnedMesh make_mesh(const MeshPlan& plan);

inline bool is_degenerate(const MeshPlan& plan) { return plan.kind != MeshKind::tube; }

// Draws a plan in a property, and classifies the case as degenerate if the plan is.
MeshPlan classified_plan();

void showValue(const MeshPlan& plan, std::ostream& out);

}  // namespace proptests::gen
