// SPDX-License-Identifier: GPL-3.0-or-later
// A channel has a value at each time (glTF 2.0, appendix C).
#pragma once

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

// These return the value at a time. side matters if the channel jumps at that time. Rotations have unit length.
Eigen::Vector3d value_at(const Channel<Eigen::Vector3d>& channel, double time, Side side);
Eigen::Quaterniond value_at(const Channel<Eigen::Quaterniond>& channel, double time, Side side);
Eigen::VectorXd value_at(const Channel<Eigen::VectorXd>& channel, double time, Side side);

}  // namespace refitlab
