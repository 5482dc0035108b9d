// The speed of collision queries at a glance: the table with which the report's numbers begin.
#pragma once

#include <string>
#include <vector>

#include "experiments/collisions/collisions.hpp"

namespace refitlab {

// Of the first model: ours, the paper's query and what one would take instead, scene by scene; empty without results.
std::string headline_section(const std::vector<CollisionResult>& collisions);

}  // namespace refitlab
