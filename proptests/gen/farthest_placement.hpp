// SPDX-License-Identifier: GPL-3.0-or-later
// Draws placements so far away that sums and differences of their coordinates overflow.
#pragma once

#include <cmath>
#include <iterator>
#include <limits>

#include "proptests/gen/random_pose.hpp"

namespace proptests::gen {

inline refitlab::RigidTransform<double> farthest_placement(std::mt19937& random) {
  constexpr double largest = std::numeric_limits<double>::max();
  refitlab::RigidTransform<double> out{random_rotation(random, 1), {}};
  const double lengths[] = {largest, std::nextafter(largest, 0), 1.797e308, 0x1p1023, 1e308, 1e300, 0.3};
  for (int i = 0; i < 3; ++i) out.translation[i] = lengths[random() % std::size(lengths)] * (random() % 4 ? 1 : -1);
  return out;
}

}  // namespace proptests::gen
