// SPDX-License-Identifier: GPL-3.0-or-later
// ExactPlaces decides whether a vertex is in a bound at a time, from the definition of skinning in intervals of 60 digits.
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "algorithms/runtime/tree/cluster_bounds.hpp"
#include "experiments/over_time/extremes.hpp"
#include "lemmas/vocabulary/verdict.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace refitlab {

class ExactPlaces {
 public:
  // model and animation must outlive this.
  ExactPlaces(const Model& model, const Animation& animation, Skinning skinning) : skin_(model, animation, skinning) {}

  // Returns whether the place is in the bound. This is undecided if the definition does not say where the vertex is.
  Verdict is_in(const Place& place, const Box<float>& box);
  Verdict is_in(const Place& place, const Ball3<float>& ball);

 private:
  using Point = Vec<MultiprecisionInterval, 3>;
  // Returns the point, or nothing if the definition does not say where it is.
  const std::optional<Point>& at(const Place& place);

  proptests::oracle::AnimatedSkin<MultiprecisionInterval> skin_;
  std::optional<std::pair<double, Side>> posed_;
  std::map<std::tuple<double, Side, int>, std::optional<Point>> known_;
};

}  // namespace refitlab
