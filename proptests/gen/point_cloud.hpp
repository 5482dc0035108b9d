// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds of points in the positions that are hard for balls: repeated, on a line, in a plane, on a sphere, on a grid.
#pragma once

#include <random>

#include "proptests/gen/vector.hpp"

namespace proptests::gen {

enum class Shape { general, repeated, line, plane, sphere, grid, one_point };
inline constexpr int shape_count = 7;

// What is special: everything but general positions.
inline bool is_degenerate(Shape shape) { return shape != Shape::general; }

template <int D>
struct Cloud {
  Shape shape;
  std::vector<RationalVec<D>> points;
};

// 1 to most points for D = 2, 3, 4. Half of them are in general position, the other shapes are equally frequent; shrinks towards fewer and simpler points.
template <int D>
rc::Gen<Cloud<D>> cloud(int most);

// The same shapes in double for long runs, n points: rounding makes nearly spherical, nearly flat and nearly equal points
// of them. The offset moves the cloud away from the origin.
template <int D>
std::vector<refitlab::Vec<double, D>> rounded_cloud(std::mt19937_64& random, Shape shape, int n, double offset);

template <int D>
void showValue(const Cloud<D>& cloud, std::ostream& out) {
  out << "shape " << static_cast<int>(cloud.shape) << ": ";
  rc::show(cloud.points, out);
}

}  // namespace proptests::gen
