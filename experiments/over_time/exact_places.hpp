// SPDX-License-Identifier: GPL-3.0-or-later
// ExactPlaces: decides whether a vertex is in a bound at a time, from the definition of skinning in intervals of 60 digits.
#pragma once

#include "algorithms/runtime/tree/cluster_bounds.hpp"
#include "experiments/over_time/extremes.hpp"
#include "lemmas/vocabulary/verdict.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace refitlab {

class ExactPlaces {
 public:
  // model and animation outlive this.
  ExactPlaces(const Model& model, const Animation& animation, Skinning skinning) : skin_(model, animation, skinning) {}

  // Undecided where the definition does not say where the vertex is.
  Verdict is_in(const Place& place, const Box<float>& box);
  Verdict is_in(const Place& place, const Ball3<float>& ball);

 private:
  // False where the definition does not say it.
  bool find(const Place& place);

  proptests::oracle::AnimatedSkin<MultiprecisionInterval> skin_;
  Place posed_;
  bool is_posed_ = false;
  Vec<MultiprecisionInterval, 3> at_;
};

}  // namespace refitlab
