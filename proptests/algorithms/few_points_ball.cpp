// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/few_points_ball.hpp"

#include <limits>
#include <set>
#include <utility>

#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_few_points_ball {
namespace {

using namespace refitlab;
using gen::Shape;

template <class S, int D>
std::span<const Vec<S, D>> all(const std::vector<Vec<S, D>>& points) {
  return points;
}

template <class S, int D>
double size_of(const std::vector<Vec<S, D>>& points) {
  double size = 0;
  for (const auto& p : points) size = std::max<double>(size, p.cwiseAbs().maxCoeff());
  return size;
}

// Says whether what needs no exact numbers is right: the certificate's form, and the radius as others would compute it.
template <class S, int D>
bool is_well_formed(const std::vector<Vec<S, D>>& points, const SmallestBall<S, D>& ball) {
  const int n = ball.support_size;
  if (!ball.converged || n < 1 || n > D + 1) return false;
  S sum(0);
  std::set<int> support;
  for (int k = 0; k < n; ++k) {
    if (ball.support[k] < 0 || ball.support[k] >= static_cast<int>(points.size()) || !(ball.coefficients[k] >= 0)) return false;
    sum += ball.coefficients[k];
    support.insert(ball.support[k]);
  }
  return static_cast<int>(support.size()) == n && std::abs(sum - 1) <= 64 * std::numeric_limits<S>::epsilon() &&
         ball.squared_radius == farthest_squared_distance(ball.center, all(points));
}

// Says whether the greatest distance is within this share of a radius below which no ball can be, but for the center's rounding.
template <int D>
bool is_smallest(const std::vector<Vec<double, D>>& points, const SmallestBall<double, D>& ball, double share = 1e-12) {
  std::vector<oracle::ExactPoint<D>> exact;
  for (const auto& p : points) exact.push_back(convert<Rational>(p));
  const auto claim = oracle::claim_of<D>(ball);
  const Rational low = oracle::squared_radius_at_least<D>(exact, claim);
  Rational high(0);
  for (const auto& p : exact) high = std::max(high, squared_distance(p, claim.center));
  return low >= Rational(0) && high <= claim.squared_radius * Rational(1 + 0x1p-49) &&
         std::sqrt(CGAL::to_double(high)) <= std::sqrt(CGAL::to_double(low)) * (1 + share) + size_of(points) * 0x1p-51;
}

// Returns clouds that are nearly degenerate in some measure from 1 down to 1e-15: flat, thin, nearly on a sphere, nearly few
// points.
template <int D>
std::vector<Vec<double, D>> nearly_degenerate(std::mt19937_64& random, int n, double offset) {
  std::normal_distribution<double> normal;
  const double measure = std::pow(10.0, -static_cast<double>(random() % 16));
  const int kind = static_cast<int>(random() % 5);
  std::vector<Vec<double, D>> points;
  for (int k = 0; k < n; ++k) {
    Vec<double, D> p;
    for (int i = 0; i < D; ++i) p[i] = normal(random);
    if (kind == 0 || kind == 1) p[0] *= measure;
    if (kind == 1) p[1] *= measure;
    if (kind == 2) p = p / norm(p) * (1 + measure * normal(random));
    if (kind == 3 && k > 2) p = points[random() % 3] - Vec<double, D>::Constant(offset) + p * measure;
    if (kind == 4) p = p * (measure * measure);
    points.push_back(p + Vec<double, D>::Constant(offset));
  }
  return points;
}

template <int D>
void smallest_balls_are_certified(Suite& t, const std::string& space) {
  t.holds("the radius is within 1e-12 of the exact smallest ball's" + space,
          {.number_type = "rational", .cases = 300, .degenerate_at_least = 0.35}, [] {
            const auto cloud = *gen::cloud<D>(20);
            RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
            std::vector<Vec<double, D>> points;
            std::vector<oracle::ExactPoint<D>> exact;
            for (const auto& p : cloud.points) {
              points.emplace_back();
              for (int i = 0; i < D; ++i) points.back()[i] = CGAL::to_double(p[i]);
              exact.push_back(convert<Rational>(points.back()));
            }
            const auto smallest = smallest_ball<Rational, D>(exact);
            RC_ASSERT(oracle::certifies<D>(exact, oracle::claim_of<D>(smallest)));
            const double optimum = std::sqrt(CGAL::to_double(smallest.squared_radius));
            const double radius = as_ball(few_points_ball(all(points))).radius;
            RC_ASSERT(std::abs(radius - optimum) <= 1e-12 * optimum + size_of(points) * 0x1p-51);
          });
  t.example("the certificate proves the ball, and the walk hardly ever takes over" + space + ": all shapes, 1 to 70 points",
            {.number_type = "double"}, [] {
              const Session& session = Session::get();
              std::mt19937_64 random(session.seed() + D);
              const long cases = session.cases_for(60000);
              long walks = 0, pivots = 0, few = 0;
              for (long c = 0; c < cases; ++c) {
                const int n = 1 + static_cast<int>(random() % (c % 50 == 0 ? 70 : 20)), shape = static_cast<int>(random() % 14);
                const double offset = c % 3 == 0 ? 0 : c % 3 == 1 ? 1e3 : 1e9;
                const auto points = shape < gen::shape_count ? gen::rounded_cloud<D>(random, static_cast<Shape>(shape), n, offset)
                                                             : nearly_degenerate<D>(random, n, offset);
                if (n <= 32) {
                  FewPoints<double, D, 32> pivoting(points);
                  ++few;
                  walks += !pivoting.solve();
                }
                const auto ball = few_points_ball(all(points));
                pivots += ball.steps;
                if (!is_well_formed(points, ball)) return Checked(false, c, "malformed, case " + std::to_string(c));
                if (c % 30 == 0 && !is_smallest(points, ball))
                  return Checked(false, c, "not smallest, case " + std::to_string(c));
              }
              return Checked(1000 * walks <= few, cases,
                             std::to_string(walks) + " walks, " +
                                 std::to_string(static_cast<double>(pivots) / static_cast<double>(cases)) + " pivots on average");
            });
}

template <int D>
void floats_and_points_beyond_the_certificate(Suite& t, const std::string& space) {
  t.example("a ball in float is as small as the one in double, but for its digits" + space, {.number_type = "float"}, [] {
    std::mt19937_64 random(Session::get().seed());
    constexpr long cases = 3000;
    for (long c = 0; c < cases; ++c) {
      const auto points =
          gen::rounded_cloud<D>(random, static_cast<Shape>(random() % gen::shape_count), 1 + static_cast<int>(random() % 20), 0);
      std::vector<Vec<float, D>> rounded;
      for (const auto& p : points) rounded.push_back(p.template cast<float>());
      const auto ball = few_points_ball(all(rounded));
      const double radius = as_ball(few_points_ball(all(points))).radius;
      if (!is_well_formed(rounded, ball) || std::abs(as_ball(ball).radius - radius) > 2e-5 * radius + 1e-6)
        return Checked(false, c, "case " + std::to_string(c));
    }
    return Checked(true, cases);
  });
  t.example("where squares underflow and beyond 512 points the walk takes over" + space, {.number_type = "double"}, [] {
    std::mt19937_64 random(Session::get().seed());
    int walks = 0;
    for (int c = 0; c < 100; ++c) {
      std::vector<Vec<double, D>> tiny = gen::rounded_cloud<D>(random, Shape::general, 9, 0);
      for (auto& p : tiny) p = p * 1e-158;
      FewPoints<double, D, 32> pivoting(tiny);
      const auto ball = few_points_ball(all(tiny));
      if (ball.squared_radius != farthest_squared_distance(ball.center, all(tiny))) return false;
      if (pivoting.solve()) continue;
      ++walks;
      if (!pivoting.is_defined() || ball.center != smallest_ball(all(tiny)).center) return false;
    }
    if (walks == 0) return false;
    for (const int n : {512, 513, 700}) {
      const auto many = gen::rounded_cloud<D>(random, Shape::sphere, n, 1);
      const auto ball = few_points_ball(all(many)), walked = smallest_ball(all(many));
      // Among so many points on a sphere, the walk ends earlier: an error of 4e-12 was seen.
      if (!is_well_formed(many, ball) || !is_smallest(many, ball, n > 512 ? 1e-11 : 1e-12)) return false;
      if (n > 512 && ball.center != walked.center) return false;
    }
    return true;
  });
}

// Checks that lists of 1 to 600 points, with a number that is not finite in the first, the middle or the last one, have no ball.
// Lists of most lengths have one such point, and those on either side of a switch have all kinds at all places.
template <class S, int D>
Checked lists_with_a_point_that_is_not_finite() {
  std::mt19937_64 random(Session::get().seed() + D);
  constexpr S infinity = std::numeric_limits<S>::infinity();
  const S kinds[] = {std::numeric_limits<S>::quiet_NaN(), infinity, -infinity};
  const std::set<int> switches{1, 2, 3, 4, 32, 33, 512, 513};
  long tried = 0;
  for (int n = 1; n <= 600; ++n) {
    std::vector<Vec<S, D>> points;
    for (const auto& p : gen::rounded_cloud<D>(random, Shape::general, n, 0)) points.push_back(p.template cast<S>());
    const int places[] = {0, n / 2, n - 1};
    for (int kind = 0; kind < 3; ++kind)
      for (int place = 0; place < 3; ++place) {
        if (!switches.count(n) && (kind != n % 3 || place != n / 3 % 3)) continue;
        for (int i = 0; i < D; ++i) {
          S& number = points[places[place]][i];
          const S before = std::exchange(number, kinds[kind]);
          const auto ball = few_points_ball(all(points));
          number = before;
          ++tried;
          if (!std::isnan(ball.squared_radius) || !ball.center.array().isNaN().all() || ball.support_size != 0 || ball.converged)
            return Checked(false, tried, std::to_string(n) + " points, at " + std::to_string(places[place]));
        }
      }
    if (n > 32 && n % 50 != 0 && !switches.count(n)) continue;
    if (!few_points_ball(all(points)).converged) return Checked(false, tried, "finite: " + std::to_string(n) + " points");
  }
  return Checked(true, tried);
}

template <int D>
void points_that_are_not_finite(Suite& t, const std::string& space) {
  t.example("1 to 600 points of which the first, the middle or the last is not finite have an undefined ball" + space,
            {.number_type = "double"}, [] { return lists_with_a_point_that_is_not_finite<double, D>(); });
  t.example("so have they in float" + space, {.number_type = "float"},
            [] { return lists_with_a_point_that_is_not_finite<float, D>(); });
}

template <int D>
void properties(Suite& t) {
  const std::string space = " in R^" + std::to_string(D);
  smallest_balls_are_certified<D>(t, space);
  floats_and_points_beyond_the_certificate<D>(t, space);
  points_that_are_not_finite<D>(t, space);
}

}  // namespace

PROPTEST(few_points_ball) {
  properties<3>(t);
  properties<4>(t);
  t.example("one point, two points, an equilateral triangle, a flat one and a cube have the balls that everybody knows",
            {.number_type = "double"}, [] {
              using P = Vec<double, 3>;
              const auto is = [](std::vector<P> points, const P& center, double squared_radius, int support) {
                const auto ball = few_points_ball(all(points));
                return norm<double, 3>(ball.center - center) < 1e-15 && std::abs(ball.squared_radius - squared_radius) < 1e-14 &&
                       ball.support_size <= support;
              };
              std::vector<P> cube;
              for (int i = 0; i < 8; ++i) cube.push_back(P(i & 1, i >> 1 & 1, i >> 2));
              return is({P(3, 4, 5)}, P(3, 4, 5), 0, 1) && is({P(0, 0, 0), P(6, 8, 0)}, P(3, 4, 0), 25, 2) &&
                     is({P(1, 0, 0), P(0, 1, 0), P(0, 0, 1)}, P(1, 1, 1) / 3, 2.0 / 3, 3) &&
                     is({P(0, 0.1, 0), P(-1, 0, 0), P(1, 0, 0)}, P(0, 0, 0), 1, 2) && is(cube, P(1, 1, 1) / 2, 0.75, 4);
            });
}

}  // namespace proptests::suite_few_points_ball
