// SPDX-License-Identifier: MIT
// Box: a box with edges along the axes, whose corners are least and greatest coordinates.
//
// Of one scalar type, or of packs: then a box a lane. Point may be a row of registers, whose fourth number is then not looked
// at. What does not fit kernels is laid out by BoxBlock (many boxes against one) and by FlippedBox (merging), of algorithms/runtime/collide.
#pragma once

#include <limits>
#include <type_traits>

#include "algorithms/runtime/packs/row.hpp"
#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

template <class S, class Point = Vec<S, 3>>
struct Box {
  Point low, high;  // it has the points with low <= x <= high in each coordinate

  // Of no points; merged with anything it yields that.
  static Box empty() { return of(infinite, -infinite); }
  static Box everything() { return of(-infinite, infinite); }

  void merge(const Point& p) { merge(p, p); }
  void merge(const Box& b) { merge(b.low, b.high); }
  // In all directions.
  void grow(const S& by) {
    if constexpr (is_row) {
      low = low - by, high = high + by;
    } else {
      low = Point(low[0] - by, low[1] - by, low[2] - by), high = Point(high[0] + by, high[1] + by, high[2] + by);
    }
  }

  bool is_empty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
  Point center() const { return (low + high) / S(2); }
  Point edges() const { return high - low; }
  // The sum of its edges.
  S extent() const { return (high[0] - low[0]) + (high[1] - low[1]) + (high[2] - low[2]); }

 private:
  static constexpr bool is_row = !std::is_same_v<Point, Vec<S, 3>>;

  static Box of(double least, double greatest) {
    if constexpr (is_row) return {Point{} + static_cast<S>(least), Point{} + static_cast<S>(greatest)};
    else return {Point::Constant(S(static_cast<float>(least))), Point::Constant(S(static_cast<float>(greatest)))};
  }
  // Written out: what a loop stores number by number the processor waits for, where more are loaded at once.
  void merge(const Point& l, const Point& h) {
    if constexpr (is_row) {
      low = l < low ? l : low, high = high < h ? h : high;
    } else {
      low = Point(min_of<S>(low[0], l[0]), min_of<S>(low[1], l[1]), min_of<S>(low[2], l[2]));
      high = Point(max_of<S>(high[0], h[0]), max_of<S>(high[1], h[1]), max_of<S>(high[2], h[2]));
    }
  }
};

// Four numbers a corner, which take one operation together.
template <class S>
using RowBox = Box<S, Row<S, 4>>;

// Whether a coordinate separates them: a bool, or a mask of lanes. A NaN separates nothing.
template <class S>
auto are_apart(const Box<S>& a, const Box<S>& b) {
  auto apart = a.high[0] < b.low[0] || b.high[0] < a.low[0];
  for (int i = 1; i < 3; ++i) apart = apart || a.high[i] < b.low[i] || b.high[i] < a.low[i];
  return apart;
}

// Lane by lane.
template <class Mask, class S>
Box<S> choose(const Mask& first, const Box<S>& a, const Box<S>& b) {
  return {choose(first, a.low, b.low), choose(first, a.high, b.high)};
}

// Another number type's box of the same numbers.
template <class T, class S, class Point>
Box<T> box_of(const Box<S, Point>& box) {
  Box<T> out;
  for (int i = 0; i < 3; ++i) out.low[i] = T(box.low[i]), out.high[i] = T(box.high[i]);
  return out;
}

}  // namespace refitlab
