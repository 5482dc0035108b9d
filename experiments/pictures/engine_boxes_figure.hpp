// SPDX-License-Identifier: GPL-3.0-or-later
// The figure shows a character in the middle of a clip, with the boxes by which engines and we bound it.
#pragma once

#include "algorithms/model/model.hpp"
#include "experiments/pictures/picture_table.hpp"

namespace refitlab {

// Draws the first clip that is rigid, skinned linearly. Draws nothing for a model without one.
void draw_engine_boxes(const Model& model, PictureTable& pictures);

}  // namespace refitlab
