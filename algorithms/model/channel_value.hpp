// SPDX-License-Identifier: GPL-3.0-or-later
// The value of a channel at a time (glTF 2.0, appendix C).
#pragma once

#include <vector>

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

// side: where the channel jumps at that time. Rotations are of unit length.
Eigen::Vector3d value_at(const Channel<Eigen::Vector3d>& channel, double time, Side side);
Eigen::Quaterniond value_at(const Channel<Eigen::Quaterniond>& channel, double time, Side side);
Eigen::VectorXd value_at(const Channel<Eigen::VectorXd>& channel, double time, Side side);

// The weights of the morph targets of the mesh that a node shows: `otherwise`, where the clip does not move them.
std::vector<double> morph_weights(int node, const std::vector<double>& otherwise, const Animation& motion, double time,
                                  Side side = Side::after);

}  // namespace refitlab
