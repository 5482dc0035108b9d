// The paper's Figures 2, 3 and 4: caps, half-spaces and their balls, in the plane and in space.
#pragma once

#include "experiments/report/pictures.hpp"

namespace refitlab {

// In the plane the drawings of the lemmas, in space the same lemmas' code for three dimensions.
Figure cap_figure(const std::string& folder);

}  // namespace refitlab
