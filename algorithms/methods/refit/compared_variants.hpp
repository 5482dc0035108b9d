// SPDX-License-Identifier: MIT
// These are all refit variants that are compared: those of the runtime, and Algorithm 1 as printed, which misses vertices.
#pragma once

#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

const std::vector<RefitVariant>& compared_variants();

// Returns the variant of this name. Throws std::invalid_argument that lists the existing names.
const RefitVariant& compared_variant(const std::string& name);

}  // namespace refitlab
