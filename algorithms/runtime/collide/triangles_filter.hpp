// SPDX-License-Identifier: MIT
// A quick test whether two triangles have a point in common, in double or in packs of doubles. It gives no answer where
// rounding might decide.
//
// It computes on which sides of each triangle's plane the other's corners are. Where each triangle crosses the other's
// plane, it computes the order of the crossings on the line that the planes share [Guigue and Devillers 2003]. All of these
// are signs of determinants.
//
// Rounding. Let u = 2^-53, and let X, Y, Z be the largest computed |differences| of coordinates. A determinant of
// differences is a sum of six products of three differences. Each product is at most XYZ (1 + u)^3 in exact differences,
// with at most 3 + 2 + 3 roundings (of differences, products and sums), and each rounding is a factor within 1 +- u. So the
// error is at most 6 XYZ ((1 + u)^11 - 1) < 67 u XYZ < 7.5e-15 XYZ. The bound in the code leaves a fourth for its own
// roundings, and for products that underflow. With X, Y and Z below 1e100 and XYZ above 1e-186, products of two of them are
// above 1e-286, and 2^-1075 is nothing in comparison. For other values no sign is certain: products may underflow, or
// determinants may overflow where their bounds do not.
#pragma once

#include <array>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

template <class S>
using TriangleOf = std::array<Vec<S, 3>, 3>;
using TrianglePoints = TriangleOf<double>;

// A sign that is certain, or not. Mask is bool, or a mask of lanes.
template <class Mask>
struct Sign {
  Mask is_positive, is_negative;
};

// The largest |differences| by coordinate.
template <class S>
class DifferenceExtent {
 public:
  void add(const Vec<S, 3>& difference) {
    using std::abs;
    for (int i = 0; i < 3; ++i) largest_[i] = max_of(largest_[i], S(abs(difference[i])));
  }
  auto sign_of(const S& determinant) const {
    const S error = largest_[0] * largest_[1] * largest_[2] * S(1e-14);
    const auto is_in_range = error > S(1e-200) && largest_[0] + largest_[1] + largest_[2] < S(1e100);
    return Sign<decltype(determinant > error)>{is_in_range && determinant > error, is_in_range && determinant < -error};
  }

 private:
  S largest_[3] = {S(0), S(0), S(0)};
};

// Returns the sign of the determinant of (b - a, c - a, d - a).
template <class S>
auto sign_of_determinant(const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c, const Vec<S, 3>& d) {
  const Vec<S, 3> p = b - a, q = c - a, r = d - a;
  DifferenceExtent<S> extent;
  extent.add(p), extent.add(q), extent.add(r);
  return extent.sign_of(dot<S, 3>(cross<S>(p, q), r));
}

// The sides of a triangle's plane on which another triangle's corners are.
template <class S>
class PlaneSides {
 public:
  PlaneSides(const TriangleOf<S>& plane, const TriangleOf<S>& points) {
    const Vec<S, 3> p = plane[1] - plane[0], q = plane[2] - plane[0], normal = cross<S>(p, q);
    const TriangleOf<S> r{points[0] - plane[0], points[1] - plane[0], points[2] - plane[0]};
    DifferenceExtent<S> extent;  // of all, for all three
    extent.add(p), extent.add(q);
    for (const Vec<S, 3>& x : r) extent.add(x);
    for (int i = 0; i < 3; ++i) distance_[i] = dot<S, 3>(normal, r[i]);
    for (int i = 0; i < 3; ++i) side_[i] = extent.sign_of(distance_[i]);
  }

  auto are_one() const {
    return (side_[0].is_positive && side_[1].is_positive && side_[2].is_positive) ||
           (side_[0].is_negative && side_[1].is_negative && side_[2].is_negative);
  }
  auto are_certain() const {
    const auto is_certain = [&](int i) { return side_[i].is_positive || side_[i].is_negative; };
    return is_certain(0) && is_certain(1) && is_certain(2);
  }
  // Requires certain sides that are not all the same. Turns the points so that the one that is alone on its side comes
  // first, and returns whether that is the positive side.
  auto turn(TriangleOf<S>& points) const {
    const auto differ = [&](int i, int j) { return (distance_[i] > S(0)) != (distance_[j] > S(0)); };
    const auto is_third = !differ(0, 1), is_second = !differ(0, 2);
    const TriangleOf<S> p = points;
    for (int i = 0; i < 3; ++i) points[i] = choose(is_third, p[(i + 2) % 3], choose(is_second, p[(i + 1) % 3], p[i]));
    return choose(is_third, distance_[2], choose(is_second, distance_[1], distance_[0])) > S(0);
  }

 private:
  using Mask = decltype(S(0) > S(0));
  S distance_[3];  // scaled
  Sign<Mask> side_[3];
};

// Requires two triangles that certainly cross each other's planes. The crossings of each triangle with the shared line are
// an interval, and the triangles meet if neither interval begins after the other has ended. The sign is positive if they
// are apart, and negative if they meet.
template <class S>
auto sign_of_gap(const PlaneSides<S>& of_a, const PlaneSides<S>& of_b, TriangleOf<S> a, TriangleOf<S> b) {
  const auto swap_where = [](auto where, Vec<S, 3>& x, Vec<S, 3>& y) {
    const Vec<S, 3> was = x;
    x = choose(where, y, x), y = choose(where, was, y);
  };
  const auto is_a_above = of_a.turn(a), is_b_above = of_b.turn(b);
  swap_where(!is_a_above, b[1], b[2]);  // so that each first corner is above the other's plane
  swap_where(!is_b_above, a[1], a[2]);
  const auto first = sign_of_determinant<S>(a[0], a[1], b[0], b[1]), second = sign_of_determinant<S>(a[0], a[2], b[2], b[0]);
  return decltype(first){first.is_positive || second.is_positive, first.is_negative && second.is_negative};
}

enum class Filtered : unsigned char { apart, meet, unknown };

// apart and meet are right for the given doubles. The answer is unknown for triangles that touch or nearly do, that lie in
// one plane, that are flat, or that are too small or too large for products of three of their lengths.
Filtered filter_triangles(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace refitlab
