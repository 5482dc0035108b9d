// SPDX-License-Identifier: GPL-3.0-or-later
// The figure shows the character and the cluster that get farthest out of a box around sampled times of a clip, at that time.
#pragma once

#include "experiments/over_time/over_time.hpp"
#include "experiments/pictures/picture_table.hpp"

namespace refitlab {

// Draws nothing if none gets out. The results are those of these models.
void draw_sampled_miss(const std::vector<Model>& models, const std::vector<OverTimeResult>& results, PictureTable& pictures);

}  // namespace refitlab
