// SPDX-License-Identifier: GPL-3.0-or-later
// Some programs use these boxes in place of bounds over time. They are around the vertices at some times of a clip.
#pragma once

#include <string>
#include <vector>

#include "experiments/over_time/watched_clip.hpp"

namespace refitlab {

struct SamplingWay {
  std::string name;
  double rate;  // times a second; 0 for the times of the keys
};

const std::vector<SamplingWay>& sampling_ways();

// Returns the sampled times of a clip. Its end is one of them.
std::vector<double> sampled_times(const SamplingWay& way, const std::vector<double>& key_times);

// Returns a box that is larger by a renderer's rounding (ModelBoundsOptions::renderer_rounding), rounded outward to floats.
Box<float> with_room(Box<double> box);

// Returns the boxes by part. They are larger by a renderer's rounding, as bounds over time are.
std::vector<Box<float>> sampled_boxes(const WatchedClip& clip, const SamplingWay& way);

}  // namespace refitlab
