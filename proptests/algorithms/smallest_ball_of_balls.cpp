// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"

#include "proptests/gen/any_place.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_smallest_ball_of_balls {
namespace {

using namespace refitlab;

// Holds 1 to 12 balls. Their centers are a cloud of any shape, and their radii repeat, are zero, or swallow the others.
struct Balls {
  std::vector<Ball3<double>> list;
  bool degenerate;
};

Balls draw() {
  const auto cloud = *gen::cloud<3>(12);
  const int radii = *gen::between(0, 9);
  Balls out{{}, gen::is_degenerate(cloud.shape) || (radii >= 1 && radii <= 4)};
  for (const auto& p : cloud.points) {
    const Vec<double, 3> c(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
    const double any = CGAL::to_double(*gen::unit_interval_rational());
    out.list.push_back({c, radii == 1 ? 0.0 : radii == 2 ? 0.5 : 3 * any});
  }
  if (radii == 3) out.list.front().radius = 1000;      // The ball holds all others.
  if (radii == 4) out.list.back() = out.list.front();  // Two balls are equal.
  return out;
}

std::vector<Ball<Rational, 3>> exact(const std::vector<Ball3<double>>& balls) {
  std::vector<Ball<Rational, 3>> out;
  for (const auto& b : balls) out.push_back({convert<Rational>(b.center), Rational(b.radius)});
  return out;
}

double size_of(const std::vector<Ball3<double>>& balls) {
  double size = 0;
  for (const auto& b : balls) size = std::max({size, b.center.cwiseAbs().maxCoeff(), b.radius});
  return size;
}

}  // namespace

PROPTEST(smallest_ball_of_balls) {
  t.holds("the ball encloses all balls up to 1e-15 of its radius",
          {.number_type = "rational", .cases = 1500, .degenerate_at_least = 0.35}, [] {
            const Balls balls = draw();
            RC_CLASSIFY(balls.degenerate, "degenerate");
            auto around = exact({smallest_ball_of_balls(balls.list)}).front();
            around.radius *= Rational(1 + 1e-15);
            for (const auto& b : exact(balls.list)) RC_ASSERT(encloses(around, b) == Verdict::holds);
          });
  t.holds("its radius is within 1e-9 of what CGAL's exact solver finds",
          {.number_type = "rational", .cases = 700, .degenerate_at_least = 0.35}, [] {
            const Balls balls = draw();
            RC_CLASSIFY(balls.degenerate, "degenerate");
            const Rational radius(smallest_ball_of_balls(balls.list).radius), slack(size_of(balls.list) * 0x1p-50);
            const auto optimum = oracle::smallest_ball_by_cgal<3>(exact(balls.list)).radius;
            RC_ASSERT(optimum < radius * Rational(1 + 1e-14) + slack + Rational(1e-300));
            RC_ASSERT(!(optimum < (radius - slack) * Rational(1 - 1e-9)));
          });
  t.holds("vectors that add up to nothing prove that no enclosing ball is smaller by more than 1e-7",
          {.number_type = "rational", .cases = 700, .degenerate_at_least = 0.35}, [] {
            const Balls balls = draw();
            RC_CLASSIFY(balls.degenerate, "degenerate");
            const auto ball = smallest_ball_of_balls(balls.list);
            const Rational low = oracle::radius_at_least(balls.list, ball.center);
            RC_ASSERT(low <= Rational(ball.radius) * Rational(1 + 1e-14));
            RC_ASSERT(low >= Rational(ball.radius) * Rational(1 - 1e-7) - Rational(size_of(balls.list) * 0x1p-40));
          });
  t.example("balls about points of a grid, where CGAL's solver in double may fail, are enclosed by the smallest ball too",
            {.number_type = "rational"}, [] {
              std::mt19937_64 random(Session::get().seed());
              constexpr long cases = 2500;
              for (long c = 0; c < cases; ++c) {
                std::vector<Ball3<double>> balls;
                const int n = 3 + static_cast<int>(random() % 14), radii = 1 + static_cast<int>(random() % 4);
                for (const auto& p : gen::rounded_cloud<3>(random, gen::Shape::grid, n, c % 2 ? 0 : 1))
                  balls.push_back({p, 0.1 * static_cast<double>(random() % radii)});
                const double radius = smallest_ball_of_balls(balls).radius;
                const auto optimum = oracle::smallest_ball_by_cgal<3>(exact(balls)).radius;
                if (optimum < Rational(radius * (1 - 1e-9)) || optimum > Rational(radius * (1 + 1e-14)))
                  return Checked(false, c, "case " + std::to_string(c));
              }
              return Checked(true, cases);
            });
  t.example("five balls for which CGAL's exact result is a difference of large numbers keep their digits", {}, [] {
    const std::vector<Ball3<double>> balls{
        {{1.2, 1, 1.1}, 0.1}, {{1.2, 1.1, 1.1}, 0}, {{1.2, 1.2, 1.2}, 0.1}, {{1.1, 1.3, 1}, 0}, {{1.2, 1.2, 1}, 0.1}};
    return std::abs(smallest_ball_of_balls(balls).radius - 0.225) < 1e-12;
  });
  t.example("one ball, a ball in a ball, two that touch, and two points", {.number_type = "double"}, [] {
    const Ball3<double> a{{1, 2, 3}, 4}, inside{{1, 2, 4}, 1}, left{{-1, 0, 0}, 1}, right{{1, 0, 0}, 1};
    const Ball3<double> p{{-3, 0, 0}, 0}, q{{3, 0, 0}, 0};
    const auto is = [](const Ball3<double>& x, const Ball3<double>& y) {
      return (x.center - y.center).norm() < 1e-12 && std::abs(x.radius - y.radius) < 1e-12;
    };
    const auto of = [](std::vector<Ball3<double>> balls) { return smallest_ball_of_balls(balls); };
    return is(of({a}), a) && is(of({a, inside}), a) && is(of({inside, a, a}), a) && is(of({left, right}), {{0, 0, 0}, 2}) &&
           is(of({p, q}), {{0, 0, 0}, 3}) && is(of({p}), p);
  });

  t.example("balls of which one is undefined have an undefined ball, and the others one that is defined", {}, [] {
    const Ball3<double> good{{1, 2, 3}, 4}, nan{{1, std::nan(""), 3}, 1}, negative{{0, 0, 0}, -1}, infinite{{0, 0, 0}, INFINITY};
    for (const auto& bad : {nan, negative, infinite}) {
      const std::vector<Ball3<double>> balls{good, bad};
      const auto ball = smallest_ball_of_balls(balls);
      if (!std::isnan(ball.radius) || !std::isnan(ball.center[0])) return false;
    }
    return smallest_ball_of_balls(std::vector<Ball3<double>>{good}).radius == 4;
  });
}

}  // namespace proptests::suite_smallest_ball_of_balls
