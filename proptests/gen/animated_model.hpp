// SPDX-License-Identifier: GPL-3.0-or-later
// Models with a skeleton of keys, with everything that channels, trees of nodes, offsets and weights may be.
#pragma once

#include <rapidcheck.h>

#include <random>

#include "algorithms/model/model.hpp"

namespace proptests::gen {

// What a model has; its numbers follow from the seed.
struct AnimatedPlan {
  bool rigid = false;      // skin matrices are rotations and translations, but for noise; else anything affine
  int nodes = 1;           // 1 to 7, in any tree or trees
  int joints = 1;          // 1 to 6, several on a node perhaps
  int vertices = 1;        // 1 to 5
  int targets = 0;         // 0 to 3 morph targets, of one mesh or of two
  double unit = 1;         // 1e-6 to 1e6
  double duration = 1;     // 0 to 1e6
  bool smooth = false;     // turns are small, nothing jumps, tangents are moderate
  bool cubic = false;      // splines of rotations, too
  double noise = 0;        // of the scales of a rigid model
  double root_scale = 1;   // of the first node, which offsets undo; negative for a mirror
  double away = 0;         // how far the reference pose is from the origin, which offsets undo; in units
  double far = 0;          // how far things are moved there and back, in units
  bool near_zero = false;  // some spline of rotations passes near zero
  unsigned seed = 0;
};

AnimatedPlan draw_animated_plan(bool rigid);          // within a property
AnimatedPlan draw_smooth_plan(bool rigid);            // within a property
refitlab::Model animated_model(const AnimatedPlan&);  // its only clip has the animation

// For the model's skeleton, as long as its clip, longer, shorter or a moment: a second clip that moves more or less the same nodes, some of
// them just as the first one, the opposite way, or half a turn from it. That of a smooth plan is no moment.
refitlab::Animation second_animation(const AnimatedPlan&, const refitlab::Model&);

// Whether something about it is a special case.
bool is_degenerate(const AnimatedPlan& plan);

// A time of a part of an animation, no later than the part's end, behind which a channel may jump: a sum might be rounded to there.
double time_within(double start, double end, std::mt19937& random);

// The numbers of all vertices, or of all joints: 0 to as many as there are.
template <class T>
std::vector<int> all_of(const std::vector<T>& list) {
  std::vector<int> all(list.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  return all;
}

std::ostream& operator<<(std::ostream& out, const AnimatedPlan& plan);

}  // namespace proptests::gen
