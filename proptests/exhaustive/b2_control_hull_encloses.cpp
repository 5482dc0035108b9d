// SPDX-License-Identifier: GPL-3.0-or-later
// States how tight the control hull is for two joints with a least-squares rotation center.
//
// As in rotation_bound.cpp, two joints with an interval of weights are the quaternions 1 + y_1 n and 1 + y_2 n, y_2 = y_1 + d,
// with y_1, y_2 of [-1, 1]; where the relative rotation of the joints is t, both are in [-tan(t/4), tan(t/4)]. What the vertex
// has along the axis n moves with the rotation center, by h W_I-weighted means of 0 and 1: along the axis each control point is
// between the ends E_1 and E_2 of the motion. Let m be their middle, and let o be 0 or a vector across n. A control point's
// squared distance from m + o is that across the axis plus at most h^2 / 4. So if the control points across the axis are within K
// ||E_1 - E_2|| / 2 of m + o, K >= 1, then all are in space, too, for any h. So let h = 0, and let the vertex be (1, 0, 0), n
// being (0, 0, 1). The true motion has both ends in it. Any ball that holds them has the radius ||E_1 - E_2|| / 2 or more.
//
// For d <= 1/8 no subdivision is needed, as for any q_1 and q_2 at most 45 degrees apart (y_1 and y_2 are less than 7.2 degrees
// apart): let c = cos and s = sin of that angle, and l = ||q_2|| / ||q_1||. The control point of 1 1 2 is on the tangent at E_1,
// 2 l s / (1 + 2 l c) away from it. The chord E_1 E_2 is 2 s long and at the same angle from the tangent, so by Thales the point
// is in the ball over the chord if l / (1 + 2 l c) <= c, that is l (1 - 2 c^2) <= c, and 2 c^2 >= 1. That of 1 2 2 is the same
// with 1 / l. So K = 1 there.
//
// algorithms/runtime/refit/control_hull.hpp halves where (q_1, q_2) is at most half of the product of their lengths. Boxes that
// have both kinds of pairs are proved with and without the halving. Once halved, two joints are at most a quarter turn apart.
//
// For joints half a turn apart and all weights K = sqrt(17) / 4 = 1.0307764 is needed: the half circle has the control points (1,
// 0), (1, 1/2), (2/3, 1), (0, 1) and so on, and the smallest ball of these has its center at (0, 1/4).
#include "lemmas/b2_control_hull_encloses.hpp"

#include <algorithm>
#include <array>

#include "lemmas/b3_subdivision.hpp"
#include "proptests/exhaustive/theorems.hpp"

namespace proptests::exhaustive {
namespace {

using namespace refitlab;

using Places = std::vector<Vec<Interval, 3>>;

SphericalBlend<Interval> blend_of(const Interval& y1, const Interval& y2) {
  const Interval zero(0), one(1);
  const Vec<Interval, 3> none{zero, zero, zero};
  return {{{one, zero, zero, y1}, {one, zero, zero, y2}}, {none, none}, {one, zero, zero}};
}

Places places_of(const SphericalBlend<Interval>& blend) { return positions(control_points(blend)); }

// Returns the places from one end to the other, with the middle twice.
Places halved_places(const SphericalBlend<Interval>& blend) {
  Places out = places_of(half_of(blend, Half{0, 1}));
  const Places second = places_of(half_of(blend, Half{1, 0}));
  out.insert(out.end(), second.begin(), second.end());
  return out;
}

// Holds the ends of the true motion: what the blend itself makes of the vertex.
struct Ends {
  Vec<Interval, 3> first, last;
};

Vec<Interval, 3> place_at(const SphericalBlend<Interval>& blend, const std::array<Interval, 2>& u) {
  const ScaledPoint<Interval> at = blend.at(u);
  return at.numerator / at.denominator;
}

Ends ends_of(const SphericalBlend<Interval>& blend) {
  return {place_at(blend, {Interval(1), Interval(0)}), place_at(blend, {Interval(0), Interval(1)})};
}

// Judges whether all places are within k times half of the ends' distance from the point that is off their middle by this share
// of half of the distance, to the side to which the motion bends. The first and the last place are the ends, whose squared
// distance is 1 + offset^2 times that of the middle.
Judgement are_within(const Places& places, const Ends& ends, const Interval& k, const Interval& offset) {
  const Vec<Interval, 3> half = (ends.last - ends.first) / Interval(2), middle = (ends.first + ends.last) / Interval(2);
  const Vec<Interval, 3> center{middle[0] + half[1] * offset, middle[1] - half[0] * offset, middle[2]};
  const Interval allowed = sq(k) * squared_norm(half);
  Judgement worst = at_most(Interval(1) + sq(offset), sq(k));
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const Judgement found = at_most(squared_distance<Interval, 3>(places[i], center), allowed);
    if (found.outcome == Outcome::open) worst.outcome = Outcome::open;
    worst.excess = std::max(worst.excess, found.excess);
    worst.refuted = worst.refuted || found.refuted;
  }
  return worst;
}

Judgement control_points_are_in_ball_over_ends(std::span<const Interval> at, const Interval& k) {
  const Interval y2 = at[0] + at[1];
  if (fails(less_equal(y2, Interval(0.5625)))) return outside();
  const SphericalBlend<Interval> blend = blend_of(at[0], y2);
  return are_within(places_of(blend), ends_of(blend), k, Interval(0));
}

// Returns the best judgement for some balls, whose centers are off to the side by a few sixteenths of half of the distance.
Judgement are_within_some(const Places& places, const Ends& ends, const Interval& k) {
  Judgement best = are_within(places, ends, k, Interval(0));
  for (int sixteenths = 1; sixteenths <= 4 && best.outcome == Outcome::open; ++sixteenths) {
    const Judgement found = are_within(places, ends, k, Interval(sixteenths / 16.0));
    if (!(best.excess <= found.excess)) best = found;
  }
  best.refuted = false;  // Another ball may not be refuted.
  return best;
}

Judgement control_hull_is_tight(std::span<const Interval> at, const Interval& k) {
  const Interval y2 = at[0] + at[1];
  if (fails(less_equal(y2, Interval(1)))) return outside();
  const SphericalBlend<Interval> blend = blend_of(at[0], y2);
  const Interval lengths = squared_norm(blend.rotations[0]) * squared_norm(blend.rotations[1]);
  const Verdict is_near = less(lengths, Interval(Interval(4) * sq(dot(blend.rotations[0], blend.rotations[1]))));
  const Ends ends = ends_of(blend);
  Judgement out{Outcome::proved, 0};
  if (!fails(is_near)) out = are_within_some(places_of(blend), ends, k);
  if (!holds(is_near)) {
    const Judgement halved = are_within_some(halved_places(blend), ends, k);
    if (halved.outcome == Outcome::open) out.outcome = Outcome::open;
    out.excess = std::max(out.excess, halved.excess);
  }
  return out;
}

}  // namespace

std::vector<Theorem> theorems_of_control_hulls() {
  return {{"b2_control_hull_encloses.two_close",
           "For two joints up to 117 degrees apart with a least-squares rotation center, every interval of weights, every screw "
           "and every vertex: the smallest ball of the "
           "control points is the smallest ball of all places of the vertex (its radius is at most K times that one's).",
           {{"y1", -0.5625, 0.5625}, {"d", 0.125, 1.125}},
           1,
           1,
           1,
           control_points_are_in_ball_over_ends},
          {"b2_control_hull_encloses.two",
           "For two joints up to half a turn apart with a least-squares rotation center, every interval of weights, every screw "
           "and every vertex: the smallest ball of the "
           "control points, halved where algorithms/runtime/refit/control_hull.hpp halves, has at most K times the radius of the "
           "smallest ball of all places of the vertex.",
           {{"y1", -1, 1}, {"d", 0.125, 2}},
           1.0625,
           1 + 127 * 0x1p-12,
           1.0307764,
           control_hull_is_tight}};
}

}  // namespace proptests::exhaustive
