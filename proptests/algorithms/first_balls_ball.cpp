// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/first_balls_ball.hpp"

#include <cmath>
#include <random>

#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"

namespace proptests::suite_first_balls_ball {
namespace {

using namespace refitlab;
using Balls = std::vector<Ball3<double>>;

double reach(const Balls& balls, const Vec<double, 3>& from) {
  double far = 0;
  for (const auto& b : balls) far = std::max(far, (b.center - from).norm() + b.radius);
  return far;
}

// Draws balls of radius 0, of one radius, of two, or of any. Some of them are copies, and in one case of four the first ball
// holds the second.
Balls draw(std::mt19937_64& random, int n, int radii) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Balls balls;
  for (const auto& p : gen::rounded_cloud<3>(random, static_cast<gen::Shape>(random() % gen::shape_count), n, 0)) {
    const double table[] = {0, 0.4, 0.2 * static_cast<double>(random() % 2), uniform(random)};
    balls.push_back({p, table[radii]});
  }
  if (random() % 4 == 0) balls[0].radius = (balls[1].center - balls[0].center).norm() + balls[1].radius;
  return balls;
}

}  // namespace

PROPTEST(first_balls_ball) {
  t.example(
      "a ball that is found holds all, no farther out than needed, and is at most 1 + slack times the smallest",
      {.number_type = "double"}, [] {
        std::mt19937_64 random(Session::get().seed());
        const long cases = Session::get().cases_for(40000);
        long found = 0;
        double largest = 1;
        for (long c = 0; c < cases; ++c) {
          const auto balls = draw(random, 2 + static_cast<int>(random() % 9), static_cast<int>(c % 4));
          const double slack = c % 3 ? 0.05 : 0.3;
          const auto near = first_balls_ball(balls, slack);
          if (!near) continue;
          ++found;
          const double smallest = smallest_ball_of_balls(balls).radius, rounding = 1e-13 * (1 + smallest);
          if (std::abs(reach(balls, near->center) - near->radius) > rounding || near->radius > smallest * (1 + slack) + rounding)
            return Checked(false, c, "case " + std::to_string(c));
          if (smallest > 1e-3) largest = std::max(largest, near->radius / smallest);
        }
        return Checked(10 * found > cases && largest > 1.05, cases,
                       std::to_string(found) + " found, at most " + std::to_string(largest) + " times the smallest");
      });
  t.example("of balls whose first two or three have the smallest ball of all, it is found", {.number_type = "double"}, [] {
    std::mt19937_64 random(Session::get().seed());
    std::uniform_real_distribution<double> uniform(0, 1);
    long seen = 0;
    for (int c = 0; c < 20000; ++c) {
      // There are three of one radius, or two of any.
      Balls balls = draw(random, 2 + c % 2, c % 2 ? 1 : 3);
      if (c % 2 && balls[0].radius != balls[1].radius) continue;
      const Ball3<double> all = smallest_ball_of_balls(balls);
      // These are inside, and have another radius.
      for (int more = c % 7; more > 0; --more) {
        Vec<double, 3> way(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
        const double radius = uniform(random) * all.radius;
        balls.push_back({all.center + way * (all.radius - radius), radius});
      }
      if (balls.size() > 2 && c % 2 == 0 && balls[0].radius == balls[1].radius) continue;
      const auto near = first_balls_ball(balls, 1e-9);
      if (!near || std::abs(near->radius - all.radius) > 1e-8 * (1 + all.radius))
        return Checked(false, seen, "case " + std::to_string(c));
      ++seen;
    }
    return Checked(seen > 10000, seen);
  });
  t.example("there is no ball of what is not finite or has a negative radius, wherever it stands", {.number_type = "double"}, [] {
    std::mt19937_64 random(Session::get().seed());
    for (int n = 2; n < 12; ++n)
      for (int at = 0; at < n; ++at)
        for (int kind = 0; kind < 5; ++kind)
          for (const int radii : {0, 1, 3}) {
            auto balls = draw(random, n, radii);
            Ball3<double>& bad = balls[at];
            if (kind == 0) bad.center[n % 3] = std::nan("");
            if (kind == 1) bad.center[n % 3] = INFINITY;
            if (kind == 2) bad.radius = std::nan("");
            if (kind == 3) bad.radius = INFINITY;
            if (kind == 4) bad.radius = -1;
            if (first_balls_ball(balls, 0.5)) return false;
          }
    return true;
  });
}

}  // namespace proptests::suite_first_balls_ball
