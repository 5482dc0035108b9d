// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/mean_ball.hpp"

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_mean_ball {
namespace {

using namespace refitlab;

template <int D>
Rational exact_squared_radius(const std::vector<oracle::ExactPoint<D>>& points) {
  const auto ball = smallest_ball<Rational, D>(points);
  RC_ASSERT(oracle::certifies<D>(points, oracle::claim_of<D>(ball)));
  return ball.squared_radius;
}

template <int D>
void properties(Suite& t) {
  const std::string space = " in R^" + std::to_string(D);
  t.holds(
      "in squared form the mean ball encloses its points, touches one, and is at most 2 - 2/m times as large as the smallest" +
          space,
      {.number_type = "rational", .cases = 700, .degenerate_at_least = 0.35}, [] {
        const auto cloud = *gen::cloud<D>(12);
        RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
        const std::span<const oracle::ExactPoint<D>> points(cloud.points);
        const auto center = mean_center(points);
        const Rational far = farthest_squared_distance(center, points);
        const Rational m(static_cast<int>(points.size()));
        oracle::ExactPoint<D> sum = center * m;
        bool touches = false;
        for (const auto& p : points) {
          sum -= p;
          RC_ASSERT(squared_distance(p, center) <= far);
          touches = touches || squared_distance(p, center) == far;
        }
        RC_ASSERT(touches);
        RC_ASSERT(sum == oracle::ExactPoint<D>(oracle::ExactPoint<D>::Constant(Rational(0))));
        const Rational least = exact_squared_radius<D>(cloud.points), ratio = Rational(2) - Rational(2) / m;
        RC_ASSERT(least <= far);
        RC_ASSERT(far <= ratio * ratio * least || points.size() == 1);
      });
}

// Returns a ball of doubles as the exact one that its numbers stand for.
template <int D>
Ball<Rational, D> exact(const Ball<double, D>& b) {
  return {convert<Rational>(b.center), Rational(b.radius)};
}

}  // namespace

PROPTEST(mean_ball) {
  properties<2>(t);
  properties<3>(t);
  properties<4>(t);
  t.holds("the mean ball of balls encloses them, and no smaller one about its center does",
          {.number_type = "algebraic", .cases = 150, .degenerate_at_least = 0.3}, [] {
            const auto cloud = *gen::cloud<3>(5);
            RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
            std::vector<Ball<ExactRoot, 3>> balls;
            const auto number = [](const Rational& x) {
              return ExactRoot(CORE::BigRat(CORE::BigInt(x.numerator().mpz()), CORE::BigInt(x.denominator().mpz())));
            };
            for (const auto& p : cloud.points) {
              const Rational r = *rc::gen::element(Rational(0), Rational(1, 2), Rational(3));
              balls.push_back({{number(p[0]), number(p[1]), number(p[2])}, number(r)});
            }
            const auto ball = mean_ball<ExactRoot, 3>(balls);
            Verdict all = Verdict::holds, all_smaller = Verdict::holds;
            const Ball<ExactRoot, 3> smaller{ball.center, ball.radius - ExactRoot(1) / ExactRoot(1000)};
            for (const auto& b : balls) all &= encloses(ball, b), all_smaller &= encloses(smaller, b);
            RC_ASSERT(all == Verdict::holds);
            RC_ASSERT(all_smaller == Verdict::fails);
          });
  t.example("2 - 2/m for points and 2 - 1/m for balls are reached", {.number_type = "double"}, [] {
    using P = Vec<double, 3>;
    bool all = true;
    for (int m = 2; m <= 64; m *= 2) {
      std::vector<P> points(m, P(-1, 0, 0));
      points[0] = P(1, 0, 0);
      all = all && mean_ball<double, 3>(points).radius == 2 - 2.0 / m && smallest_ball<double, 3>(points).squared_radius == 1;
      std::vector<Ball3<double>> balls(m, Ball3<double>{P(1, 0, 0), 0});
      balls[0] = {P(0, 0, 0), 1};
      all = all && mean_ball<double, 3>(balls).radius == 2 - 1.0 / m;
    }
    return Checked(all, 6);
  });
  t.example("in double about half of all mean balls miss one of their own points, by less than 1e-15 of the radius",
            {.number_type = "double"}, [] {
              std::mt19937_64 random(Session::get().seed());
              constexpr long cases = 4000;
              long points_missed = 0, balls_missed = 0;
              bool nearly = true;
              for (long c = 0; c < cases; ++c) {
                const auto points = gen::rounded_cloud<3>(random, gen::Shape::general, 2 + static_cast<int>(random() % 15), 0);
                const auto ball = exact(mean_ball<double, 3>(points));
                const Ball<Rational, 3> larger{ball.center, ball.radius * Rational(1 + 1e-15)};
                std::vector<Ball3<double>> balls;
                for (const auto& p : points) balls.push_back({p, 0.25 * static_cast<double>(random() % 5)});
                const auto around = exact(mean_ball<double, 3>(balls));
                const Ball<Rational, 3> larger_around{around.center, around.radius * Rational(1 + 1e-15)};
                bool point_missed = false, ball_missed = false;
                for (std::size_t k = 0; k < points.size(); ++k) {
                  const auto p = convert<Rational>(points[k]);
                  const auto b = exact(balls[k]);
                  point_missed = point_missed || encloses(ball, p) == Verdict::fails;
                  ball_missed = ball_missed || encloses(around, b) == Verdict::fails;
                  nearly = nearly && encloses(larger, p) == Verdict::holds && encloses(larger_around, b) == Verdict::holds;
                }
                points_missed += point_missed, balls_missed += ball_missed;
              }
              const double share = static_cast<double>(points_missed) / cases,
                           of_balls = static_cast<double>(balls_missed) / cases;
              return Checked(nearly && share > 0.3 && share < 0.6 && of_balls > 0.3 && of_balls < 0.6, cases,
                             "misses: points " + std::to_string(share) + ", balls " + std::to_string(of_balls));
            });
}

}  // namespace proptests::suite_mean_ball
