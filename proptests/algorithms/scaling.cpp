// SPDX-License-Identifier: GPL-3.0-or-later
// Tests balls of clouds of every size, from the least denormal to the largest squares. They are those of a cloud of size 1, but
// for the underflow that rounded_up adds, and no finite cloud has a center or a radius that is not a number.
#include "algorithms/runtime/balls/scaling.hpp"

#include <cmath>
#include <random>

#include "algorithms/methods/volumes/box_orientation.hpp"
#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/balls/first_balls_ball.hpp"
#include "algorithms/runtime/balls/mean_ball.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"

namespace proptests::suite_scaling {
namespace {

using namespace refitlab;
using Balls = std::vector<Ball3<double>>;

template <class S, int D>
Ball<Rational, D> exact(const Ball<S, D>& b) {
  return {convert<Rational>(Vec<double, D>(b.center.template cast<double>())), Rational(double(b.radius))};
}

template <class S, int D>
bool is_finite(const Ball<S, D>& b) {
  return b.center.allFinite() && std::isfinite(b.radius) && b.radius >= 0;
}

// Says whether the ball encloses all once it is raised by what rounding and underflow may have taken.
template <class S, int D>
bool holds_all(const Ball<S, D>& ball, std::span<const Ball<S, D>> balls) {
  const auto around = exact(rounded_up(ball));
  for (const auto& b : balls)
    if (encloses(around, exact(b)) != Verdict::holds) return false;
  return true;
}

// Returns an exponent from that of the least denormal to 132, which stands for 1e40, or in float to that whose squares of
// differences do not overflow.
template <class S>
int any_exponent(std::mt19937_64& random) {
  constexpr int least = std::is_same_v<S, double> ? -1074 : -149, greatest = std::is_same_v<S, double> ? 132 : 58;
  return least + static_cast<int>(random() % (greatest - least + 1));
}

// Returns points about the origin, where no rounding but that of denormals changes them when they are made smaller or larger.
template <class S, int D>
std::vector<Vec<S, D>> cloud_of_size_one(std::mt19937_64& random, int n) {
  std::vector<Vec<S, D>> out;
  for (const auto& p : gen::rounded_cloud<D>(random, static_cast<gen::Shape>(random() % gen::shape_count), n, 0))
    out.push_back(p.template cast<S>());
  return out;
}

// Returns the cloud times 2^by, and the same back at about the size 1: the digits that denormals lose are lost in both.
template <class S, int D>
std::pair<std::vector<Vec<S, D>>, std::vector<Vec<S, D>>> of_size(std::vector<Vec<S, D>> cloud, int by) {
  std::vector<Vec<S, D>> small;
  for (auto& p : cloud) {
    small.push_back(times_power_of_two(p, by));
    p = times_power_of_two(small.back(), -by);
  }
  return {small, cloud};
}

// Says whether a radius is that of the same cloud of size 1, scaled. Where squares of distances underflow, the slack for that is
// allowed.
template <class S>
bool is_as_small(S radius, S of_size_one, int by, S size, S relative = S(1e4) * std::numeric_limits<S>::epsilon()) {
  const S expected = std::scalbn(of_size_one, by);
  return std::abs(radius - expected) <= relative * std::max(radius, expected) +
                                            4 * std::numeric_limits<S>::epsilon() * std::scalbn(size, by) +
                                            underflow_of_distance<S>();
}

template <class S, int D>
void points_of_every_size(Suite& t, const std::string& space) {
  t.example(
      "the balls of points of any size hold them exactly, and are those of points of size 1" + space,
      {.number_type = sizeof(S) == 8 ? "double" : "float"}, [] {
        std::mt19937_64 random(Session::get().seed());
        const long cases = Session::get().cases_for(20000);
        for (long c = 0; c < cases; ++c) {
          const int n = c % 4 == 0 ? 3 : 1 + static_cast<int>(random() % (c % 50 == 0 ? 40 : 12)), by = any_exponent<S>(random);
          const auto [small, one] = of_size<S, D>(cloud_of_size_one<S, D>(random, n), by);
          std::vector<Ball<S, D>> balls;
          S size(0);
          for (const auto& p : small) balls.push_back({p, S(0)});
          for (const auto& p : one) size = std::max(size, p.cwiseAbs().maxCoeff());
          const auto all = [](const auto& p) { return std::span<const Vec<S, D>>(p); };
          const auto found = as_ball(few_points_ball<S, D>(all(small))), expected = as_ball(few_points_ball<S, D>(all(one)));
          const auto walked = as_ball(smallest_ball<S, D>(all(small))), walked_one = as_ball(smallest_ball<S, D>(all(one)));
          const auto mean = mean_ball<S, D>(all(small));
          for (const auto& ball : {found, walked, mean})
            if (!is_finite(ball) || !holds_all<S, D>(ball, balls))
              return Checked(false, c, "case " + std::to_string(c) + " of 2^" + std::to_string(by) + " is not held");
          if (!is_as_small(found.radius, expected.radius, by, size) || !is_as_small(walked.radius, walked_one.radius, by, size) ||
              !is_as_small(walked.radius, found.radius, 0, std::scalbn(size, by)) ||
              found.radius > mean.radius * (1 + 256 * std::numeric_limits<S>::epsilon()) + underflow_of_distance<S>())
            return Checked(false, c, "case " + std::to_string(c) + " of 2^" + std::to_string(by) + " is too large");
        }
        return Checked(true, cases);
      });
}

// Returns balls about the points of the cloud, with radii of 0, of one size, of any, or tiny beside the centers.
Balls balls_about(std::mt19937_64& random, const std::vector<Vec<double, 3>>& cloud, int by) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const int kind = static_cast<int>(random() % 4);
  const double common = uniform(random);
  Balls out;
  for (const auto& p : cloud)
    out.push_back({times_power_of_two(p, by), std::scalbn(kind == 0   ? 0
                                                          : kind == 1 ? common
                                                          : kind == 2 ? uniform(random)
                                                                      : 1e-12 * uniform(random),
                                                          by)});
  return out;
}

Balls of_size_one(const Balls& balls, int by) {
  Balls out;
  for (const auto& b : balls) out.push_back({times_power_of_two(b.center, -by), std::scalbn(b.radius, -by)});
  return out;
}

double size_of(const Balls& balls) {
  double size = 0;
  for (const auto& b : balls) size = std::max({size, b.radius, b.center.cwiseAbs().maxCoeff()});
  return size;
}

void balls_of_balls_of_every_size(Suite& t) {
  t.example(
      "so do the balls of balls, by every function that makes one, and what is called smallest is never above what is within a "
      "share of it "
      "or about the mean",
      {.number_type = "double"}, [] {
        std::mt19937_64 random(Session::get().seed() + 1);
        const long cases = Session::get().cases_for(12000);
        long first_found = 0;
        for (long c = 0; c < cases; ++c) {
          const int n = 1 + static_cast<int>(random() % (c % 50 == 0 ? 40 : 8)), by = any_exponent<double>(random);
          const Balls small = balls_about(random, cloud_of_size_one<double, 3>(random, n), by), one = of_size_one(small, by);
          const auto smallest = few_balls_ball(small).ball, expected = few_balls_ball(one).ball;
          const auto cgal = smallest_ball_of_balls(small), enclosing = few_balls_enclosing(small);
          const auto within = few_balls_enclosing(small, 0.05);
          const auto mean = mean_ball<double, 3>(small);
          const std::string which = "case " + std::to_string(c) + " of 2^" + std::to_string(by);
          for (const auto& ball : {smallest, cgal, enclosing, within, mean})
            if (!is_finite(ball) || !holds_all<double, 3>(ball, small)) return Checked(false, c, which + " is not held");
          const double size = size_of(one), rounding = 0x1p-46 * size_of(small) + underflow_of_distance<double>();
          if (!is_as_small(smallest.radius, expected.radius, by, size) ||
              !is_as_small(cgal.radius, expected.radius, by, size, 2e-10) || smallest.radius != enclosing.radius ||
              within.radius > 1.05 * smallest.radius + rounding)
            return Checked(false, c, which + " is too large");
          for (const auto& looser : {within, mean})
            if (smallest.radius > looser.radius + rounding) return Checked(false, c, which + " is not the smallest");
          if (n < 2) continue;
          if (const auto first = first_balls_ball(small, 0.05)) {
            ++first_found;
            if (!is_finite(*first) || !holds_all<double, 3>(*first, small) || first->radius > 1.05 * smallest.radius + rounding)
              return Checked(false, c, which + ": the first balls' ball");
          }
        }
        return Checked(5 * first_found > cases, cases, std::to_string(first_found) + " known by the first balls");
      });
}

void clouds_and_triangles_of_every_size(Suite& t) {
  t.example("clouds of a size for each point, from denormals beside ordinary ones to 1e40, have balls that hold them exactly",
            {.number_type = "double"}, [] {
              std::mt19937_64 random(Session::get().seed() + 2);
              const long cases = Session::get().cases_for(12000);
              for (long c = 0; c < cases; ++c) {
                Balls balls;
                std::vector<Vec<double, 3>> points;
                for (auto& p : cloud_of_size_one<double, 3>(random, 1 + static_cast<int>(random() % 12))) {
                  const auto coordinatewise = random() % 2;
                  const int by = any_exponent<double>(random);
                  for (double& x : p) x = std::scalbn(x, coordinatewise ? any_exponent<double>(random) : by);
                  points.push_back(p);
                  balls.push_back({p, c % 2 ? 0 : std::scalbn(1., any_exponent<double>(random))});
                }
                const Balls no_radii = [&] {
                  Balls out;
                  for (const auto& p : points) out.push_back({p, 0});
                  return out;
                }();
                const auto of_points = as_ball(few_points_ball<double, 3>(points)),
                           walked = as_ball(smallest_ball<double, 3>(points));
                for (const auto& ball : {of_points, walked})
                  if (!is_finite(ball) || !holds_all<double, 3>(ball, no_radii))
                    return Checked(false, c, "points, case " + std::to_string(c));
                for (const auto& ball : {few_balls_ball(balls).ball, few_balls_enclosing(balls, 0.05),
                                         smallest_ball_of_balls(balls), mean_ball<double, 3>(balls)})
                  if (!is_finite(ball) || !holds_all<double, 3>(ball, balls))
                    return Checked(false, c, "balls, case " + std::to_string(c));
              }
              return Checked(true, cases);
            });
  t.example("triangles of any size and any thinness have the ball of the long side, or of the circle", {.number_type = "double"},
            [] {
              std::mt19937_64 random(Session::get().seed() + 3);
              std::uniform_real_distribution<double> uniform(-1, 1);
              const long cases = Session::get().cases_for(40000);
              for (long c = 0; c < cases; ++c) {
                // The triangle is a needle: two points are as close as wanted, and the third one is beside the middle of them or
                // anywhere.
                const int long_side = any_exponent<double>(random), short_side = any_exponent<double>(random);
                const Vec<double, 3> a(0, 0, 0), b(std::scalbn(1., short_side), 0, 0),
                    tip(random() % 2 ? std::scalbn(0.5, short_side) : std::scalbn(uniform(random), long_side),
                        std::scalbn(uniform(random), long_side), 0);
                const std::array<Vec<double, 3>, 3> p = c % 3 == 0   ? std::array{a, b, tip}
                                                        : c % 3 == 1 ? std::array{tip, a, b}
                                                                     : std::array{b, tip, a};
                const auto ball = as_ball(three_points_ball<double, 3>(p[0], p[1], p[2]));
                const Balls corners{{p[0], 0}, {p[1], 0}, {p[2], 0}};
                double longest = 0;
                for (int i = 0; i < 3; ++i) longest = std::max(longest, (p[i] - p[(i + 1) % 3]).stableNorm());
                // No triangle's circle is beyond 1 / sqrt(3) times the longest side if it has no obtuse angle.
                if (!is_finite(ball) || !holds_all<double, 3>(ball, corners) ||
                    ball.radius > longest * (0.57735026919 + 1e-9) + underflow_of_distance<double>())
                  return Checked(false, c, "case " + std::to_string(c));
              }
              return Checked(true, cases);
            });
}

}  // namespace

PROPTEST(scaling) {
  t.example("lengths are scaled from a bit beyond 2^64 and below 2^-64 on, in float 2^8 and 2^-8, never by 0 or infinity", {},
            [] {
              const auto is = [](double length, int expected) { return scaling_of(length) == expected; };
              const auto is_float = [](float length, int expected) { return scaling_of(length) == expected; };
              return is(0x1p64, 0) && is(0x1.8p64, 0) && is(0x1p65, 65) && is(0x1p-64, 0) && is(0x1.8p-65, -65) && is(0, 0) &&
                     is(INFINITY, 0) && is(std::nan(""), 0) && is(0x1p-1074, -1074) && is_float(0x1p8f, 0) &&
                     is_float(0x1p9f, 9) && is_float(0x1p-9f, -9) && is_float(0x1p-8f, 0) && is_float(0x1p-149f, -149);
            });
  points_of_every_size<double, 3>(t, " in R^3");
  points_of_every_size<double, 4>(t, " in R^4");
  points_of_every_size<float, 3>(t, " in R^3");
  points_of_every_size<float, 4>(t, " in R^4");
  balls_of_balls_of_every_size(t);
  clouds_and_triangles_of_every_size(t);
  t.example("the orientations of boxes are of unit length at any size, and rotations where those of size 1 are",
            {.number_type = "double"}, [] {
              std::mt19937_64 random(Session::get().seed() + 4);
              const long cases = Session::get().cases_for(3000);
              for (long c = 0; c < cases; ++c) {
                const int by = any_exponent<double>(random);
                const Balls small =
                    balls_about(random, cloud_of_size_one<double, 3>(random, 1 + static_cast<int>(random() % 12)), by);
                const auto found = box_orientations(small);
                for (const auto& q : found)
                  if (!(std::abs(squared_norm(q) - 1) < 1e-12)) return Checked(false, c, "case " + std::to_string(c));
                Balls general;
                for (const auto& p : gen::rounded_cloud<3>(random, gen::Shape::general, 12, 0))
                  general.push_back({times_power_of_two(p, by), 0});
                const auto of_general = box_orientations(general), expected = box_orientations(of_size_one(general, by));
                const auto no_rotation = identity_quaternion<double>();
                for (int i = 0; i < 5 && by > -1000; ++i)
                  if ((of_general[i] == no_rotation) != (expected[i] == no_rotation))
                    return Checked(false, c, "case " + std::to_string(c) + " of 2^" + std::to_string(by));
              }
              return Checked(true, cases);
            });
}

}  // namespace proptests::suite_scaling
