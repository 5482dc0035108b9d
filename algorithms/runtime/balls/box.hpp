// SPDX-License-Identifier: MIT
// A Box has edges along the axes. Its corners are the least and the greatest coordinates.
//
// S is a scalar, or a pack, which then has a box in each lane. Point may be a row of registers, whose fourth number is not used.
// algorithms/runtime/collide has other layouts for kernels: BoxBlock (many boxes against one) and FlippedBox (merging).
#pragma once

#include <limits>
#include <span>
#include <type_traits>

#include "algorithms/runtime/packs/row.hpp"
#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

template <class S, class Point = Vec<S, 3>>
struct Box {
  Point low, high;  // it has the points with low <= x <= high in each coordinate

  // Returns the box of no points. Merging it with a box yields that box.
  static Box empty() { return of(infinite, -infinite); }
  static Box everything() { return of(-infinite, infinite); }

  void merge(const Point& p) { merge(p, p); }
  void merge(const Box& b) { merge(b.low, b.high); }
  // Grows the box by this length in all directions.
  void grow(const S& by) {
    if constexpr (is_row) {
      low = low - by, high = high + by;
    } else {
      low = Point(low[0] - by, low[1] - by, low[2] - by), high = Point(high[0] + by, high[1] + by, high[2] + by);
    }
  }

  // Leaves what the box has in common with another one.
  void cut(const Box& b) {
    for (int i = 0; i < 3; ++i) low[i] = max_of<S>(low[i], b.low[i]), high[i] = min_of<S>(high[i], b.high[i]);
  }

  bool is_empty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
  Point center() const { return (low + high) / S(2); }
  Point edges() const { return high - low; }
  // Returns the sum of the three edges.
  S extent() const { return (high[0] - low[0]) + (high[1] - low[1]) + (high[2] - low[2]); }
  // Returns the greatest absolute coordinate of its points.
  S greatest_coordinate() const {
    S greatest(0);
    for (int i = 0; i < 3; ++i) greatest = max_of<S>(greatest, max_of<S>(absolute<S>(low[i]), absolute<S>(high[i])));
    return greatest;
  }

 private:
  static constexpr bool is_row = !std::is_same_v<Point, Vec<S, 3>>;

  static Box of(double least, double greatest) {
    if constexpr (is_row) return {Point{} + static_cast<S>(least), Point{} + static_cast<S>(greatest)};
    else return {Point::Constant(S(static_cast<float>(least))), Point::Constant(S(static_cast<float>(greatest)))};
  }
  // This is written out, because a loop stores number by number, and then the processor waits where several are loaded at once.
  void merge(const Point& l, const Point& h) {
    if constexpr (is_row) {
      low = l < low ? l : low, high = high < h ? h : high;
    } else {
      low = Point(min_of<S>(low[0], l[0]), min_of<S>(low[1], l[1]), min_of<S>(low[2], l[2]));
      high = Point(max_of<S>(high[0], h[0]), max_of<S>(high[1], h[1]), max_of<S>(high[2], h[2]));
    }
  }
};

// A RowBox has four numbers a corner, which take one operation together.
template <class S>
using RowBox = Box<S, Row<S, 4>>;

// Returns the box around points. Around none it is empty.
template <class S>
Box<S> box_around(std::span<const Vec<S, 3>> points) {
  if (points.empty()) return Box<S>::empty();
  Box<S> box{points[0], points[0]};
  for (const Vec<S, 3>& p : points) box.merge(p);
  return box;
}

// Returns whether a coordinate separates the boxes, as a bool or a mask of lanes. A NaN separates nothing.
template <class S>
auto are_apart(const Box<S>& a, const Box<S>& b) {
  auto apart = a.high[0] < b.low[0] || b.high[0] < a.low[0];
  for (int i = 1; i < 3; ++i) apart = apart || a.high[i] < b.low[i] || b.high[i] < a.low[i];
  return apart;
}

// Returns the least edge of what two boxes have in common. It is negative for boxes that are apart.
template <class S>
S common_width(const Box<S>& a, const Box<S>& b) {
  S width = S(infinite);
  for (int i = 0; i < 3; ++i) width = min_of<S>(width, min_of<S>(a.high[i], b.high[i]) - max_of<S>(a.low[i], b.low[i]));
  return width;
}

// Returns the length by which a box extends beyond another one, at most in any coordinate. It is less than 0 if it does not.
template <class S>
S beyond_box(const Box<S>& box, const Box<S>& other) {
  S most = other.low[0] - box.low[0];
  for (int i = 0; i < 3; ++i) most = max_of<S>(most, max_of<S>(other.low[i] - box.low[i], box.high[i] - other.high[i]));
  return most;
}

// Chooses between two boxes lane by lane.
template <class Mask, class S>
Box<S> choose(const Mask& first, const Box<S>& a, const Box<S>& b) {
  return {choose(first, a.low, b.low), choose(first, a.high, b.high)};
}

// Returns the box with the same numbers in another number type.
template <class T, class S, class Point>
Box<T> box_of(const Box<S, Point>& box) {
  Box<T> out;
  for (int i = 0; i < 3; ++i) out.low[i] = T(box.low[i]), out.high[i] = T(box.high[i]);
  return out;
}

}  // namespace refitlab
