// SPDX-License-Identifier: GPL-3.0-or-later
// The figure shows where the printed algorithm fails: a pose in which its balls miss vertices, and one such ball from near.
#pragma once

#include "experiments/pictures/picture_table.hpp"
#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// Draws the pose of worst_twist with a mark at every vertex that a ball of the tree misses. Then it draws a ball that misses one,
// of the coarsest level with such a ball, as printed, repaired and tightest. If there is none, it draws only the first picture.
void draw_failing(const AnimatedCharacter& character, const NamedPose& worst, PictureTable& pictures);

}  // namespace refitlab
