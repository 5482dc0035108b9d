// SPDX-License-Identifier: GPL-3.0-or-later
// Draws clouds of points in positions that are hard for balls: repeated, on a line, in a plane, on a sphere, on a grid.
#pragma once

#include <random>

#include "proptests/gen/vector.hpp"

namespace proptests::gen {

enum class Shape { general, repeated, line, plane, sphere, grid, one_point };
inline constexpr int shape_count = 7;

// Says whether a shape is special: all but general positions are.
inline bool is_degenerate(Shape shape) { return shape != Shape::general; }

template <int D>
struct Cloud {
  Shape shape;
  std::vector<RationalVec<D>> points;
};

// Draws 1 to most points for D = 2, 3, 4. Half of the clouds are in general position, and the other shapes are equally frequent;
// shrinks towards fewer and simpler points.
template <int D>
rc::Gen<Cloud<D>> cloud(int most);

// Draws n points of the same shapes in double for long runs: rounding makes nearly spherical, nearly flat and nearly equal points
// of them. The offset moves the cloud away from the origin.
template <int D>
std::vector<refitlab::Vec<double, D>> rounded_cloud(std::mt19937_64& random, Shape shape, int n, double offset);

template <int D>
void showValue(const Cloud<D>& cloud, std::ostream& out) {
  out << "shape " << static_cast<int>(cloud.shape) << ": ";
  rc::show(cloud.points, out);
}

}  // namespace proptests::gen
