// SPDX-License-Identifier: GPL-3.0-or-later
// Tests volume and surface area of polytopes, of k-DOPs that are known solids and of random ones.
#include "algorithms/methods/volumes/polytope.hpp"

#include <cmath>
#include <cstdio>
#include <random>

#include "algorithms/methods/volumes/k_dop.hpp"
#include "lemmas/exact/lift.hpp"
#include "proptests/gen/ball_lists.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_polytope {
namespace {

using namespace refitlab;
using gen::RationalBalls;
using gen::RationalVec;

RationalBalls as_balls(const std::vector<RationalVec<3>>& points) {
  RationalBalls out;
  for (const auto& p : points) out.push_back({p, Rational(0)});
  return out;
}

RationalBalls octahedron() { return as_balls({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}); }

RationalBalls cuboctahedron() {
  std::vector<RationalVec<3>> points;
  for (const int a : {-1, 1})
    for (const int b : {-1, 1}) points.insert(points.end(), {{a, b, 0}, {a, 0, b}, {0, a, b}});
  return as_balls(points);
}

template <int k>
bool is_solid(const RationalBalls& balls, const Rational& volume, double surface_area) {
  const auto rounded = KDop<double, k>::around(lift<double>(balls));
  return KDop<Rational, k>::around(balls).volume() == volume && std::abs(rounded.volume() - CGAL::to_double(volume)) < 1e-12 &&
         std::abs(rounded.surface_area() - surface_area) < 1e-12;
}

// Compares the share of random points of the 26-DOP's box that are in the 26-DOP with its volume.
Checked count_points() {
  std::mt19937_64 random(2006);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int lists = 60, points = 4000;
  double deviation = 0;
  for (int l = 0; l < lists; ++l) {
    std::vector<Ball3<double>> balls;
    for (int i = 0; i < 2 + l % 7; ++i)
      balls.push_back({{10 + normal(random), normal(random), normal(random)}, 0.4 * uniform(random)});
    const auto dop = KDop<double, 26>::around(balls);
    const auto box = KDop<double, 6>::around(balls);
    int inside = 0;
    for (int p = 0; p < points; ++p) {
      Vec<double, 3> x;
      for (int i = 0; i < 3; ++i) x[i] = box.low[i] + uniform(random) * (box.high[i] - box.low[i]);
      inside += dop.contains(x) == Verdict::holds;
    }
    const double share = dop.volume() / box.volume();
    deviation += (double(inside) / points - share) / std::sqrt(share * (1 - share) / points);
  }
  // It follows the standard normal distribution.
  const double z = deviation / std::sqrt(double(lists));
  char text[100];
  std::snprintf(text, sizeof text, "counted minus computed: %.2f standard deviations", z);
  return Checked(std::abs(z) < 4, lists * points, text);
}

// Moves all faces outward by h, and says whether the volume grows by h times the surface area, and by a multiple of h^2.
bool grows_by_its_surface() {
  std::mt19937_64 random(2006);
  std::normal_distribution<double> normal;
  bool good = true;
  for (int l = 0; l < 100; ++l) {
    std::vector<Ball3<double>> balls;
    for (int i = 0; i < 2 + l % 7; ++i) balls.push_back({{normal(random), normal(random), normal(random)}, 0.3});
    const auto dop = KDop<double, 26>::around(balls);
    auto larger = dop;
    constexpr double h = 1e-6;
    for (std::size_t i = 0; i < dop.directions.size(); ++i) {
      larger.low[i] -= h * length_bound(dop.directions[i]);
      larger.high[i] += h * length_bound(dop.directions[i]);
    }
    const double growth = (larger.volume() - dop.volume()) / h;
    good = good && std::abs(growth / dop.surface_area() - 1) < 1e-4;
  }
  return good;
}

}  // namespace

PROPTEST(polytope) {
  t.example("the octahedron, the rhombic dodecahedron, the cuboctahedron and the cube have their volumes and areas",
            {.number_type = "rational and double"}, [] {
              const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
              return is_solid<6>(octahedron(), 8, 24) && is_solid<14>(octahedron(), Rational(4, 3), 4 * root3) &&
                     is_solid<18>(octahedron(), 2, 6 * root2) && is_solid<26>(octahedron(), Rational(4, 3), 4 * root3) &&
                     is_solid<14>(cuboctahedron(), Rational(20, 3), 12 + 4 * root3) && is_solid<18>(cuboctahedron(), 8, 24);
            });
  t.example("what is flat has no volume, and both its sides as its area", {.number_type = "rational and double"}, [] {
    const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
    const auto triangle = as_balls({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const auto square = as_balls({{3, 0, 0}, {3, 2, 0}, {3, 0, 2}, {3, 2, 2}});
    // They are in the plane x + y = 1.
    const auto oblique = as_balls({{1, 0, 0}, {0, 1, 0}, {1, 0, 2}, {0, 1, 2}});
    return is_solid<14>(triangle, 0, root3) && is_solid<26>(triangle, 0, root3) && is_solid<6>(square, 0, 8) &&
           is_solid<26>(square, 0, 8) && is_solid<18>(oblique, 0, 4 * root2) && is_solid<26>(oblique, 0, 4 * root2) &&
           is_solid<26>(as_balls({{1, 2, 3}}), 0, 0) && is_solid<26>(as_balls({{1, 2, 3}, {1, 2, 5}}), 0, 0);
  });
  const Options options{.number_type = "rational", .cases = 100, .degenerate_at_least = 0.4};
  t.holds("the volume stays when all moves, and grows by 8 when all doubles", options, [] {
    const auto list = *gen::ball_list();
    RC_CLASSIFY(list.is_degenerate, "degenerate");
    const RationalVec<3> by = *gen::rational_vector<3>();
    auto moved = list.balls, doubled = list.balls;
    for (auto& b : moved) b.center += by;
    for (auto& b : doubled) b = {b.center * Rational(2), b.radius * Rational(2)};
    const Rational volume = KDop<Rational, 26>::around(list.balls).volume();
    RC_ASSERT(volume >= 0);
    RC_ASSERT((KDop<Rational, 26>::around(moved).volume()) == volume);
    RC_ASSERT((KDop<Rational, 26>::around(doubled).volume()) == volume * Rational(8));
  });
  t.example("the volume is the share of random points that are inside", {.number_type = "double"}, count_points);
  t.example("the surface area is the volume's growth when all faces move outward", {.number_type = "double"},
            grows_by_its_surface);
}

}  // namespace proptests::suite_polytope
