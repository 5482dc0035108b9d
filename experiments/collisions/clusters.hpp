// SPDX-License-Identifier: GPL-3.0-or-later
// The fast query as a detector: boxes from the joints alone above, skinned clusters below.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

std::vector<DetectorKind> cluster_kinds();

}  // namespace refitlab
