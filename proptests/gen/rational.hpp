// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational numbers of a few digits, which shrink towards 0, then towards integers of either sign.
#pragma once

#include <rapidcheck.h>

#include "lemmas/exact/exact.hpp"
#include "proptests/gen/show.hpp"

namespace proptests::gen {

using refitlab::Rational;

// Draws an integer of [-3, 3] at size 0 up to [-28, 28] at size 100. Shrinks towards 0, a negative one also to its opposite.
rc::Gen<int> small_integer();
// Draws the same without 0 and without the sign; shrinks towards 1.
rc::Gen<int> small_positive_integer();

// Draws any rational with a small numerator and denominator: one in four is an integer, one in ten is 0.
rc::Gen<Rational> rational();
rc::Gen<Rational> positive_rational();
// Draws a rational in [0, 1], which is often one of the ends.
rc::Gen<Rational> unit_interval_rational();

// Draws 0, or a number down to 1/10^80 of either sign: enough to leave a tie for one that only long numbers can tell from it.
rc::Gen<Rational> nudge();

}  // namespace proptests::gen
