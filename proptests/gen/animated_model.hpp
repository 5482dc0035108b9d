// SPDX-License-Identifier: GPL-3.0-or-later
// Draws models with a skeleton of keys, with everything that channels, trees of nodes, offsets and weights may be.
#pragma once

#include <rapidcheck.h>

#include <random>

#include "algorithms/model/model.hpp"

namespace proptests::gen {

// Says what a model has. Its numbers follow from the seed.
struct AnimatedPlan {
  // Skin matrices are rotations and translations, but for noise; otherwise they are anything affine.
  bool rigid = false;
  int nodes = 1;     // 1 to 7, in any tree or trees
  int joints = 1;    // 1 to 6, several on a node perhaps
  int vertices = 1;  // 1 to 5
  // There are 0 to 3 morph targets, of one mesh or of two.
  int targets = 0;
  double unit = 1;      // 1e-6 to 1e6
  double duration = 1;  // 0 to 1e6
  // Turns are small, nothing jumps, and tangents are moderate.
  bool smooth = false;
  bool cubic = false;  // splines of rotations, too
  double noise = 0;    // of the scales of a rigid model
  // This is the scale of the first node, which offsets undo; it is negative for a mirror.
  double root_scale = 1;
  // This says how far the reference pose is from the origin, which offsets undo, in units.
  double away = 0;
  // This says how far things are moved there and back, in units.
  double far = 0;
  // Some spline of rotations passes near zero.
  bool near_zero = false;
  unsigned seed = 0;
};

AnimatedPlan draw_animated_plan(bool rigid);          // within a property
AnimatedPlan draw_smooth_plan(bool rigid);            // within a property
refitlab::Model animated_model(const AnimatedPlan&);  // its only clip has the animation

// Makes a second clip for the model's skeleton, as long as its clip, longer, shorter or a moment. It moves more or less the same
// nodes, some of them just as the first one, the opposite way, or half a turn from it. That of a smooth plan is no moment.
refitlab::Animation second_animation(const AnimatedPlan&, const refitlab::Model&);

// Says whether something about the plan is a special case.
bool is_degenerate(const AnimatedPlan& plan);

// Returns a time of a part of an animation, no later than the part's end, behind which a channel may jump: a sum might be rounded
// to there.
double time_within(double start, double end, std::mt19937& random);

// Returns the numbers of all vertices, or of all joints, from 0 on.
template <class T>
std::vector<int> all_of(const std::vector<T>& list) {
  std::vector<int> all(list.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  return all;
}

std::ostream& operator<<(std::ostream& out, const AnimatedPlan& plan);

}  // namespace proptests::gen
