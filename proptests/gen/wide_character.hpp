// SPDX-License-Identifier: GPL-3.0-or-later
// Draws models in poses from all over what validate and check_pose accept: up to 90 joints of a vertex, coordinates of any size,
// quaternions that are of unit length only nearly.
#pragma once

#include <rapidcheck.h>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct WidePlan {
  int joints;      // 1 to 90
  int influences;  // of a vertex: 1 to joints
  int vertices;    // a strip of triangles
  // All lengths are scaled by 2 to this power.
  int exponent;
  // Quaternions are as double makes them for 0, as float does for 1, and at the ends of what is accepted for 2.
  int lengths;
  // This is the turn of a joint against the first, relative to about a radian.
  double turn;
  unsigned seed;
};

// Draws a plan. The exponents are the least and the greatest.
rc::Gen<WidePlan> wide_plan(int least_exponent, int greatest_exponent);

// Says whether there is one joint, or one influence of each vertex.
inline bool is_degenerate(const WidePlan& plan) { return plan.influences == 1; }

refitlab::SkinnedMesh wide_model(const WidePlan& plan);
refitlab::Pose wide_pose(const WidePlan& plan, const refitlab::SkinnedMesh& model);

void showValue(const WidePlan& plan, std::ostream& out);

}  // namespace proptests::gen
