// SPDX-License-Identifier: GPL-3.0-or-later
// This is the fast query as a detector. It has boxes from the joints alone above, and skinned clusters below.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

std::vector<DetectorKind> cluster_kinds();

}  // namespace refitlab
