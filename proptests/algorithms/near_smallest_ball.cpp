// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/methods/balls/near_smallest_ball.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"
#include "lemmas/exact/lift.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_near_smallest_ball {
namespace {

using namespace refitlab;
using Balls = std::vector<Ball3<double>>;

// Draws balls with centers of any shape of cloud. Their radii are 0, equal, or any; sometimes one ball holds all others, or one
// is there twice.
Balls draw(bool& degenerate) {
  const auto cloud = *gen::cloud<3>(12);
  const int radii = *rc::gen::element(0, 0, 0, 0, 0, 0, 1, 2, 3, 4);
  degenerate = gen::is_degenerate(cloud.shape) || radii != 0;
  Balls out;
  for (const auto& p : cloud.points)
    out.push_back({lift<double>(p), radii == 1 ? 0.0 : radii == 2 ? 0.5 : 3 * CGAL::to_double(*gen::unit_interval_rational())});
  if (radii == 3) out.front().radius = 1000;
  if (radii == 4) out.push_back(out.front());
  return out;
}

Ball3<Rational> exact(const Ball3<double>& b) { return {convert<Rational>(b.center), Rational(b.radius)}; }

// Returns half the longest edge of the balls' box. No ball around them has a smaller radius.
Rational half_extent(const Balls& balls) {
  Rational longest(0);
  for (int i = 0; i < 3; ++i) {
    Rational low = Rational(balls[0].center[i]) - Rational(balls[0].radius), high = low;
    for (const auto& b : balls) {
      low = std::min<Rational>(low, Rational(b.center[i]) - Rational(b.radius));
      high = std::max<Rational>(high, Rational(b.center[i]) + Rational(b.radius));
    }
    longest = std::max<Rational>(longest, (high - low) / 2);
  }
  return longest;
}

void each_step_goes_towards_the_farthest_ball(Suite& t) {
  t.example(
      "from the middle of the balls' box, each step goes the share 1/(i + 2) towards the ball that reaches farthest; the best is "
      "kept",
      {.number_type = "double"}, [] {
        std::mt19937_64 random(2006);
        std::uniform_real_distribution<double> uniform(0, 1);
        const auto reach = [](const Balls& balls, const Vec<double, 3>& from) {
          std::vector<double> out;
          for (const auto& b : balls) out.push_back((b.center - from).norm() + b.radius);
          return out;
        };
        long tried = 0;
        for (int c = 0; c < 300; ++c) {
          Balls balls;
          for (const auto& p : gen::rounded_cloud<3>(random, gen::Shape::general, 2 + c % 9, 0))
            balls.push_back({p, uniform(random)});
          Vec<double, 3> at, low = balls[0].center, high = low;
          for (const auto& b : balls)
            low = low.cwiseMin((b.center.array() - b.radius).matrix()),
            high = high.cwiseMax((b.center.array() + b.radius).matrix());
          at = (low + high) / 2;
          double best = INFINITY;
          for (int steps = 0; steps < 6; ++steps, ++tried) {
            const auto all = reach(balls, at);
            const auto farthest = std::max_element(all.begin(), all.end());
            best = std::min(best, *farthest);
            if (std::abs(near_smallest_ball<double>(balls, steps).radius - best) > 1e-12) return Checked(false, tried);
            at += (balls[farthest - all.begin()].center - at) / (steps + 2);
          }
        }
        return Checked(true, tried);
      });
}

}  // namespace

PROPTEST(near_smallest_ball) {
  const Options options{.number_type = "double", .cases = 1500, .degenerate_at_least = 0.5};
  t.holds("the ball encloses all balls up to 1e-15 of its radius, after any number of steps", options, [] {
    bool degenerate;
    const Balls balls = draw(degenerate);
    RC_CLASSIFY(degenerate, "degenerate");
    auto around = exact(near_smallest_ball<double>(balls, *rc::gen::inRange(0, 20)));
    around.radius *= Rational(1 + 1e-15);
    for (const auto& b : balls) RC_ASSERT(encloses(around, exact(b)) == Verdict::holds);
  });
  t.holds("its radius is between half the longest edge of the balls' box and sqrt(3) times that", options, [] {
    bool degenerate;
    const Balls balls = draw(degenerate);
    RC_CLASSIFY(degenerate, "degenerate");
    const Rational radius(near_smallest_ball<double>(balls, *rc::gen::inRange(0, 20)).radius), half = half_extent(balls);
    const Rational slack(1e-13);
    RC_ASSERT(radius >= half * (Rational(1) - slack));
    RC_ASSERT(radius * radius <= 3 * half * half * (Rational(1) + slack));
  });
  each_step_goes_towards_the_farthest_ball(t);
  t.holds("a further step never makes it larger", options, [] {
    bool degenerate;
    const Balls balls = draw(degenerate);
    RC_CLASSIFY(degenerate, "degenerate");
    double radius = near_smallest_ball<double>(balls, 0).radius;
    for (int steps = 1; steps <= 10; ++steps) {
      const double next = near_smallest_ball<double>(balls, steps).radius;
      RC_ASSERT(next <= radius);
      radius = next;
    }
  });
  t.holds("an interval's ball misses none of the balls for certain", {.number_type = "interval", .cases = 300}, [] {
    bool degenerate;
    std::vector<Ball3<Interval>> balls;
    for (const auto& b : draw(degenerate)) balls.push_back(lift<Interval>(exact(b)));
    const auto ball = near_smallest_ball<Interval>(balls, 5);
    for (const auto& b : balls) {
      RC_ASSERT(encloses(ball, b) != Verdict::fails);
      // The upper end of the radius encloses the balls from any center of the interval.
      const Interval reach = norm<Interval, 3>(b.center - ball.center) + b.radius;
      RC_ASSERT(reach.inf() <= ball.radius.sup());
    }
  });
  t.example("measured: eight steps come within a few percent of the smallest ball", {.number_type = "double"}, [] {
    std::mt19937_64 random(2006);
    double sum = 0, worst = 1;
    constexpr int count = 2000;
    for (int i = 0; i < count; ++i) {
      const auto points = gen::rounded_cloud<3>(random, gen::Shape::general, 2 + i % 30, 0);
      Balls balls;
      for (const auto& p : points) balls.push_back({p, 0.1});
      const double ratio = near_smallest_ball<double>(balls, 8).radius / smallest_ball_of_balls(balls).radius;
      sum += ratio;
      worst = std::max(worst, ratio);
    }
    char text[120];
    std::snprintf(text, sizeof text, "radius over that of the smallest ball: mean %.4f, worst %.4f", sum / count, worst);
    return Checked(sum / count < 1.05 && worst < 1.2, count, text);
  });
}

}  // namespace proptests::suite_near_smallest_ball
