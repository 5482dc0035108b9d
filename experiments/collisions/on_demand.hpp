// The paper's query as detectors: spheres refitted on demand, by each contender.
#pragma once

#include "experiments/collisions/detector.hpp"

namespace refitlab {

std::vector<DetectorKind> on_demand_kinds();

}  // namespace refitlab
