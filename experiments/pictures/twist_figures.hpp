// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figures 1 and 5 show a twisted character, and its balls by the refit variants.
#pragma once

#include "experiments/pictures/picture_table.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// Draws the bare skin in the reference pose and in the given one, under linear and under spherical blending, and then the balls
// of levels 4 and 6, by each variant. Files are named MODEL_VARIANT_bare.png and MODEL_VARIANT_level4.png.
void draw_twist(const AnimatedCharacter& character, const NamedPose& pose, PictureTable& pictures);

}  // namespace refitlab
