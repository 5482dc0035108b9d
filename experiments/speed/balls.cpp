// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/balls.hpp"

#include <CGAL/Min_sphere_of_spheres_d.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <random>
#include <stdexcept>

#include "algorithms/methods/balls/few_points_ball_packs.hpp"
#include "algorithms/methods/balls/near_smallest_ball.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab {
namespace {

constexpr std::uint64_t seed = 2006;
constexpr int cloud_count = 256;
constexpr char random_points[] = "random points", control_points[] = "control points";
using Doubles = Pack<double>;

// PlainSpheres are the fastest road to CGAL's solver in double. They are plain arrays, of radius 0.
template <int dimension>
struct PlainSpheres {
  struct Sphere {
    const double* center;
  };
  using FT = double;
  using Cartesian_const_iterator = const double*;
  using Use_square_roots = CGAL::Tag_true;
  using Algorithm = CGAL::Default_algorithm;
  static const int D = dimension;
  static Cartesian_const_iterator center_cartesian_begin(const Sphere& s) { return s.center; }
  static double radius(const Sphere&) { return 0; }
};

template <int D>
Ball<double, D> ball_by_cgal(std::span<const Vec<double, D>> points) {
  std::array<typename PlainSpheres<D>::Sphere, 32> spheres;
  for (std::size_t k = 0; k < points.size(); ++k) spheres[k].center = points[k].data();
  CGAL::Min_sphere_of_spheres_d<PlainSpheres<D>> smallest(spheres.begin(), spheres.begin() + points.size());
  return {Vec<double, D>(smallest.center_cartesian_begin()), smallest.radius()};
}

template <int D>
struct Clouds {
  std::vector<std::vector<Vec<double, D>>> points;
  std::vector<std::vector<PackPoint<Doubles, D>>> packs;  // the same, a cloud a lane
  std::vector<std::vector<Ball3<double>>> balls;          // the same with radius 0, in R^3
};

Quaternion<double> any_unit(std::mt19937_64& random, const Quaternion<double>& near, double spread) {
  std::normal_distribution<double> normal(0, spread);
  Quaternion<double> q = near;
  for (int i = 0; i < 4; ++i) q[i] += normal(random);
  return q / norm(q);
}

template <int D>
std::vector<Vec<double, D>> cloud(std::mt19937_64& random, const std::string& kind, int n) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vec<double, D>> points(n);
  const Quaternion<double> mean = any_unit(random, Quaternion<double>::Zero(), 1);
  std::array<Quaternion<double>, 3> corners;
  for (auto& q : corners) q = any_unit(random, mean, 0.2);
  const Vec<double, 3> x(normal(random), normal(random), normal(random));
  for (auto& p : points) {
    if (kind == random_points) {
      for (int i = 0; i < D; ++i) p[i] = normal(random);
      continue;
    }
    const double u = uniform(random), v = uniform(random) * (1 - u);
    const Quaternion<double> blend = corners[0] * u + corners[1] * v + corners[2] * (1 - u - v);
    const Quaternion<double> unit = blend / norm(blend);
    if constexpr (D == 3) p = rotate(unit, x);
    else p = unit;
  }
  return points;
}

template <int D>
Clouds<D> draw_clouds(const std::string& kind, int n) {
  std::mt19937_64 random(seed + n);
  Clouds<D> clouds;
  for (int c = 0; c < cloud_count; ++c) clouds.points.push_back(cloud<D>(random, kind, n));
  for (std::size_t c = 0; c < cloud_count; c += Doubles::size()) {
    auto& pack = clouds.packs.emplace_back(n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < D; ++i) pack[j][i] = Doubles([&](auto lane) { return clouds.points[c + lane][j][i]; });
  }
  if constexpr (D == 3)
    for (const auto& points : clouds.points) {
      clouds.balls.emplace_back();
      for (const auto& p : points) clouds.balls.back().push_back({p, 0});
    }
  return clouds;
}

template <int D>
void require_equal_radii(const Clouds<D>& clouds) {
  for (std::size_t c = 0; c < cloud_count; ++c) {
    const std::span<const Vec<double, D>> points(clouds.points[c]);
    const auto packs = few_points_balls<Doubles, D>(clouds.packs[c / Doubles::size()]);
    const double radius = as_ball(few_points_ball(points)).radius, slack = 1e-10 * radius;
    for (const double other : {as_ball(smallest_ball(points)).radius, ball_by_cgal(points).radius,
                               std::sqrt(packs.squared_radius[c % Doubles::size()])})
      if (!(std::abs(other - radius) <= slack))
        throw std::runtime_error("ball speed: of " + std::to_string(points.size()) + " points of R^" + std::to_string(D) +
                                 ", two kernels find radii " + format_number(radius) + " and " + format_number(other));
  }
}

template <int D>
void measure(const std::string& kind, int n, const SpeedSettings& settings, std::vector<BallSpeed>& results) {
  const Clouds<D> clouds = draw_clouds<D>(kind, n);
  require_equal_radii(clouds);
  std::vector<Timed> timed;
  const auto add = [&](const std::string& name, const auto& lists, auto&& solve) {
    timed.push_back({name, cloud_count, [&lists, solve] {
                       for (const auto& list : lists) benchmark::DoNotOptimize(solve(list));
                     }});
  };
  using Points = std::span<const Vec<double, D>>;
  add("mean", clouds.points, [](Points p) { return mean_ball(p); });
  if constexpr (D == 3)
    add("near_smallest", clouds.balls, [](std::span<const Ball3<double>> b) { return near_smallest_ball(b, 8); });
  add("walk", clouds.points, [](Points p) { return smallest_ball(p); });
  add("pivots", clouds.points, [](Points p) { return few_points_ball(p); });
  add("pivots_in_packs_of_" + std::to_string(Doubles::size()), clouds.packs,
      [](std::span<const PackPoint<Doubles, D>> p) { return few_points_balls<Doubles, D>(p); });
  add("cgal", clouds.points, [](Points p) { return ball_by_cgal(p); });
  const auto times = ns_per_item(timed, settings);
  const auto least = [&times](const std::string& name) {
    return *std::min_element(times.at(name).begin(), times.at(name).end());
  };
  for (const Timed& t : timed) {
    results.push_back({kind, "R^" + std::to_string(D), t.name, n, least(t.name), least(t.name) / least("cgal")});
    const BallSpeed& r = results.back();
    std::printf("  %-14s %s %2d points %-22s %7.1f ns, %5.3f times cgal\n", kind.c_str(), r.space.c_str(), n, t.name.c_str(),
                r.ns, r.ratio_to_cgal);
  }
}

}  // namespace

std::vector<BallSpeed> run_ball_speed(const SpeedSettings& settings) {
  std::cout << "[speed] smallest balls of few points: " << settings.repetitions << " repetitions" << std::endl;
  // Runs are so short, but five times as many, that some of them are not disturbed by other programs.
  const SpeedSettings short_runs{settings.seconds_per_run / 25, 5 * settings.repetitions};
  std::vector<BallSpeed> results;
  for (const char* kind : {random_points, control_points})
    for (const int n : {2, 4, 8, 12, 16, 20}) {
      measure<3>(kind, n, short_runs, results);
      measure<4>(kind, n, short_runs, results);
    }
  return results;
}

void write_ball_speed(const std::vector<BallSpeed>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit"});
  for (const BallSpeed& r : results) {
    const std::string points = std::to_string(r.points);
    file.add({"ball_speed", r.clouds, r.space, r.variant, points, "ns", format_number(r.ns), "ns"}, seed);
    file.add({"ball_speed", r.clouds, r.space, r.variant, points, "ratio_to_cgal", format_number(r.ratio_to_cgal), "1"}, seed);
  }
  file.write(path);
}

}  // namespace refitlab
