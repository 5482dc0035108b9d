// SPDX-License-Identifier: GPL-3.0-or-later
// States Lemma 5, repaired, for all angles: the ball holds the cap. The radius of the sphere is 1, and its center 0: the
// statement does not change when all is moved, turned or scaled.
//
// The parameters are the versine v = 1 - cos alpha, which takes all values for angles of [0, pi], and the versine of x as a share
// s of it: the points of the cap are those with 1 - (x, a) = s v, s in [0, 1]. In the plane of a and x they are (1 - s v,
// +-sqrt(s v (2 - s v))), and the ball's center is on the axis, so two dimensions are enough.
//
// The points of the rim are on the ball's surface, so intervals prove the statement with a factor K above 1 only, and 2^-20 for
// the cap that is a point. The lemma itself is proved in Coq without either; this shows that the formula that runs is the one of
// that proof.
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

#include "proptests/exhaustive/theorems.hpp"

namespace proptests::exhaustive {
namespace {

using namespace refitlab;

Judgement cap_is_held(std::span<const Interval> at, const Interval& k) {
  const Interval versine = at[0], height = at[1] * versine;
  const Cap<Interval, 2> cap{{Interval(0), Interval(0)}, {Interval(1), Interval(0)}, Interval(1) - versine};
  const Vec<Interval, 2> x{Interval(1) - height, root(Interval(height * (Interval(2) - height)))};
  const SquaredBall<Interval, 2> ball = cap_ball_repaired(cap);
  return at_most(squared_distance<Interval, 2>(x, ball.center), k * ball.squared_radius + Interval(0x1p-20));
}

}  // namespace

std::vector<Theorem> theorems_of_lemma5() {
  return {{"lemma5_cap_enclosing_sphere.holds",
           "For all angles alpha of [0, pi] and all points x of the cap of the unit sphere: the squared distance of x from the "
           "center of the "
           "repaired ball is at most K times its squared radius, plus 2^-20.",
           {{"v", 0, 2, true}, {"s", 0, 1}},
           1 + 0x1p-5,
           1 + 0x1p-7,
           1,
           cap_is_held}};
}

}  // namespace proptests::exhaustive
