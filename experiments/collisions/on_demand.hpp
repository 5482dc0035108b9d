// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's query as detectors: spheres refitted on demand, by each method.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

std::vector<DetectorKind> on_demand_kinds();
// The same for linear blending, whose pairs are others.
DetectorKind linear_on_demand();

}  // namespace refitlab
