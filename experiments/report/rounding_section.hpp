// The report's section on certified refits.
#pragma once

#include <string>
#include <vector>

#include "experiments/rounding/rounding.hpp"

namespace refitlab {

// HTML; empty without results.
std::string rounding_section(const std::vector<RoundingResult>& results);

}  // namespace refitlab
