// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figures 6 and 7: two walkers, and which spheres a query between them refitted.
#pragma once

#include "experiments/pictures/picture_table.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// The middle frame of the scenario "light": two who walk past each other and touch. Levels 6 and 9: of our deeper
// tree, about as coarse as the paper's 4 and 5.
void draw_walking(const AnimatedCharacter& character, PictureTable& pictures);

// Of the scenario "worst": two who walk through each other. Levels 4 and 6.
void draw_walk_through(const AnimatedCharacter& character, PictureTable& pictures);

}  // namespace refitlab
