// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figures 6 and 7 show two walkers, and which spheres a query between them refitted.
#pragma once

#include "experiments/pictures/picture_table.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// Draws the middle frame of the scenario "light", in which two walk past each other and touch. Levels 6 and 9 of our deeper tree
// are about as coarse as the paper's 4 and 5.
void draw_walking(const AnimatedCharacter& character, PictureTable& pictures);

// Draws the scenario "worst", in which two walk through each other, with levels 4 and 6.
void draw_walk_through(const AnimatedCharacter& character, PictureTable& pictures);

}  // namespace refitlab
