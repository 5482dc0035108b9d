// SPDX-License-Identifier: GPL-3.0-or-later
// The detectors that the collision experiment compares.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

// All there are: each method that is sound for spherical blending, our clusters, the baselines, the engines that were found when
// this was configured, and these two once more behind a first test of boxes.
const std::vector<DetectorKind>& detector_kinds();

// Throws std::invalid_argument for a name that is none of theirs.
const DetectorKind& detector_kind(const std::string& name);

}  // namespace refitlab
