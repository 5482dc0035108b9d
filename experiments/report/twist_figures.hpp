// The paper's Figures 1 and 5: a twisted character, and its balls by the refit variants.
#pragma once

#include "experiments/report/pictures.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// The bare skin in the reference posture and in the given one, under linear and under spherical blending; then the
// balls of levels 4 and 6, by each variant. The PNG files also go to folder, as MODEL_WHAT_bare.png and
// MODEL_WHAT_level4.png.
std::vector<Figure> twist_figures(const Character& character, const NamedPosture& posture, const std::string& folder);

}  // namespace refitlab
