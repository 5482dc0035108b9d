// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of lemma5_cap_enclosing_sphere.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"

namespace proptests::lemma5 {

using Q = refitlab::Rational;
template <int D>
using Point = refitlab::Vec<Q, D>;
using Cap1 = refitlab::Cap<Q, 1>;
using Cap2 = refitlab::Cap<Q, 2>;

// With alpha beyond pi/2, the apex is at 8/5 from the printed center (-3/5, 0), and the printed radius is 4/5.
inline const Cap2 wide{Point<2>(0, 0), Point<2>(1, 0), Q(-3, 5)};

// The smallest case has alpha = pi. The cap is the whole circle, and the printed ball is the single point (-1, 0).
inline const Cap2 whole_circle{Point<2>(0, 0), Point<2>(1, 0), Q(-1)};

// An alpha just beyond pi/2 is enough.
inline const Cap2 hardly_wide{Point<2>(0, 0), Point<2>(1, 0), Q(-1, 1000000)};

// No angle has the cosine 5/4: there is no cap, and a squared radius of -9/16.
inline const Cap2 no_points{Point<2>(0, 0), Point<2>(1, 0), Q(5, 4)};

// In R^1 the half-circle is the point 1, and [-1, 1] is not the smallest ball around it.
inline const Cap1 on_a_line{Point<1>(Q(0)), Point<1>(Q(1)), Q(0)};
inline const refitlab::SquaredBall<Q, 1> point_on_a_line{Point<1>(Q(1)), Q(0)};

// In R^2 a direction that is not perpendicular, or a sine that does not belong to the cosine, gives no point of the
// rim.
inline const Cap2 narrow{Point<2>(0, 0), Point<2>(1, 0), Q(3, 5)};
inline const Point<2> perpendicular(0, 1), slanted(Q(3, 5), Q(4, 5));
inline const Q sine_of_narrow(4, 5), not_its_sine(3, 5);

}  // namespace proptests::lemma5
