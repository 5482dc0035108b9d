// SPDX-License-Identifier: GPL-3.0-or-later
// Misses are the balls that miss a vertex that they are to hold, and these vertices.
#pragma once

#include <algorithm>

#include "experiments/scenes/animated_character.hpp"

namespace refitlab {

// A vertex counts as missed by a ball that does not allow for rounding if it is outside by more than this share of the root's
// reference radius. Skinning and refit both round, each by some 1e-15 of that radius.
inline constexpr double miss_tolerance = 1e-12;

// Returns whether a ball is defined. One that is not a number or has a negative radius holds nothing.
inline bool is_defined(const Ball3<double>& b) { return b.center.allFinite() && std::isfinite(b.radius) && b.radius >= 0; }

// Returns how far a point is outside a ball. It is at most 0 if it is not.
inline double excess(const Ball3<double>& ball, const Point3& point) {
  return norm<double, 3>(point - ball.center) - ball.radius;
}

struct Misses {
  std::vector<bool> balls;    // by ball: undefined, or a vertex of its node is outside
  std::vector<bool> outside;  // by vertex: outside a ball of its node that is defined
  std::vector<bool> without;  // by vertex: a ball of its node is undefined
  int undefined = 0;          // balls
  double worst = 0;           // how far a vertex is outside, in model units
  int worst_ball = -1;        // that ball, by its index in the list; -1: none
  long ball_count() const { return std::count(balls.begin(), balls.end(), true); }
  long outside_count() const { return std::count(outside.begin(), outside.end(), true); }
};

// Finds the misses. balls has one for each of the nodes. vertices are the deformed ones of the model.
inline Misses find_misses(const AnimatedCharacter& c, std::span<const int> nodes, std::span<const Ball3<double>> balls,
                          std::span<const Point3> vertices) {
  const double tolerance = miss_tolerance * c.tree.nodes[0].reference.radius;
  Misses out;
  out.balls.resize(balls.size());
  out.outside.resize(vertices.size()), out.without.resize(vertices.size());
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const bool defined = is_defined(balls[b]);
    out.undefined += !defined;
    if (!defined) out.balls[b] = true;
    for (const int v : c.vertices[nodes[b]]) {
      const double miss = defined ? excess(balls[b], vertices[v]) : 0;
      if (!defined) out.without[v] = true;
      if (miss <= tolerance) continue;
      out.balls[b] = out.outside[v] = true;
      if (miss > out.worst) out.worst = miss, out.worst_ball = static_cast<int>(b);
    }
  }
  return out;
}

// Returns the nodes of a level of the tree, from 1, or of all levels for level 0.
inline std::vector<int> nodes_of_level(const SphereTree& tree, int level) {
  std::vector<int> nodes;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    if (level == 0 || tree.nodes[n].level == level) nodes.push_back(static_cast<int>(n));
  return nodes;
}

}  // namespace refitlab
