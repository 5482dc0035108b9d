// SPDX-License-Identifier: GPL-3.0-or-later
// A WatchedClip finds where parts of a model get to in a clip, by looking at some of its times.
#pragma once

#include <span>
#include <vector>

#include "algorithms/bake/over_time/model_bounds.hpp"
#include "experiments/over_time/extremes.hpp"

namespace refitlab {

// A WatchedPart has a part's vertices, and the point from which their distances are measured.
struct WatchedPart {
  std::vector<int> vertices;
  Point3 center;
};

class WatchedClip {
 public:
  // All arguments must outlive this.
  WatchedClip(const Model& model, const JointSets& sets, const Animation& animation, Skinning skinning,
              const std::vector<WatchedPart>& parts);

  // Returns the times between which the clip is smooth.
  const std::vector<double>& key_times() const { return key_times_; }

  // Returns the extremes by part at these times, on both sides of those at which the clip jumps. It uses all processors.
  std::vector<Extremes> at(std::span<const double> times) const;

  // Looks ever closer at where each part was found to be farthest out, wall by wall. It looks a step before and after that time,
  // each time with half the step. Returns at how many times it looked, for all parts together, and adds to places how many places
  // of vertices it saw.
  long look_closer(std::vector<Extremes>& found, double step, int halvings, long& places) const;

  // Returns, by part, the greatest error of a computed place at any time.
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
