// SPDX-License-Identifier: GPL-3.0-or-later
// An animation is repeated to make one that is so many times as long.
#pragma once

#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

// Each repetition goes on from the last key of the one before. This takes the place of its own first key, except for the tangent
// of a spline behind it. Channels of more than one key have keys at 0 and at the end.
template <class Value>
Channel<Value> repeated(const Channel<Value>& channel, double duration, int times) {
  Channel<Value> out = channel;
  if (channel.keys.size() < 2) return out;
  for (int n = 1; n < times; ++n) {
    if (!channel.tangents.empty()) out.tangents.back().out = channel.tangents[0].out;
    for (std::size_t k = 1; k < channel.keys.size(); ++k) {
      out.keys.push_back({n * duration + channel.keys[k].time, channel.keys[k].value});
      if (!channel.tangents.empty()) out.tangents.push_back(channel.tangents[k]);
    }
  }
  return out;
}

inline Animation repeated(const Animation& animation, int times) {
  Animation out = animation;
  out.duration *= times;
  for (NodeTrack& track : out.tracks) {
    track.positions = repeated(track.positions, animation.duration, times);
    track.rotations = repeated(track.rotations, animation.duration, times);
    track.scales = repeated(track.scales, animation.duration, times);
  }
  for (WeightTrack& track : out.weight_tracks) track.weights = repeated(track.weights, animation.duration, times);
  return out;
}

}  // namespace refitlab
