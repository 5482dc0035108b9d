// SPDX-License-Identifier: GPL-3.0-or-later
// Where the printed algorithm fails: a pose in which its balls miss vertices, and one such ball from near.
#pragma once

#include "experiments/pictures/picture_table.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// The pose of worst_twist with every vertex marked that a ball of the tree misses; then a ball that misses one, of
// the coarsest level with such a ball, as printed, repaired and tightest. Only the first picture if there is none.
void draw_failing(const AnimatedCharacter& character, const NamedPose& worst, PictureTable& pictures);

}  // namespace refitlab
