// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/ball_lists.hpp"

#include "proptests/gen/any_place.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weights.hpp"

namespace proptests::gen {

rc::Gen<BallList> ball_list(int most) {
  return rc::gen::exec([most] {
    const auto cloud = *gen::cloud<3>(most);
    const int radii = *between(0, 4);
    const Rational common = *positive_rational();
    BallList list{{}, is_degenerate(cloud.shape) || radii == 0};
    for (const auto& p : cloud.points)
      list.balls.push_back({p, radii == 0 ? Rational(0) : radii == 1 ? common : Rational(3) * *unit_interval_rational()});
    return list;
  });
}

RationalVec<3> hull_point(const RationalBalls& balls) {
  RationalVec<3> sum(0, 0, 0);
  const auto weights = *convex_weights(static_cast<int>(balls.size()));
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (weights[i] != 0) {
      const Rational depth = *rc::gen::element(Rational(1), Rational(1), Rational(1, 2));
      sum += (balls[i].center + *sphere_point<3>() * Rational(balls[i].radius * depth)) * weights[i];
    }
  return sum;
}

void showValue(const BallList& list, std::ostream& out) { rc::show(list.balls, out); }

}  // namespace proptests::gen
