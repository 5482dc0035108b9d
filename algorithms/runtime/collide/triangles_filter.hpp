// SPDX-License-Identifier: MIT
// This is a quick test whether two triangles have a point in common, in double, in packs of doubles, or in packs of floats that
// are only near the vertices. It gives no answer where rounding or the error of the vertices might decide.
//
// It computes on which sides of each triangle's plane the other's vertices are. Where each triangle crosses the other's
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
//
// Vertices with errors. Let u = 2^-24 now, and let each coordinate differ by at most a slack, e / 2, from that of the vertex
// that counts. By how much that changes a determinant is in b10_determinant_error, whose bounds by extents and by slopes are
// taken here. X, Y, Z of the floats' exact differences are within 1 + u of the computed ones. Rounding has 67 u XYZ < 4.1e-6
// XYZ as above. By extents the code takes 1.017 times the lemma's bound and 6e-6 XYZ, which leaves more than a hundredth and a
// fourth for its own roundings. With X + Y + Z below 1e12 and the bound above 1e-28, six products of two that underflow have at
// most 1e-44 times a third difference each, below 1e-31, and nothing overflows. proptests/algorithms/float_budgets.cpp derives
// both.
//
// Slopes. They bound the errors several times more tightly, and take two more cross products for each determinant. The norms
// are computed of rounded differences, and lose less than 107 u (XY + YZ + ZX), which is below 6.4e-6 of this sum. The code
// takes 1e-5 with the slack, and a five hundredth more of all norms for its own roundings. For those of the determinant it
// takes 5e-6 XYZ. proptests/algorithms/float_budgets.cpp derives this, and triangles_filter.cpp there compares the whole with
// what a determinant loses if its vertices are off as far as they can be.
#pragma once

#include <array>

#include "lemmas/b10_determinant_error.hpp"

namespace refitlab {

template <class S>
using TriangleOf = std::array<Vec<S, 3>, 3>;
using TrianglePoints = TriangleOf<double>;

// A Sign is certain or not. Mask is bool, or a mask of lanes.
template <class Mask>
struct Sign {
  Mask is_positive, is_negative;
};

// The sign of a determinant of vertex differences is judged by the largest |differences| of coordinates. ExactVertices are the
// given numbers themselves.
template <class S>
struct ExactVertices {
  S error(const S& x, const S& y, const S& z) const { return x * y * z * S(1e-14); }
  auto are_in_range(const S& error, const S& x, const S& y, const S& z) const {
    return error > S(1e-200) && x + y + z < S(1e100);
  }
};
// NearVertices are floats within a slack of the vertices that count.
template <class S>
struct NearVertices {
  S twice_slack;

  S error(const S& x, const S& y, const S& z) const {
    const S& e = twice_slack;
    const S xy = x * y, sum = x + y;
    return S(1.017f) *
               (first_order_by_extents<S>(e, xy + z * sum) + (second_order_by_extents<S>(e, sum + z) + third_order<S>(e))) +
           S(6e-6f) * (xy * z);
  }
  auto are_in_range(const S& error, const S& x, const S& y, const S& z) const {
    return error > S(1e-28f) && x + y + z < S(1e12f);
  }
};

// These are such floats, too. It takes longer to judge determinants by their slopes, and leaves fewer of them open.
template <class S>
struct NearVerticesBySlopes : NearVertices<S> {
  // Returns what is added for all determinants of these extents.
  S error(const S& x, const S& y, const S& z) const {
    const S& e = this->twice_slack;
    const S xy = x * y, sum = x + y;
    return S(1.017f) * (second_order_by_extents<S>(e, sum + z) + third_order<S>(e)) +
           (S(5e-6f) * e * (xy + z * sum) + S(5e-6f) * (xy * z));
  }
  // Returns what the determinant of (p, q, r) is off by to first order. normal is p x q.
  S error_by_slopes(const Vec<S, 3>& p, const Vec<S, 3>& q, const Vec<S, 3>& normal, const Vec<S, 3>& r) const {
    return first_order_by_slopes<S>(S(0.501f) * this->twice_slack, sum_of_slopes<S>(cross<S>(q, r), cross<S>(r, p), normal));
  }
};

// DifferenceExtent has the largest |differences| by coordinate.
template <class S, class Vertices = ExactVertices<S>>
class DifferenceExtent {
 public:
  explicit DifferenceExtent(const Vertices& vertices = {}) : vertices_(vertices) {}
  void add(const Vec<S, 3>& difference) {
    using std::abs;
    for (int i = 0; i < 3; ++i) largest_[i] = max_of(largest_[i], S(abs(difference[i])));
  }
  S error() const { return vertices_.error(largest_[0], largest_[1], largest_[2]); }
  // Returns the error of the determinant of (p, q, r). normal is p x q, and error is error().
  S error_of(const S& error, const Vec<S, 3>& p, const Vec<S, 3>& q, const Vec<S, 3>& normal, const Vec<S, 3>& r) const {
    if constexpr (requires { vertices_.error_by_slopes(p, q, normal, r); })
      return error + vertices_.error_by_slopes(p, q, normal, r);
    else return error;
  }
  auto sign_of(const S& determinant, const S& error) const {
    const auto is_in_range = vertices_.are_in_range(error, largest_[0], largest_[1], largest_[2]);
    return Sign<decltype(determinant > error)>{is_in_range && determinant > error, is_in_range && determinant < -error};
  }
  auto sign_of(const S& determinant) const { return sign_of(determinant, error()); }

 private:
  Vertices vertices_;
  S largest_[3] = {S(0), S(0), S(0)};
};

// Returns the sign of the determinant of (b - a, c - a, d - a).
template <class S, class Vertices>
auto sign_of_determinant(const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c, const Vec<S, 3>& d,
                         const Vertices& vertices) {
  const Vec<S, 3> p = b - a, q = c - a, r = d - a;
  DifferenceExtent<S, Vertices> extent(vertices);
  extent.add(p), extent.add(q), extent.add(r);
  const Vec<S, 3> normal = cross<S>(p, q);
  return extent.sign_of(dot<S, 3>(normal, r), extent.error_of(extent.error(), p, q, normal, r));
}

// PlaneSides says on which sides of a triangle's plane another triangle's vertices are.
template <class S, class Vertices = ExactVertices<S>>
class PlaneSides {
 public:
  PlaneSides(const TriangleOf<S>& plane, const TriangleOf<S>& points, const Vertices& vertices = {}) : vertices_(vertices) {
    const Vec<S, 3> p = plane[1] - plane[0], q = plane[2] - plane[0], normal = cross<S>(p, q);
    const TriangleOf<S> r{points[0] - plane[0], points[1] - plane[0], points[2] - plane[0]};
    DifferenceExtent<S, Vertices> extent(vertices);  // of all, for all three
    extent.add(p), extent.add(q);
    for (const Vec<S, 3>& x : r) extent.add(x);
    const S error = extent.error();
    for (int i = 0; i < 3; ++i) distance_[i] = dot<S, 3>(normal, r[i]);
    for (int i = 0; i < 3; ++i) side_[i] = extent.sign_of(distance_[i], extent.error_of(error, p, q, normal, r[i]));
  }

  const Vertices& vertices() const { return vertices_; }
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
  Vertices vertices_;
  S distance_[3];  // scaled
  Sign<Mask> side_[3];
};

// Requires two triangles that certainly cross each other's planes. The crossings of each triangle with the shared line are
// an interval, and the triangles meet if neither interval begins after the other has ended. The sign is positive if they
// are apart, and negative if they meet.
template <class S, class Vertices>
auto sign_of_gap(const PlaneSides<S, Vertices>& of_a, const PlaneSides<S, Vertices>& of_b, TriangleOf<S> a, TriangleOf<S> b) {
  const auto swap_where = [](auto where, Vec<S, 3>& x, Vec<S, 3>& y) {
    const Vec<S, 3> was = x;
    x = choose(where, y, x), y = choose(where, was, y);
  };
  const auto is_a_above = of_a.turn(a), is_b_above = of_b.turn(b);
  swap_where(!is_a_above, b[1], b[2]);  // so that each first vertex is above the other's plane
  swap_where(!is_b_above, a[1], a[2]);
  const auto first = sign_of_determinant<S>(a[0], a[1], b[0], b[1], of_a.vertices()),
             second = sign_of_determinant<S>(a[0], a[2], b[2], b[0], of_a.vertices());
  return decltype(first){first.is_positive || second.is_positive, first.is_negative && second.is_negative};
}

// The filter says which pairs in a pack are certainly apart, and which certainly meet.
template <class Mask>
struct FilteredLanes {
  Mask are_apart, meet;
};
template <class S, class Vertices = ExactVertices<S>>
auto filter_lanes(const TriangleOf<S>& a, const TriangleOf<S>& b, const Vertices& vertices = {}) {
  using Mask = typename S::mask_type;
  const PlaneSides<S, Vertices> of_b(a, b, vertices);
  FilteredLanes<Mask> out{of_b.are_one(), Mask(false)};
  if (all_of(out.are_apart)) return out;
  const PlaneSides<S, Vertices> of_a(b, a, vertices);
  out.are_apart = out.are_apart || of_a.are_one();
  const Mask cross = !out.are_apart && of_a.are_certain() && of_b.are_certain();
  if (any_of(cross)) {
    const auto gap = sign_of_gap(of_a, of_b, a, b);
    out.are_apart = out.are_apart || (cross && gap.is_positive);
    out.meet = cross && gap.is_negative;
  }
  return out;
}

enum class Filtered : unsigned char { apart, meet, unknown };

// apart and meet are right for the given doubles. The answer is unknown for triangles that touch or nearly do, that lie in
// one plane, that are flat, or that are too small or too large for products of three of their lengths.
Filtered filter_triangles(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace refitlab
