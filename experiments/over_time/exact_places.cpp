// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/exact_places.hpp"

namespace refitlab {

using Interval = MultiprecisionInterval;

bool ExactPlaces::find(const Place& place) try {
  if (!is_posed_ || posed_.time != place.time || posed_.side != place.side) {
    is_posed_ = false;
    skin_.pose(place.time, place.side);
    posed_ = place, is_posed_ = true;
  }
  at_ = skin_.vertex(place.vertex);
  return true;
} catch (const proptests::oracle::Ambiguous&) {
  return false;
}

Verdict ExactPlaces::is_in(const Place& place, const Box<float>& box) {
  if (!find(place)) return Verdict::undecided;
  Verdict verdict = Verdict::holds;
  for (int i = 0; i < 3; ++i)
    verdict &= less_equal(Interval(box.low[i]), at_[i]) & less_equal(at_[i], Interval(box.high[i]));
  return verdict;
}

Verdict ExactPlaces::is_in(const Place& place, const Ball3<float>& ball) {
  if (!find(place)) return Verdict::undecided;
  Interval squared(0);
  for (int i = 0; i < 3; ++i) squared += sq(Interval(at_[i] - Interval(ball.center[i])));
  return less_equal(squared, sq(Interval(ball.radius)));
}

}  // namespace refitlab
