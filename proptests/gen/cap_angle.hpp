// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rational angles of [0, pi] as (cos, sin) = ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)).
#pragma once

#include "proptests/gen/rational.hpp"

namespace proptests::gen {

struct CapAngle {
  Rational cosine, sine;  // cosine^2 + sine^2 = 1, sine >= 0
};

// Draws an angle. 0, pi/2 and pi make up about a third; shrinks towards 0, then towards angles with small t.
rc::Gen<CapAngle> cap_angle();

void showValue(const CapAngle& angle, std::ostream& out);

}  // namespace proptests::gen
