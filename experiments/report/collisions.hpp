// The report's section on collision queries: detectors by scene, against engines and what one would write by hand.
#pragma once

#include <string>
#include <vector>

#include "experiments/collisions/collisions.hpp"
#include "experiments/speed/speed.hpp"

namespace refitlab {

// Empty without results; speed, which may be, gives the cost of a sphere.
std::string collisions_section(const std::vector<CollisionResult>& results, const std::vector<SpeedResult>& speed);

}  // namespace refitlab
