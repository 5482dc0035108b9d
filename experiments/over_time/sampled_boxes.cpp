// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/sampled_boxes.hpp"

namespace refitlab {

const std::vector<SamplingWay>& sampling_ways() {
  static const std::vector<SamplingWay> ways = {{"keys", 0}, {"30 Hz", 30}, {"60 Hz", 60}};
  return ways;
}

std::vector<double> sampled_times(const SamplingWay& way, const std::vector<double>& key_times) {
  return way.rate == 0 ? key_times : times_at_rate(way.rate, key_times.back());
}

Box<float> with_room(Box<double> box) {
  box.grow(ModelBoundsOptions{}.renderer_rounding * box.greatest_coordinate());
  return rounded_outward(box);
}

std::vector<Box<float>> sampled_boxes(const WatchedClip& clip, const SamplingWay& way) {
  std::vector<Box<float>> boxes;
  for (const Extremes& found : clip.at(sampled_times(way, clip.key_times()))) boxes.push_back(with_room(found.box()));
  return boxes;
}

}  // namespace refitlab
