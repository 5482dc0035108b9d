// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b10_determinant_error: points whose slopes say less than their determinant loses.
#pragma once

#include "lemmas/b10_determinant_error.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b10 {

using Q = refitlab::Rational;
using Points = refitlab::FourPoints<Q>;
using Errors = refitlab::CoordinateErrors<Q>;

// All points are one, and go to corners of a cube that are no neighbours: the slopes are 0, and the determinant is 16.
inline const Points one_point{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
inline const Points cube_corners{{{-1, -1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}};
inline const Errors of_one_point{1, {0, 0, 0}};
inline const Q of_cube(16);

// The determinant of these is 4, and their slopes are 24. Where each coordinate is off by 1/2, the determinant becomes 27.
inline const Points corners{{{0, 0, 0}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}};
inline const Q half(1, 2), longer(3, 2);
inline const Points grown{
    {{-half, -half, -half}, {-longer, longer, longer}, {longer, -longer, longer}, {longer, longer, -longer}}};
inline const Errors of_corners{half, {1, 1, 1}};
inline const Q before(4), slopes(24), after(27);

// Four points of a plane whose determinant, of 0, becomes positive or negative where d is off by a little.
inline const Q off(1, 10);
inline const Points flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
inline const Points above{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, off}}};
inline const Points below{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, -off}}};
inline const Errors of_flat{off, {1, 1, 0}}, not_off{0, {1, 1, 0}}, too_short{half, {1, 1, half}};

}  // namespace proptests::b10
