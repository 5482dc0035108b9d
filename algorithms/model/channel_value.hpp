// SPDX-License-Identifier: GPL-3.0-or-later
// The value of a channel at a time (glTF 2.0, appendix C).
#pragma once

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

// side: where the channel jumps at that time. Rotations are of unit length.
Eigen::Vector3d value_at(const Channel<Eigen::Vector3d>& channel, double time, Side side);
Eigen::Quaterniond value_at(const Channel<Eigen::Quaterniond>& channel, double time, Side side);
Eigen::VectorXd value_at(const Channel<Eigen::VectorXd>& channel, double time, Side side);

}  // namespace refitlab
