// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes say how far out the places of some vertices are in seven ways, and which place is the farthest in each.
#pragma once

#include <array>

#include "algorithms/model/skeleton_motion.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// A Place is a vertex of the model at a time of a clip.
struct Place {
  int vertex = -1;
  double time = 0;  // seconds
  Side side = Side::after;
};

// The seven ways are along -x, -y, -z, x, y and z, and away from a center. Boxes and balls are compared with them wall by wall.
inline constexpr int wall_count = 7, ball_wall = 6;

struct Extremes {
  std::array<double, wall_count> values;
  std::array<Place, wall_count> places;

  Extremes() { values.fill(-infinite); }

  void add(const Point3& at, const Point3& center, const Place& place) {
    for (int i = 0; i < 3; ++i) raise(i, -at[i], place), raise(i + 3, at[i], place);
    raise(ball_wall, norm<double, 3>(at - center), place);
  }

  void merge(const Extremes& other) {
    for (int i = 0; i < wall_count; ++i) raise(i, other.values[i], other.places[i]);
  }

  Box<double> box() const { return {{-values[0], -values[1], -values[2]}, {values[3], values[4], values[5]}}; }

 private:
  void raise(int wall, double value, const Place& place) {
    if (value > values[wall]) values[wall] = value, places[wall] = place;
  }
};

// Returns where the walls of a box stand.
inline std::array<double, 6> walls_of(const Box<float>& box) {
  return {-double(box.low[0]), -double(box.low[1]), -double(box.low[2]), box.high[0], box.high[1], box.high[2]};
}

inline double longest_side(const Box<float>& box) { return box_of<double>(box).edges().maxCoeff(); }

// A cluster whose shortest side is a smaller share of its longest one has hardly any volume to compare.
inline constexpr double flattest_side = 0.02;
inline bool is_flat(const Box<double>& box) { return box.edges().minCoeff() < flattest_side * box.edges().maxCoeff(); }

inline double volume_of_box(const Box<double>& box) { return box.edges().prod(); }

}  // namespace refitlab
