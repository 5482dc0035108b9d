// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/balls/three_points_ball.hpp"

#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_three_points_ball {
namespace {

using namespace refitlab;

gen::Cloud<3> three_points() {
  auto cloud = *gen::cloud<3>(3);
  while (cloud.points.size() < 3) cloud.points.push_back(cloud.points.front());
  RC_CLASSIFY(gen::is_degenerate(cloud.shape), "degenerate");
  return cloud;
}

// Returns how many times as long as the shortest side the longest is. A side of length 0 does not count.
double thinness(const std::array<Vec<double, 3>, 3>& p) {
  double longest = 0, shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double side = norm<double, 3>(p[k] - p[(k + 1) % 3]);
    longest = std::max(longest, side);
    if (side > 0) shortest = std::min(shortest, side);
  }
  return std::max(1.0, longest / shortest);
}

// Says whether the radius that double computes of three points is the exact one, but for the rounding of the points themselves,
// and for what a short side adds to that.
template <class Rounded>
bool is_as_exact(const std::array<Vec<double, 3>, 3>& p, const Rounded& rounded) {
  const auto exact = three_points_ball<Rational, 3>(convert<Rational>(p[0]), convert<Rational>(p[1]), convert<Rational>(p[2]));
  const double radius = std::sqrt(CGAL::to_double(exact.squared_radius));
  double size = 0;
  for (const auto& x : p) size = std::max(size, x.cwiseAbs().maxCoeff());
  return std::abs(rounded - radius) <= (1e-14 + 0x1p-50 * thinness(p)) * radius + 0x1p-51 * size;
}

}  // namespace

PROPTEST(three_points_ball) {
  t.holds("it is the smallest ball, with a certificate", {.number_type = "rational", .cases = 3000, .degenerate_at_least = 0.3},
          [] {
            const auto cloud = three_points();
            const auto ball = three_points_ball<Rational, 3>(cloud.points[0], cloud.points[1], cloud.points[2]);
            RC_ASSERT(ball.converged);
            RC_ASSERT(oracle::certifies<3>(cloud.points, oracle::claim_of<3>(ball)));
            RC_TAG(ball.support_size == 2 ? "on two" : "on three");
          });
  t.holds("in double the radius is the exact one up to rounding, also of thin triangles and far from the origin",
          {.number_type = "double", .cases = 3000, .degenerate_at_least = 0.3}, [] {
            const auto cloud = three_points();
            const double thin = *rc::gen::element(1., 1e-3, 1e-8, 1e-15), offset = *rc::gen::element(0., 0., 1., 1e6);
            std::array<Vec<double, 3>, 3> p;
            for (int k = 0; k < 3; ++k) {
              for (int i = 0; i < 3; ++i) p[k][i] = CGAL::to_double(cloud.points[k][i]);
              p[k][*rc::gen::inRange(0, 3)] *= thin;
              p[k] += Vec<double, 3>::Constant(offset);
            }
            const auto ball = three_points_ball<double, 3>(p[0], p[1], p[2]);
            RC_ASSERT(is_as_exact(p, std::sqrt(ball.squared_radius)));
            RC_ASSERT(ball.squared_radius == farthest_squared_distance(ball.center, std::span<const Vec<double, 3>>(p)));
            for (int k = 0; k < ball.support_size; ++k) RC_ASSERT(ball.coefficients[k] >= 0);
            const Ball3<double> points[] = {{p[0], 0}, {p[1], 0}, {p[2], 0}};
            RC_ASSERT(is_as_exact(p, few_balls_ball(points).ball.radius));
          });
  t.example("a point that is not finite makes the ball undefined, wherever it stands", {.number_type = "double"}, [] {
    long undefined = 0;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) {
          std::array<Vec<double, 3>, 3> p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
          p[k][i] = bad;
          const auto ball = three_points_ball<double, 3>(p[0], p[1], p[2]);
          undefined += ball.support_size == 0 && ball.center.array().isNaN().all() && std::isnan(ball.squared_radius);
        }
    return Checked(undefined == 18, undefined);
  });
}

}  // namespace proptests::suite_three_points_ball
