// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/methods/balls/few_points_ball_packs.hpp"

#include "proptests/gen/point_cloud.hpp"
#include "proptests/harness.hpp"
#include "proptests/session.hpp"

namespace proptests::suite_few_points_ball_packs {
namespace {

using namespace refitlab;
using gen::Shape;
namespace simd = std::experimental;

// Holds clouds of the same number of points, one for each lane, and the lanes as packs.
template <class Pack, int D>
struct Clouds {
  using S = typename Pack::value_type;
  Clouds(std::mt19937_64& random, int n) {
    for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
      lanes.emplace_back();
      const double offset = lane % 2 ? 1e3 : 0;
      for (const auto& p : gen::rounded_cloud<D>(random, static_cast<Shape>(random() % gen::shape_count), n, offset))
        lanes.back().push_back(p.template cast<S>());
    }
  }
  std::vector<PackPoint<Pack, D>> packs() const {
    std::vector<PackPoint<Pack, D>> out(lanes[0].size());
    for (std::size_t j = 0; j < out.size(); ++j)
      for (int i = 0; i < D; ++i) out[j][i] = Pack([&](auto lane) { return lanes[lane][j][i]; });
    return out;
  }
  std::vector<std::vector<Vec<S, D>>> lanes;
};

// Says whether the lane's radius is that of the farthest point, and of the scalar kernel's ball but for rounding, and whether its
// certificate is about the points of the lane.
template <class Pack, int D>
bool is_right(const SmallestBallPack<Pack, D>& found, std::size_t lane,
              std::span<const Vec<typename Pack::value_type, D>> points) {
  using S = typename Pack::value_type;
  constexpr S epsilon = std::numeric_limits<S>::epsilon();
  if (!found.converged[lane]) return false;
  Vec<S, D> center, mean = Vec<S, D>::Zero();
  S sum(0), size(0), low(0);
  for (int i = 0; i < D; ++i) center[i] = found.center[i][lane];
  for (int k = 0; k <= D; ++k) {
    const int index = static_cast<int>(found.support[k][lane]);
    const S u = found.coefficients[k][lane];
    if (!(u >= 0) || index >= static_cast<int>(points.size()) || (index < 0 && u != 0)) return false;
    if (index < 0) continue;
    sum += u;
    mean = mean + (points[index] - points[0]) * u;
    low += u * squared_distance(points[index], center);
  }
  for (const auto& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  const S squared = found.squared_radius[lane], radius = std::sqrt(squared);
  const S slack = 128 * epsilon * radius + 4 * epsilon * size;
  return squared == farthest_squared_distance(center, points) && std::abs(sum - 1) < 32 * epsilon &&
         norm<S, D>(points[0] + mean - center) <= slack && std::sqrt(low) >= radius - slack &&
         std::abs(as_ball(few_points_ball(points)).radius - radius) <= slack;
}

template <class Pack, int D>
void properties(Suite& t, const std::string& name) {
  const std::string number_type = sizeof(typename Pack::value_type) == 8 ? "double pack" : "float pack";
  t.example("every lane's ball is certified and is the scalar kernel's: " + name, {.number_type = number_type}, [] {
    std::mt19937_64 random(Session::get().seed());
    const long cases = Session::get().cases_for(8000) / static_cast<long>(Pack::size());
    long redone = 0;
    for (long c = 0; c < cases; ++c) {
      const Clouds<Pack, D> clouds(random, 1 + static_cast<int>(random() % (c % 50 == 0 ? 70 : 20)));
      const auto packs = clouds.packs();
      const auto found = few_points_balls<Pack, D>(packs);
      redone += static_cast<long>(Pack::size()) - popcount(FewPointsPacks<Pack, D>(packs).solve().converged);
      for (std::size_t lane = 0; lane < Pack::size(); ++lane)
        if (!is_right<Pack, D>(found, lane, clouds.lanes[lane])) return Checked(false, c, "case " + std::to_string(c));
    }
    const long lanes = cases * static_cast<long>(Pack::size());
    return Checked(100 * redone <= lanes, lanes, std::to_string(redone) + " lanes redone");
  });
  t.example("a lane that is not finite or whose squares underflow is redone, and the others are not touched: " + name,
            {.number_type = number_type}, [] {
              using S = typename Pack::value_type;
              std::mt19937_64 random(Session::get().seed());
              for (int c = 0; c < 200; ++c) {
                Clouds<Pack, D> clouds(random, 1 + c % 20);
                const std::size_t bad = random() % Pack::size();
                auto& cloud = clouds.lanes[bad];
                const bool tiny = c % 4 == 3;
                if (tiny)
                  for (auto& p : cloud) p = p * std::sqrt(std::numeric_limits<S>::min()) * S(1e-3);
                else cloud[random() % cloud.size()][c % D] = c % 4 == 0 ? S(NAN) : c % 4 == 1 ? S(INFINITY) : -S(INFINITY);
                const auto found = few_points_balls<Pack, D>(clouds.packs());
                for (std::size_t lane = 0; lane < Pack::size(); ++lane)
                  if (lane != bad && !is_right<Pack, D>(found, lane, clouds.lanes[lane])) return false;
                const bool is_nan = std::isnan(found.squared_radius[bad]);
                if (tiny ? is_nan : !is_nan || found.converged[bad] || found.support[0][bad] != -1) return false;
              }
              return true;
            });
}

// Checks that a point stays in the certificate if its coefficient is lowered to 0 but for rounding.
void coefficient_at_zero(Suite& t) {
  t.example("a coefficient that rounding would take below 0 is 0", {.number_type = "double pack"}, [] {
    using Pack = simd::native_simd<double>;
    const std::vector<Vec<double, 3>> cloud = {{1000, 1000.1, 1000.1},   {1000, 1000.2, 1000.3},   {1000.2, 1000.1, 1000.1},
                                               {1000.3, 1000.3, 1000.3}, {1000.2, 1000.2, 1000.2}, {1000.3, 1000, 1000.3},
                                               {1000, 1000.3, 1000.2},   {1000.1, 1000, 1000.2},   {1000.1, 1000.1, 1000.2}};
    std::vector<PackPoint<Pack, 3>> packs(cloud.size());
    for (std::size_t j = 0; j < cloud.size(); ++j)
      for (int i = 0; i < 3; ++i) packs[j][i] = Pack(cloud[j][i]);
    const auto found = few_points_balls<Pack, 3>(packs);
    int zeros = 0;
    for (int k = 0; k < 4; ++k) zeros += found.support[k][0] >= 0 && found.coefficients[k][0] == 0;
    return Checked(is_right<Pack, 3>(found, 0, cloud) && zeros > 0, 1, std::to_string(zeros) + " are 0");
  });
}

}  // namespace

PROPTEST(few_points_ball_packs) {
  properties<simd::native_simd<double>, 3>(t, "native packs in R^3");
  properties<simd::native_simd<double>, 4>(t, "native packs in R^4");
  properties<simd::native_simd<float>, 4>(t, "native packs in R^4, float");
  properties<simd::fixed_size_simd<double, 8>, 3>(t, "eight lanes in R^3");
  coefficient_at_zero(t);
}

}  // namespace proptests::suite_few_points_ball_packs
