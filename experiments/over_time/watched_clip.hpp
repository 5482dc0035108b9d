// SPDX-License-Identifier: GPL-3.0-or-later
// WatchedClip: where parts of a model get to in a clip, looked at from time to time.
#pragma once

#include <span>
#include <vector>

#include "algorithms/bake/over_time/model_bounds.hpp"
#include "experiments/over_time/extremes.hpp"

namespace refitlab {

// A part's vertices, and what their distances are measured from.
struct WatchedPart {
  std::vector<int> vertices;
  Point3 center;
};

class WatchedClip {
 public:
  // All arguments outlive this.
  WatchedClip(const Model& model, const JointSets& sets, const Animation& animation, Skinning skinning,
              const std::vector<WatchedPart>& parts);

  // Where the clip is smooth in between.
  const std::vector<double>& key_times() const { return key_times_; }

  // By part, at these times; on both sides of those at which the clip jumps. On all processors.
  std::vector<Extremes> at(std::span<const double> times) const;

  // Looks ever closer at where each part was found to be farthest out, wall by wall: a step before and after it, each time with
  // half the step. Returns at how many times it looked, of all parts together; adds how many places of vertices it saw.
  long look_closer(std::vector<Extremes>& found, double step, int halvings, long& places) const;

  // By part: what a computed place may be off, at any time.
  const std::vector<double>& errors() const { return errors_; }

 private:
  void look_closer(std::size_t part, Extremes& found, double step, int halvings, long& looks) const;

  const Model& model_;
  const JointSets& sets_;
  const Animation& animation_;
  Skinning skinning_;
  const std::vector<WatchedPart>& parts_;
  std::vector<double> key_times_, errors_;
};

}  // namespace refitlab
