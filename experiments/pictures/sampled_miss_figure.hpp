// SPDX-License-Identifier: GPL-3.0-or-later
// The character and the cluster that get farthest out of a box around sampled times of a clip, at that time.
#pragma once

#include "experiments/over_time/over_time.hpp"
#include "experiments/pictures/picture_table.hpp"

namespace refitlab {

// Nothing where none gets out. The models are those that the results are of.
void draw_sampled_miss(const std::vector<Model>& models, const std::vector<OverTimeResult>& results, PictureTable& pictures);

}  // namespace refitlab
