// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/smallest_ball.hpp"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Min_sphere_of_spheres_d_traits_d.h>

#include <Eigen/Dense>
#include <algorithm>
#include <tuple>

namespace proptests::oracle {
namespace {

// Returns the sign of a + b sqrt(square) - y.
int sign_of_difference(const RootNumber& x, const Rational& y) {
  const Rational left = x.a - y;
  const int sign_left = CGAL::sign(left), sign_root = x.square == Rational(0) ? 0 : static_cast<int>(CGAL::sign(x.b));
  if (sign_left * sign_root >= 0) return sign_left != 0 ? sign_left : sign_root;
  const Rational left2 = left * left, root2 = x.b * x.b * x.square;
  return left2 == root2 ? 0 : left2 > root2 ? sign_left : sign_root;
}

// Returns the bound that one choice of at most four balls gives, or -1 where the center is not in their hull, or not nearly.
Rational bound_of(const std::vector<refitlab::Ball<double, 3>>& balls, const refitlab::Vec<double, 3>& center) {
  const int n = static_cast<int>(balls.size());
  Eigen::MatrixXd system(4, n);
  for (int k = 0; k < n; ++k) system.col(k) << balls[k].center - center, 1;
  const Eigen::VectorXd u = system.colPivHouseholderQr().solve(Eigen::Vector4d(0, 0, 0, 1));
  if ((system * u).head<3>().norm() > 1e-8 * (system.topRows<3>().norm() + balls[0].radius)) return Rational(-1);
  std::vector<ExactPoint<3>> v(n);
  ExactPoint<3> excess = ExactPoint<3>::Constant(Rational(0));
  for (int k = 0; k < n; ++k) {
    if (!(u[k] >= 0)) return Rational(-1);
    for (int i = 0; i < 3; ++i) {
      v[k][i] = Rational(u[k] * (center[i] - balls[k].center[i]));
      excess[i] += v[k][i];
    }
  }
  Rational lengths(0), bound(0);
  for (int k = 0; k < n; ++k) {
    Rational square(0), product(0);
    for (int i = 0; i < 3; ++i) {
      v[k][i] -= excess[i] / Rational(n);
      square += v[k][i] * v[k][i];
      product += v[k][i] * Rational(balls[k].center[i]);
    }
    Rational length(std::sqrt(CGAL::to_double(square)) * (1 + 1e-15));
    while (length * length < square) length = length * Rational(1 + 1e-15) + Rational(1e-300);
    // Here v is 0, and the ball is alone.
    if (n == 1) length = Rational(1);
    lengths += length;
    bound += length * Rational(balls[k].radius) - product;
  }
  return lengths == Rational(0) ? Rational(-1) : Rational(bound / lengths);
}

}  // namespace

bool operator<(const RootNumber& x, const Rational& y) { return sign_of_difference(x, y) < 0; }
bool operator>(const RootNumber& x, const Rational& y) { return sign_of_difference(x, y) > 0; }

Rational radius_at_least(std::span<const refitlab::Ball<double, 3>> balls, const refitlab::Vec<double, 3>& center) {
  // Only balls that touch the smallest one matter: those that reach farthest from the center, without repetition.
  std::vector<refitlab::Ball<double, 3>> far(balls.begin(), balls.end());
  const auto reach = [&](const auto& b) { return (b.center - center).norm() + b.radius; };
  const auto key = [&](const auto& b) { return std::tuple(-reach(b), b.center[0], b.center[1], b.center[2]); };
  std::sort(far.begin(), far.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  far.erase(std::unique(far.begin(), far.end(),
                        [](const auto& a, const auto& b) { return a.center == b.center && a.radius == b.radius; }),
            far.end());
  if (far.size() > 12) far.resize(12);
  Rational best(-1);
  for (unsigned chosen = 1; chosen < 1u << far.size(); ++chosen) {
    if (__builtin_popcount(chosen) > 4) continue;
    std::vector<refitlab::Ball<double, 3>> some;
    for (std::size_t k = 0; k < far.size(); ++k)
      if (chosen >> k & 1) some.push_back(far[k]);
    best = std::max(best, bound_of(some, center));
  }
  return best;
}

template <int D>
CgalBall<D> smallest_ball_by_cgal(std::span<const refitlab::Ball<Rational, D>> balls) {
  using Kernel = CGAL::Cartesian_d<Rational>;
  using Traits = CGAL::Min_sphere_of_spheres_d_traits_d<Kernel, Rational, D>;
  std::vector<typename Traits::Sphere> spheres;
  for (const auto& b : balls) {
    std::vector<Rational> c(b.center.data(), b.center.data() + D);
    spheres.emplace_back(typename Kernel::Point_d(D, c.begin(), c.end()), b.radius);
  }
  CGAL::Min_sphere_of_spheres_d<Traits> smallest(spheres.begin(), spheres.end());
  const auto root_number = [&](const auto& x) { return RootNumber{x.first, x.second, smallest.discriminant()}; };
  CgalBall<D> out{{}, root_number(smallest.radius())};
  auto c = smallest.center_cartesian_begin();
  for (int i = 0; i < D; ++i, ++c) out.center[i] = root_number(*c);
  return out;
}

template CgalBall<2> smallest_ball_by_cgal<2>(std::span<const refitlab::Ball<Rational, 2>>);
template CgalBall<3> smallest_ball_by_cgal<3>(std::span<const refitlab::Ball<Rational, 3>>);
template CgalBall<4> smallest_ball_by_cgal<4>(std::span<const refitlab::Ball<Rational, 4>>);

}  // namespace proptests::oracle
