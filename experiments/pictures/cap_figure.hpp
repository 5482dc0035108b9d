// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figures 2, 3 and 4 show caps, half-spaces and their balls, in space.
#pragma once

#include "experiments/pictures/picture_table.hpp"

namespace refitlab {

// Draws them by the code of Lemmas 1, 3 and 5 for three dimensions.
void draw_caps(PictureTable& pictures);

}  // namespace refitlab
