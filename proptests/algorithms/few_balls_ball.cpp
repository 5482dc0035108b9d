// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/few_balls_ball.hpp"

#include <array>
#include <cmath>
#include <random>

#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_few_balls_ball {
namespace {

using namespace refitlab;
using gen::Shape;
using Balls = std::vector<Ball3<double>>;

// There are seven kinds: radii that are zero, equal, few, any, almost equal, or such that the first ball nearly holds all.
constexpr int radius_kinds = 7;
Balls draw(std::mt19937_64& random, Shape shape, int radii, int n, double offset) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double measure = std::pow(10.0, -static_cast<double>(random() % 12));
  Balls balls;
  for (const auto& center : gen::rounded_cloud<3>(random, shape, n, offset)) {
    const double u = uniform(random);
    const double table[radius_kinds] = {
        0, 0.5, 0.1 * static_cast<double>(random() % 3), u, 3 * u, 1 - measure * u, balls.empty() ? 10 : measure * u};
    balls.push_back({center, table[radii]});
  }
  return balls;
}

std::vector<Ball<Rational, 3>> exact(const Balls& balls) {
  std::vector<Ball<Rational, 3>> out;
  for (const auto& b : balls) out.push_back({convert<Rational>(b.center), Rational(b.radius)});
  return out;
}

double size_of(const Balls& balls) {
  double size = 0;
  for (const auto& b : balls) size = std::max({size, b.center.cwiseAbs().maxCoeff(), b.radius});
  return size;
}

// Says whether what needs no exact numbers is right: the coefficients' form, the center as their combination, the support
// touching the ball, and the radius as others would compute it.
bool is_certified(const Balls& balls, const SmallestBallOfBalls& found) {
  const double slack = 1e-12 * found.ball.radius + 16 * size_of(balls) * 0x1p-52;
  double sum = 0, far = 0;
  Vec<double, 3> mean = Vec<double, 3>::Zero();
  for (int k = 0; k < found.support_size; ++k) {
    const auto& b = balls.at(found.support[k]);
    if (!(found.coefficients[k] >= 0) || norm<double, 3>(b.center - found.ball.center) + b.radius < found.ball.radius - slack)
      return false;
    sum += found.coefficients[k];
    mean = mean + (b.center - balls[0].center) * found.coefficients[k];
  }
  for (const auto& b : balls) far = std::max(far, norm<double, 3>(b.center - found.ball.center) + b.radius);
  return std::abs(sum - 1) < 1e-14 && norm<double, 3>(balls[0].center + mean - found.ball.center) <= slack &&
         far == found.ball.radius;
}

// Says whether no ball that encloses the support alone is smaller by more than 1e-7, by vectors that add up to nothing.
bool is_within(const Balls& balls, const SmallestBallOfBalls& found) {
  Balls support;
  for (int k = 0; k < found.support_size; ++k) support.push_back(balls[found.support[k]]);
  const Rational low = oracle::radius_at_least(support, found.ball.center), radius(found.ball.radius);
  return low >= radius * Rational(1 - 1e-7) - Rational(size_of(balls) * 0x1p-40) && low <= radius * Rational(1 + 1e-14);
}

bool is_smallest(const Balls& balls, double radius) {
  const auto optimum = oracle::smallest_ball_by_cgal<3>(exact(balls)).radius;
  const double slack = 1e-12 * radius + size_of(balls) * 0x1p-50;
  return !(optimum < Rational(radius) - Rational(slack)) && optimum < Rational(radius) + Rational(slack + 1e-300);
}

void the_smallest_ball_and_its_certificate(Suite& t) {
  t.example("without its certificate the ball is the same, to the last digit, and undefined where it is",
            {.number_type = "double"}, [] {
              std::mt19937_64 random(2006);
              std::normal_distribution<double> normal;
              long seen = 0;
              for (int round = 0; round < 20000; ++round) {
                std::vector<Ball3<double>> balls(1 + random() % 5);
                const double radius = round % 3 == 0 ? 0 : std::abs(normal(random));
                for (auto& b : balls)
                  b = {{normal(random), normal(random), normal(random)}, round % 2 ? radius : std::abs(normal(random))};
                if (round % 7 == 0) balls[random() % balls.size()].center[random() % 3] = round % 14 ? NAN : INFINITY;
                if (round % 11 == 0) balls[random() % balls.size()].radius = round % 22 ? -1 : INFINITY;
                const Ball3<double> a = few_balls_ball(balls).ball, b = few_balls_enclosing(balls);
                const bool undefined = std::isnan(a.radius) && a.center.array().isNaN().all();
                if (undefined ? !(std::isnan(b.radius) && b.center.array().isNaN().all())
                              : !(a.center == b.center && a.radius == b.radius))
                  return Checked(false, seen, "round " + std::to_string(round));
                ++seen;
              }
              return Checked(true, seen);
            });
  t.example("the radius is within 1e-12 of what CGAL's exact solver finds: all shapes and radii, 1 to 12 balls",
            {.number_type = "rational"}, [] {
              std::mt19937_64 random(Session::get().seed());
              const long cases = Session::get().cases_for(2000);
              for (long c = 0; c < cases; ++c) {
                const auto balls =
                    draw(random, static_cast<Shape>(random() % gen::shape_count), static_cast<int>(c % radius_kinds),
                         1 + static_cast<int>(random() % 12), c % 3 == 0 ? 1e3 : 0);
                if (!is_smallest(balls, few_balls_ball(balls).ball.radius)) return Checked(false, c, "case " + std::to_string(c));
              }
              return Checked(true, cases);
            });
  t.example("the certificate proves the ball, and CGAL hardly ever takes over: all shapes and radii, 1 to 70 balls",
            {.number_type = "double"}, [] {
              std::mt19937_64 random(Session::get().seed() + 1);
              const long cases = Session::get().cases_for(60000);
              long fallbacks = 0, pivots = 0;
              for (long c = 0; c < cases; ++c) {
                const auto balls =
                    draw(random, static_cast<Shape>(random() % gen::shape_count), static_cast<int>(c % radius_kinds),
                         1 + static_cast<int>(random() % (c % 50 == 0 ? 70 : 20)),
                         c % 3 == 0   ? 0
                         : c % 3 == 1 ? 1e3
                                      : 1e7);
                const auto found = few_balls_ball(balls);
                pivots += found.pivots;
                if (found.support_size == 0) ++fallbacks;
                else if (!is_certified(balls, found) || (c % 60 == 0 && !is_within(balls, found)))
                  return Checked(false, c, "case " + std::to_string(c));
              }
              return Checked(1000 * fallbacks <= cases, cases,
                             std::to_string(fallbacks) + " fallbacks, " +
                                 std::to_string(static_cast<double>(pivots) / static_cast<double>(cases)) + " pivots on average");
            });
}

void slacks_equal_radii_and_few_or_many_balls(Suite& t) {
  t.example("with a slack the ball holds all and is at most so much larger than the smallest, with fewer pivots",
            {.number_type = "double"}, [] {
              std::mt19937_64 random(Session::get().seed() + 2);
              const long cases = Session::get().cases_for(20000);
              long pivots = 0, all_pivots = 0;
              double largest = 1;
              for (long c = 0; c < cases; ++c) {
                const auto balls =
                    draw(random, static_cast<Shape>(random() % gen::shape_count), static_cast<int>(c % radius_kinds),
                         1 + static_cast<int>(random() % (c % 50 == 0 ? 600 : 20)), c % 3 == 0 ? 0 : 1e3);
                const double slack = c % 2 ? 0.05 : 0.3, rounding = 1e-12 * size_of(balls);
                const auto smallest = few_balls_ball(balls), near = few_balls_ball(balls, slack);
                double far = 0;
                for (const auto& b : balls) far = std::max(far, norm<double, 3>(b.center - near.ball.center) + b.radius);
                if (near.ball.radius < far - rounding || near.ball.radius > far + rounding ||
                    near.ball.radius < smallest.ball.radius - rounding ||
                    near.ball.radius > smallest.ball.radius * (1 + slack) + rounding)
                  return Checked(false, c, "case " + std::to_string(c));
                if (smallest.ball.radius > 1e-3) largest = std::max(largest, near.ball.radius / smallest.ball.radius);
                pivots += near.pivots, all_pivots += smallest.pivots;
              }
              return Checked(2 * pivots < all_pivots && largest > 1.05, cases,
                             std::to_string(pivots) + " pivots in place of " + std::to_string(all_pivots) + ", at most " +
                                 std::to_string(largest) + " times the smallest");
            });
  t.example("balls of equal radii have the ball of their centers, and that much more", {.number_type = "double"}, [] {
    std::mt19937_64 random(Session::get().seed());
    for (int c = 0; c < 2000; ++c) {
      const auto points = gen::rounded_cloud<3>(random, static_cast<Shape>(c % gen::shape_count), 1 + c % 20, 0);
      Balls balls;
      for (const auto& p : points) balls.push_back({p, 0.75});
      const auto found = few_balls_ball(balls);
      const auto center = as_ball(few_points_ball<double, 3>(points));
      if (found.support_size == 0 || std::abs(found.ball.radius - center.radius - 0.75) > 1e-14 * found.ball.radius) return false;
    }
    return true;
  });
  t.example("one ball, a ball in a ball, two that touch, two points, and one that only two others push out",
            {.number_type = "double"}, [] {
              const Ball3<double> a{{1, 2, 3}, 4}, inside{{1, 2, 4}, 1}, left{{-1, 0, 0}, 1}, right{{1, 0, 0}, 0.5};
              const Ball3<double> p{{-3, 0, 0}, 0}, q{{3, 0, 0}, 0}, above{{0, 3.5, 0}, 0.5}, below{{0, -3.5, 0}, 0.25};
              const auto is = [](Balls balls, const Ball3<double>& expected) {
                const auto ball = few_balls_ball(balls).ball;
                return (ball.center - expected.center).norm() < 1e-14 && std::abs(ball.radius - expected.radius) < 1e-14;
              };
              return is({a}, a) && is({a, inside}, a) && is({inside, a, a}, a) && is({left, right}, {{-0.25, 0, 0}, 1.75}) &&
                     is({p, q}, {{0, 0, 0}, 3}) && is({above, p, q, below}, {{0, 0.125, 0}, 3.875});
            });
  t.example("a ball that holds all others is found from two that are farther apart than it is from them",
            {.number_type = "double"}, [] {
              const Balls balls{{{0, 0, 0}, 0}, {{14, 0, 0}, 0}, {{7, 5, 0}, 10}};
              const auto found = few_balls_ball(balls);
              return found.support_size == 1 && found.support[0] == 2 && found.ball.radius == 10;
            });
  t.example("beyond 4096 balls the ball is CGAL's", {.number_type = "double"}, [] {
    std::mt19937_64 random(Session::get().seed());
    for (const int n : {512, 513, 4096, 4097}) {
      const auto balls = draw(random, Shape::general, 3, n, 0);
      const auto found = few_balls_ball(balls);
      const auto other = smallest_ball_of_balls(balls);
      if ((found.support_size == 0) != (n > 4096) || std::abs(found.ball.radius - other.radius) > 1e-12) return false;
    }
    return true;
  });
}

// Checks that lists of balls, of which the first, the middle or the last is undefined, have no ball. It tries all lists of up to
// 40 balls, and those on either side of a switch.
Checked lists_with_a_ball_that_is_undefined() {
  std::mt19937_64 random(Session::get().seed());
  std::vector<int> counts = {512, 513, 4096, 4097};
  for (int n = 1; n <= 40; ++n) counts.push_back(n);
  const auto is_undefined = [](const Ball3<double>& ball) {
    return std::isnan(ball.radius) && ball.center.array().isNaN().all();
  };
  long tried = 0;
  for (const int n : counts)
    for (const int radii : {1, 3}) {
      const Balls balls = draw(random, Shape::general, radii, n, 0);
      for (int kind = 0; kind < 6; ++kind)
        for (const int place : {0, n / 2, n - 1})
          for (const double slack : {0.0, 0.05}) {
            Balls list = balls;
            Ball3<double>& bad = list[place];
            if (kind < 3) bad.center[(n + place) % 3] = std::array<double, 3>{std::nan(""), INFINITY, -INFINITY}[kind];
            else bad.radius = std::array<double, 3>{std::nan(""), INFINITY, -1}[kind - 3];
            const auto found = few_balls_ball(list, slack);
            ++tried;
            if (!is_undefined(found.ball) || found.support_size != 0 || !is_undefined(few_balls_enclosing(list, slack)))
              return Checked(false, tried,
                             std::to_string(n) + " balls, kind " + std::to_string(kind) + " at " + std::to_string(place));
          }
    }
  return Checked(true, tried);
}

}  // namespace

PROPTEST(few_balls_ball) {
  the_smallest_ball_and_its_certificate(t);
  slacks_equal_radii_and_few_or_many_balls(t);
  t.example("balls of which one is undefined have an undefined ball, whatever the number of them and wherever it is",
            {.number_type = "double"}, [] { return lists_with_a_ball_that_is_undefined(); });
}

}  // namespace proptests::suite_few_balls_ball
