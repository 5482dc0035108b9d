// SPDX-License-Identifier: MIT
// All refit variants that are compared: those of the runtime, and Algorithm 1 as printed, which misses vertices.
#pragma once

#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

const std::vector<RefitVariant>& compared_variants();

// Throws std::invalid_argument that lists the names there are.
const RefitVariant& compared_variant(const std::string& name);

}  // namespace refitlab
