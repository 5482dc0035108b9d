#include "algorithms/balls/smallest_ball_of_balls.hpp"

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Min_sphere_of_spheres_d_traits_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/balls/scaling.hpp"
#include "algorithms/packs/float_environment.hpp"

namespace refitlab {
namespace {

template <class S, class UseRoots>
using SmallestOf = CGAL::Min_sphere_of_spheres_d<CGAL::Min_sphere_of_spheres_d_traits_3<CGAL::Cartesian<S>, S, UseRoots>>;
using Quick = SmallestOf<double, CGAL::Tag_true>;
using Number = CGAL::Exact_rational;
using Exact = SmallestOf<Number, CGAL::Tag_false>;

template <class Solver>
Solver solve(std::span<const Ball3<double>> balls) {
  std::vector<typename Solver::Sphere> spheres;
  spheres.reserve(balls.size());
  for (const auto& b : balls) spheres.push_back({{b.center[0], b.center[1], b.center[2]}, b.radius});
  return Solver(spheres.begin(), spheres.end());
}

Ball3<double> ball_about(const Vec<double, 3>& center, std::span<const Ball3<double>> balls) {
  Ball3<double> out{center, 0};
  for (const auto& b : balls) out.radius = std::max(out.radius, norm<double, 3>(b.center - center) + b.radius);
  return out;
}

// The greatest radius, or coordinate relative to the first center.
double size_of(std::span<const Ball3<double>> balls) {
  double size = 0;
  for (const auto& b : balls) size = std::max({size, b.radius, (b.center - balls[0].center).cwiseAbs().maxCoeff()});
  return size;
}

// In rationals, to far more digits than a double has: the solver's results are differences a + b sqrt(x) of large numbers.
Number square_root(const Number& x) {
  Number root(std::sqrt(CGAL::to_double(x)));
  for (int step = 0; step < 2 && root != 0; ++step) root = (root + x / root) / 2;
  return root;
}

// Slow, and right in degenerate cases too.
Ball3<double> solve_exactly(std::span<const Ball3<double>> balls) {
  auto smallest = solve<Exact>(balls);
  const Number root = square_root(smallest.discriminant());
  Vec<double, 3> center;
  auto c = smallest.center_cartesian_begin();
  for (int i = 0; i < 3; ++i, ++c) center[i] = CGAL::to_double(Number(c->first + c->second * root));
  return ball_about(center, balls);
}

}  // namespace

Ball3<double> smallest_ball_of_balls(std::span<const Ball3<double>> balls) {
  const DefaultFloatEnvironment environment;
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  for (const auto& b : balls)
    if (!b.center.allFinite() || !(b.radius >= 0) || !std::isfinite(b.radius))
      return {Vec<double, 3>::Constant(undefined), undefined};
  if (const int scaling = scaling_of(size_of(balls)); scaling != 0) {
    std::vector<Ball3<double>> of_size_one;
    for (const auto& b : balls)
      of_size_one.push_back({times_power_of_two(Vec<double, 3>(b.center - balls[0].center), -scaling), std::scalbn(b.radius, -scaling)});
    const Vec<double, 3> center = smallest_ball_of_balls(of_size_one).center;
    return ball_about(balls[0].center + times_power_of_two(center, scaling), balls);
  }
  auto smallest = solve<Quick>(balls);
  const double* c = smallest.center_cartesian_begin();
  const Ball3<double> out = ball_about({c[0], c[1], c[2]}, balls);
  // The solver grows a ball around few of the balls until it holds all. On grids, rounding may make it stop too early: its
  // own radius is then too small for its center.
  return out.radius <= smallest.radius() * (1 + 1e-10) ? out : solve_exactly(balls);
}

}  // namespace refitlab
