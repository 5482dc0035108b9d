// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/smallest_ball.hpp"

#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_smallest_ball {
namespace {

using namespace refitlab;
using gen::Shape;
using oracle::BallClaim;

bool equals(const oracle::RootNumber& x, const Rational& y) { return !(x < y) && !(x > y); }

template <int D>
void exact_properties(Suite& t) {
  const std::string space = " in R^" + std::to_string(D);
  t.holds("a certificate proves the exact ball of 1 to 20 points" + space,
          {.number_type = "rational", .cases = 700, .degenerate_at_least = 0.35}, [] {
            const auto cloud = *gen::cloud<D>(20);
            RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
            const auto ball = smallest_ball<Rational, D>(cloud.points);
            RC_ASSERT(ball.converged);
            RC_ASSERT(oracle::certifies<D>(cloud.points, oracle::claim_of<D>(ball)));
          });
  t.holds("CGAL's exact solver finds the same center" + space,
          {.number_type = "rational", .cases = 300, .degenerate_at_least = 0.35}, [] {
            const auto cloud = *gen::cloud<D>(12);
            RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
            const auto ball = smallest_ball<Rational, D>(cloud.points);
            std::vector<Ball<Rational, D>> balls;
            for (const auto& p : cloud.points) balls.push_back({p, Rational(0)});
            const auto other = oracle::smallest_ball_by_cgal<D>(balls);
            for (int i = 0; i < D; ++i) RC_ASSERT(equals(other.center[i], ball.center[i]));
          });
  t.holds("a changed certificate is rejected" + space, {.number_type = "rational", .cases = 500, .degenerate_at_least = 0.35},
          [] {
            const auto cloud = *gen::cloud<D>(12);
            RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
            const auto claim = oracle::claim_of<D>(smallest_ball<Rational, D>(cloud.points));
            RC_ASSERT(oracle::certifies<D>(cloud.points, claim));
            const auto rejects = [&](auto&& change) {
              BallClaim<D> changed = claim;
              change(changed);
              return !oracle::certifies<D>(cloud.points, changed);
            };
            const Rational step = *gen::positive_rational();
            const int i = *rc::gen::inRange(0, D), k = *rc::gen::inRange(0, static_cast<int>(claim.support.size()));
            RC_ASSERT(rejects([&](auto& c) { c.center[i] += step; }));
            RC_ASSERT(rejects([&](auto& c) { c.squared_radius += step; }));
            RC_ASSERT(rejects([&](auto& c) { c.squared_radius -= step; }));
            RC_ASSERT(rejects([&](auto& c) { c.coefficients[k] += step; }));
            RC_ASSERT(rejects([&](auto& c) { c.support[k] = static_cast<int>(cloud.points.size()); }));
            RC_ASSERT(rejects([&](auto& c) { c.coefficients.pop_back(), c.support.pop_back(); }) ||
                      claim.coefficients.back() == Rational(0));
          });
}

// Holds the squared radius of the ball as the exact maximum over the points, and a lower bound of what is possible.
template <int D>
struct Squeeze {
  Squeeze(const std::vector<Vec<double, D>>& points, const SmallestBall<double, D>& ball) {
    std::vector<oracle::ExactPoint<D>> exact;
    for (const auto& p : points) exact.push_back(convert<Rational>(p));
    const auto claim = oracle::claim_of<D>(ball);
    low = oracle::squared_radius_at_least<D>(exact, claim);
    for (const auto& p : exact) high = std::max(high, squared_distance(p, claim.center));
    stated = claim.squared_radius;
    for (const auto& p : points)
      for (int i = 0; i < D; ++i) size = std::max(size, std::abs(p[i]));
  }
  // Says whether radius <= optimum (1 + 1e-9) + 2^-51 of the largest coordinate. The center is rounded to doubles.
  bool is_tight() const {
    const double optimum = std::sqrt(std::max(0.0, CGAL::to_double(low)));
    return low >= Rational(0) && std::sqrt(CGAL::to_double(high)) <= optimum * (1 + 1e-9) + size * 0x1p-51;
  }
  bool encloses() const { return high <= stated * Rational(1 + 0x1p-49); }
  Rational low, high = 0, stated;
  double size = 0;
};

template <int D>
void double_properties(Suite& t) {
  const std::string space = " in R^" + std::to_string(D);
  t.holds("in double the radius is within 1e-9 of a proved lower bound" + space,
          {.number_type = "double", .cases = 700, .degenerate_at_least = 0.35}, [] {
            const auto cloud = *gen::cloud<D>(20);
            RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
            std::vector<Vec<double, D>> points;
            for (const auto& p : cloud.points) {
              points.emplace_back();
              for (int i = 0; i < D; ++i) points.back()[i] = CGAL::to_double(p[i]);
            }
            const auto ball = smallest_ball<double, D>(points);
            const Squeeze<D> squeeze(points, ball);
            RC_ASSERT(ball.converged);
            RC_ASSERT(squeeze.encloses());
            RC_ASSERT(squeeze.is_tight());
          });
  t.example("the walk in double always ends, and near the smallest ball" + space + ": all shapes, up to 500 points",
            {.number_type = "double"}, [] {
              const Session& session = Session::get();
              std::mt19937_64 random(session.seed() + D);
              const long cases = session.cases_for(40000);
              long degenerate = 0, steps = 0, most_steps = 0;
              for (long c = 0; c < cases; ++c) {
                const Shape shape = static_cast<Shape>(random() % gen::shape_count);
                const int n = c % 200 == 0 ? 500 : 1 + static_cast<int>(random() % 20);
                const double offset = c % 3 == 0 ? 0 : c % 3 == 1 ? 1e3 : 1e9;
                const auto points = gen::rounded_cloud<D>(random, shape, n, offset);
                const auto ball = smallest_ball<double, D>(points);
                degenerate += gen::is_degenerate(shape);
                steps += ball.steps;
                most_steps = std::max<long>(most_steps, ball.steps);
                if (!ball.converged) return Checked(false, c, "no end for case " + std::to_string(c));
                if (c % 10 == 0) {
                  const Squeeze<D> squeeze(points, ball);
                  if (!squeeze.encloses() || !squeeze.is_tight()) return Checked(false, c, "case " + std::to_string(c));
                }
              }
              return Checked(2 * degenerate > cases, cases,
                             "steps: " + std::to_string(static_cast<double>(steps) / static_cast<double>(cases)) +
                                 " on average, " + std::to_string(most_steps) + " at most");
            });
}

}  // namespace

PROPTEST(smallest_ball) {
  exact_properties<2>(t);
  exact_properties<3>(t);
  exact_properties<4>(t);
  double_properties<2>(t);
  double_properties<3>(t);
  double_properties<4>(t);
  t.example("the exact ball of 500 points of a sphere is certified", {.number_type = "rational"}, [] {
    std::mt19937_64 random(Session::get().seed());
    std::vector<Vec<Rational, 3>> points;
    for (int k = 0; k < 500; ++k) {
      const Rational u(static_cast<int>(random() % 41) - 20, 7), v(static_cast<int>(random() % 41) - 20, 9);
      const Rational square = u * u + v * v, scale = Rational(1) + square;
      points.push_back({(Rational(1) - square) / scale, Rational(2) * u / scale, Rational(2) * v / scale});
    }
    const auto ball = smallest_ball<Rational, 3>(points);
    return Checked(ball.converged && oracle::certifies<3>(points, oracle::claim_of<3>(ball)), 500,
                   std::to_string(ball.steps) + " steps");
  });
  t.example("one point, two points and a square have the balls that everybody knows", {.number_type = "double"}, [] {
    using P = Vec<double, 2>;
    const std::vector<P> one{P(3, 4)}, two{P(0, 0), P(6, 8)}, square{P(0, 0), P(2, 0), P(2, 2), P(0, 2)};
    const auto a = smallest_ball<double, 2>(one), b = smallest_ball<double, 2>(two), c = smallest_ball<double, 2>(square);
    return a.center == P(3, 4) && a.squared_radius == 0 && b.center == P(3, 4) && b.squared_radius == 25 && c.center == P(1, 1) &&
           c.squared_radius == 2 && as_ball(b).radius == 5;
  });
}

}  // namespace proptests::suite_smallest_ball
