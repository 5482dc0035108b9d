// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/exact_places.hpp"

namespace refitlab {

using Interval = MultiprecisionInterval;

const std::optional<ExactPlaces::Point>& ExactPlaces::at(const Place& place) {
  const auto [found, is_new] = known_.try_emplace({place.time, place.side, place.vertex}, std::nullopt);
  if (is_new) try {
      if (const std::pair moment{place.time, place.side}; posed_ != moment) {
        posed_.reset();
        skin_.pose(place.time, place.side);
        posed_ = moment;
      }
      found->second = skin_.vertex(place.vertex);
    } catch (const proptests::oracle::Ambiguous&) {
    }
  return found->second;
}

Verdict ExactPlaces::is_in(const Place& place, const Box<float>& box) {
  const std::optional<Point>& x = at(place);
  if (!x) return Verdict::undecided;
  Verdict verdict = Verdict::holds;
  for (int i = 0; i < 3; ++i) verdict &= less_equal(Interval(box.low[i]), (*x)[i]) & less_equal((*x)[i], Interval(box.high[i]));
  return verdict;
}

Verdict ExactPlaces::is_in(const Place& place, const Ball3<float>& ball) {
  const std::optional<Point>& x = at(place);
  if (!x) return Verdict::undecided;
  Interval squared(0);
  for (int i = 0; i < 3; ++i) squared += sq(Interval((*x)[i] - Interval(ball.center[i])));
  return less_equal(squared, sq(Interval(ball.radius)));
}

}  // namespace refitlab
