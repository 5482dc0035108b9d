// SPDX-License-Identifier: MIT
// What a body's placement in the world must be.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

// Throws std::invalid_argument, about what is named, for a placement that is not finite or whose rotation differs from
// unit length by more than 1e-6.
inline void check_placement(const RigidTransform<double>& placement, const char* name) {
  if (!placement.rotation.allFinite() || !placement.translation.allFinite())
    throw std::invalid_argument(std::string(name) + " is not finite");
  if (!(std::abs(squared_norm(placement.rotation) - 1) <= 1e-6))
    throw std::invalid_argument(std::string(name) + " is not rigid: its rotation is no quaternion of unit length");
}

}  // namespace refitlab
