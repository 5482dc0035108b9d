// SPDX-License-Identifier: GPL-3.0-or-later
// The boxes that are used in place of bounds over time: around the vertices at some times of a clip.
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

// The times of a clip, whose end is one of them.
std::vector<double> sampled_times(const SamplingWay& way, const std::vector<double>& key_times);

// By part. They have the room for a renderer's rounding that bounds over time have, too.
std::vector<Box<float>> sampled_boxes(const WatchedClip& clip, const SamplingWay& way);

}  // namespace refitlab
