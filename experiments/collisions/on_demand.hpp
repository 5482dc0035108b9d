// SPDX-License-Identifier: GPL-3.0-or-later
// These detectors are the paper's query, with spheres refitted on demand by each method.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

std::vector<DetectorKind> on_demand_kinds();
// Returns the same for linear blending, which has other pairs.
DetectorKind linear_on_demand();

}  // namespace refitlab
