// SPDX-License-Identifier: GPL-3.0-or-later
// This measures growth with the number of joints: the cost of the balls of nodes with many joint-sets, each by itself and through
// a BVH cut.
#pragma once

#include <string>
#include <vector>

#include "experiments/speed/timing.hpp"

namespace refitlab {

// A JointGrowth is that of the snake of this many joints, by the default variant for spherical blending. Times are those of one
// frame, in ns.
struct JointGrowth {
  int joints = 0;
  int joint_sets = 0;
  int many = 0;                                               // nodes of more than 16 joint-sets
  double own = 0, through_descendants = 0;                    // all their balls in a frame; through cuts with all that they refit
  double own_root = 0;                                        // the root's ball by itself
  double root_through_descendants = 0;                        // the same through its cut, when the frame has no balls yet
  double root_from_known = 0;                                 // the same when the frame has the balls of the cut already
  double root_ratio = 0, root_ratio_through_descendants = 0;  // the root's radius / the optimal one, at half of the clip
};

// Measures 10 to 1000 joints.
std::vector<JointGrowth> run_joint_growth(const SpeedSettings& settings);

void write_joint_growth(const std::vector<JointGrowth>& rows, const std::string& path);

}  // namespace refitlab
