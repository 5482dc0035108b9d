// SPDX-License-Identifier: GPL-3.0-or-later
// Floors say how fast a query by clusters could be at best. They are told beforehand which pairs of clusters to look into.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

// Returns one that is told which clusters' boxes meet, as if bounds were tight and free, and one that is told which clusters
// touch, as if nothing else were ever looked at.
std::vector<DetectorKind> floor_kinds();

}  // namespace refitlab
