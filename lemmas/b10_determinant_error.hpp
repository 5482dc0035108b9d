// SPDX-License-Identifier: MIT
// Beyond the paper: how far the determinant of four points can be off, if their coordinates are.
//
// Statement. Let p = b - a, q = c - a, r = d - a, and D = det(p, q, r) = (p x q, r), whose sign is the orientation predicate:
// on which side of the plane of a, b, c the point d is. Let D' be the determinant of points a', b', c', d' whose coordinates
// differ by at most h from these, and e = 2 h. Let x, y, z be at least the greatest |first|, |second| and |third| coordinate of
// p, q and r.
// (i) By extents,
//   |D' - D| <= 4 e (x y + y z + z x) + 3 e^2 (x + y + z) + 2 e^3.
// For all x, y, z and h there are points for which this is equal.
// (ii) By slopes, with |.| the sum of the absolute coordinates,
//   |D' - D| <= h s + 3 e^2 (x + y + z) + 2 e^3, s = |q x r| + |r x p| + |p x q| + |q x r + r x p + p x q|.
// (iii) h s <= 4 e (x y + y z + z x), so (ii) is never more than (i). It is much less where products cancel in the cross
// products.
// (iv) All points have others, with all coordinates off by just h, for which D' - D >= h s - 3 e^2 (x + y + z) - 2 e^3. So to
// first order the slopes are what D loses at worst.
// A number that is no farther from D than some l, and beyond (ii) plus l, has the sign of D'.
// h s alone is no bound: where all points are one, s is 0, and D' can be 2 e^3.
//
// Replaces: nothing in the paper, which looks at no triangles.
// Notation: h -> off, e -> twice_off, s -> slopes, x y + y z + z x -> products, x + y + z -> extents, D, D' -> determinant.
//
// Proof. Let the points be off by A, B, C and E. Then p, q and r are off by B - A, C - A and E - A: by up to e, but all by the
// same A. D' - D is a first part, (B, q x r) + (C, r x p) + (E, p x q) - (A, q x r + r x p + p x q), a second part,
// det(B - A, C - A, r) and two such, and a third part, det(B - A, C - A, E - A). The first is at most h s, and equal where the
// errors have the signs of the slopes. A coordinate of (B - A) x (C - A) is twice the area of a triangle in a square of the
// side e, so at most e^2, and each of three such determinants is at most e^2 (x + y + z). The third part is linear in the
// first coordinates of the errors. Its slopes are twice the areas of four triangles in that square, so it is at most 4 h e^2.
// (iii) The first coordinate of q x r is at most 2 y z, as are those of r x p and p x q. That of q x r + r x p = r x (p - q)
// is at most 4 y z, and so is that of all three, which is twice the area of a triangle in a rectangle of the sides 2 y and
// 2 z. A signed sum of the three and of their sum is twice one, two or three of them, so at most 8 y z. Three corners of a box
// with one minus each reach all: p = (-x, y, z), q = (x, -y, z), r = (x, y, -z), A = (-h, -h, -h), and B, C and E are h times
// the signs of p, q and r.
#pragma once

#include <array>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

// Returns the sum of the absolute coordinates.
template <class S>
S one_norm(const Vec<S, 3>& v) {
  return absolute<S>(v[0]) + absolute<S>(v[1]) + absolute<S>(v[2]);
}

// Returns s. by_b, by_c and by_d are q x r, r x p and p x q.
template <class S>
S sum_of_slopes(const Vec<S, 3>& by_b, const Vec<S, 3>& by_c, const Vec<S, 3>& by_d) {
  return (one_norm<S>(by_b) + one_norm<S>(by_c)) + (one_norm<S>(by_d) + one_norm<S>((by_b + by_c) + by_d));
}

// Returns what D is off by to first order, at most: by slopes, and by extents.
template <class S>
S first_order_by_slopes(const S& off, const S& slopes) {
  return off * slopes;
}
template <class S>
S first_order_by_extents(const S& twice_off, const S& products) {
  return S(4) * twice_off * products;
}
// Returns what it is off by to second and to third order, at most. Powers of e come first, as programs have one e for many D.
template <class S>
S second_order_by_extents(const S& twice_off, const S& extents) {
  return S(3) * twice_off * twice_off * extents;
}
template <class S>
S third_order(const S& twice_off) {
  return S(2) * twice_off * twice_off * twice_off;
}

// FourPoints are a, b, c and d.
template <class S>
using FourPoints = std::array<Vec<S, 3>, 4>;

// FourDifferences are p, q and r, and what is computed of them.
template <class S>
struct FourDifferences {
  Vec<S, 3> p, q, r;
  explicit FourDifferences(const FourPoints<S>& at) : p(at[1] - at[0]), q(at[2] - at[0]), r(at[3] - at[0]) {}
  Vec<S, 3> by_b() const { return cross<S>(q, r); }
  Vec<S, 3> by_c() const { return cross<S>(r, p); }
  Vec<S, 3> by_d() const { return cross<S>(p, q); }
  S slopes() const { return sum_of_slopes<S>(by_b(), by_c(), by_d()); }
};
template <class S>
S determinant_of(const FourPoints<S>& at) {
  const FourDifferences<S> of(at);
  return dot<S, 3>(of.by_d(), of.r);
}

// CoordinateErrors are h, and (x, y, z).
template <class S>
struct CoordinateErrors {
  S off;
  Vec<S, 3> extent;
  S twice_off() const { return S(2) * off; }
  S first_order(const FourPoints<S>& at) const { return first_order_by_slopes<S>(off, FourDifferences<S>(at).slopes()); }
  S first_order_by_extents() const {
    const S &x = extent[0], &y = extent[1], &z = extent[2];
    return refitlab::first_order_by_extents<S>(twice_off(), x * y + y * z + z * x);
  }
  S second_order() const { return second_order_by_extents<S>(twice_off(), extent[0] + extent[1] + extent[2]); }
  S third_order() const { return refitlab::third_order<S>(twice_off()); }
  // These are the bounds of (i) and (ii).
  S by_extents() const { return first_order_by_extents() + second_order() + third_order(); }
  S by_slopes(const FourPoints<S>& at) const { return first_order(at) + second_order() + third_order(); }
};

// --- Hypotheses ---

template <class S>
Verdict is_bounded_by(const S& x, const S& most) {
  return less_equal(S(-most), x) & less_equal(x, most);
}

// No coordinate is off by more than h.
template <class S>
Verdict are_off_at_most(const FourPoints<S>& at, const FourPoints<S>& moved, const S& off) {
  Verdict v = Verdict::holds;
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) v &= is_bounded_by<S>(moved[k][i] - at[k][i], off);
  return v;
}

template <class S>
Verdict are_extents(const FourPoints<S>& at, const Vec<S, 3>& extent) {
  Verdict v = Verdict::holds;
  for (int k = 1; k < 4; ++k)
    for (int i = 0; i < 3; ++i) v &= is_bounded_by<S>(at[k][i] - at[0][i], extent[i]);
  return v;
}

// All that is asked of the points.
template <class S>
Verdict are_coordinate_errors(const FourPoints<S>& at, const FourPoints<S>& moved, const CoordinateErrors<S>& errors) {
  return are_off_at_most<S>(at, moved, errors.off) & are_extents<S>(at, errors.extent);
}

// --- Conclusion of (i) and (ii) ---

// The witness splits D' - D by order.
template <class S>
struct DeterminantChange {
  Verdict verdict;
  S first, second, third;
};

// Checks the witness independently: each part is within its bound, and where the errors are t times as large, D changes by
// t first + t^2 second + t^3 third. No other parts do so for three t.
template <class S>
Verdict is_determinant_change(const FourPoints<S>& at, const FourPoints<S>& moved, const CoordinateErrors<S>& errors,
                              const DeterminantChange<S>& witness) {
  Verdict v = is_bounded_by<S>(witness.first, errors.first_order(at)) & is_bounded_by<S>(witness.second, errors.second_order()) &
              is_bounded_by<S>(witness.third, errors.third_order());
  for (const int times : {1, -1, 2}) {
    const S t(times);
    FourPoints<S> farther = at;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) farther[k][i] = at[k][i] + t * (moved[k][i] - at[k][i]);
    v &= equal(S(t * (witness.first + t * (witness.second + t * witness.third))),
               S(determinant_of<S>(farther) - determinant_of<S>(at)));
  }
  return v;
}

template <class S>
DeterminantChange<S> determinant_change(const FourPoints<S>& at, const FourPoints<S>& moved, const CoordinateErrors<S>& errors) {
  const FourDifferences<S> of(at);
  const Vec<S, 3> a = moved[0] - at[0], b = moved[1] - at[1], c = moved[2] - at[2], d = moved[3] - at[3];
  const Vec<S, 3> p = b - a, q = c - a, r = d - a;
  const auto triple = [](const Vec<S, 3>& u, const Vec<S, 3>& v, const Vec<S, 3>& w) { return dot<S, 3>(cross<S>(u, v), w); };
  DeterminantChange<S> out{Verdict::undecided, dot<S, 3>(p, of.by_b()) + dot<S, 3>(q, of.by_c()) + dot<S, 3>(r, of.by_d()),
                           triple(p, q, of.r) + triple(q, r, of.p) + triple(r, p, of.q), triple(p, q, r)};
  out.verdict = is_determinant_change<S>(at, moved, errors, out);
  return out;
}

// Judges the bounds for D and D'.
template <class S>
Verdict changes_by_extents(const S& determinant, const S& now, const CoordinateErrors<S>& errors) {
  return is_bounded_by<S>(now - determinant, errors.by_extents());
}
template <class S>
Verdict changes_by_slopes(const FourPoints<S>& at, const S& now, const CoordinateErrors<S>& errors) {
  return is_bounded_by<S>(now - determinant_of<S>(at), errors.by_slopes(at));
}

// Judges what programs use: a number that lost at most l of D, and is beyond the bound and l, has the sign of D'.
template <class S>
Verdict keeps_sign(const S& computed, const S& bound, const S& lost, const S& now) {
  const S most = bound + lost;
  return implies(less(most, computed), less(S(0), now)) & implies(less(computed, S(-most)), less(now, S(0)));
}

// --- Conclusion of (iii) ---

template <class S>
Verdict slopes_are_within_extents(const FourPoints<S>& at, const CoordinateErrors<S>& errors) {
  return less_equal(errors.first_order(at), errors.first_order_by_extents());
}

// --- Conclusion of (iv) ---

// Returns points that are off as the signs of the slopes say.
template <class S>
FourPoints<S> steepest_points(const FourPoints<S>& at, const S& off) {
  const FourDifferences<S> of(at);
  const Vec<S, 3> by_b = of.by_b(), by_c = of.by_c(), by_d = of.by_d(), by_a = -(by_b + by_c + by_d);
  FourPoints<S> moved = at;
  for (int i = 0; i < 3; ++i) {
    const S slopes[] = {by_a[i], by_b[i], by_c[i], by_d[i]};
    for (int k = 0; k < 4; ++k) moved[k][i] = at[k][i] + (less(slopes[k], S(0)) == Verdict::holds ? S(-off) : off);
  }
  return moved;
}

// Judges whether points are off by just h, and D loses as much as the slopes say.
template <class S>
Verdict reaches_slopes(const FourPoints<S>& at, const FourPoints<S>& moved, const CoordinateErrors<S>& errors) {
  Verdict v = less_equal(S(errors.first_order(at) - errors.second_order() - errors.third_order()),
                         S(determinant_of<S>(moved) - determinant_of<S>(at)));
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) v &= equal(absolute<S>(moved[k][i] - at[k][i]), errors.off);
  return v;
}

// Returns the points that reach the bound by extents: off is 0 for a, b, c, d, and h for the others.
template <class S>
FourPoints<S> box_corners(const Vec<S, 3>& extent, const S& off) {
  FourPoints<S> at;
  for (int i = 0; i < 3; ++i) {
    at[0][i] = -off;
    for (int k = 1; k < 4; ++k) at[k][i] = k == i + 1 ? S(-(extent[i] + off)) : S(extent[i] + off);
  }
  return at;
}

// --- Erratum: the slopes alone ---

// Judges what the first order suggests. Points that are one have no slopes.
template <class S>
Verdict changes_by_slopes_alone(const FourPoints<S>& at, const S& now, const CoordinateErrors<S>& errors) {
  return is_bounded_by<S>(now - determinant_of<S>(at), errors.first_order(at));
}

}  // namespace refitlab

// Sources: none.
// Used by: algorithms/runtime/collide/triangles_filter.hpp, experiments/drawings/determinants.cpp.
