// The report's section on batches in SIMD packs.
#pragma once

#include <string>
#include <vector>

#include "experiments/speed/batch.hpp"

namespace refitlab {

// Empty if there are no results.
std::string batch_section(const std::vector<BatchSpeed>& results);

}  // namespace refitlab
