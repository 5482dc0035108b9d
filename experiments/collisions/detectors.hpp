// SPDX-License-Identifier: GPL-3.0-or-later
// The collision experiment compares these detectors.
#pragma once

#include "experiments/baselines/detector.hpp"

namespace refitlab {

// Returns all kinds: each method that is sound for spherical blending, our clusters, the baselines, the engines that were found
// when this was configured, the latter two once more behind a first test of boxes, and the floors (floors.hpp).
const std::vector<DetectorKind>& detector_kinds();

// Returns the kind of this name. Throws std::invalid_argument for an unknown name.
const DetectorKind& detector_kind(const std::string& name);

}  // namespace refitlab
