// SPDX-License-Identifier: GPL-3.0-or-later
// Models in poses from all over what validate and check_pose accept: up to 90 joints of a vertex, coordinates of any
// size, quaternions that are of unit length only nearly.
#pragma once

#include <rapidcheck.h>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace proptests::gen {

struct WidePlan {
  int joints;      // 1 to 90
  int influences;  // of a vertex: 1 to joints
  int vertices;    // a strip of triangles
  int exponent;    // of 2, by which all lengths are scaled
  int lengths;     // of quaternions: 0 as double makes them, 1 as float does, 2 at the ends of what is accepted
  double turn;     // of a joint against the first, relative to a radian, more or less
  unsigned seed;
};

// exponents: the least and the greatest.
rc::Gen<WidePlan> wide_plan(int least_exponent, int greatest_exponent);

// One joint, or one influence of each vertex.
inline bool is_degenerate(const WidePlan& plan) { return plan.influences == 1; }

refitlab::SkinnedMesh wide_model(const WidePlan& plan);
refitlab::Pose wide_pose(const WidePlan& plan, const refitlab::SkinnedMesh& model);

void showValue(const WidePlan& plan, std::ostream& out);

}  // namespace proptests::gen
