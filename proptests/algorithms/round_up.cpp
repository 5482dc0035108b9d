// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that what is raised encloses, and by no more than is needed: radii by rounded_up, balls in float, and the least float
// above.
#include "algorithms/runtime/balls/round_up.hpp"

#include <cmath>
#include <random>

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"

namespace proptests::suite_round_up {
namespace {

using namespace refitlab;

// Returns numbers of all sizes that a model may have, also denormals and 0; often they are of one size.
double any(std::mt19937_64& random, int common) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto kind = random() % 8;
  return kind == 0 ? 0 : std::scalbn(uniform(random), kind < 6 ? common : -1074 + static_cast<int>(random() % 1207));
}

template <class S, int D>
void measured(Suite& t, const std::string& name) {
  t.example("the ball that was measured is raised to enclose, exactly, and by less than 1e-15 of it or 1e-6 in float: " + name,
            {.number_type = sizeof(S) == 8 ? "double" : "float"}, [] {
              std::mt19937_64 random(Session::get().seed());
              const long cases = Session::get().cases_for(20000);
              const double most = sizeof(S) == 8 ? 2e-15 : 2e-6;
              for (long c = 0; c < cases; ++c) {
                const int common =
                    sizeof(S) == 8 ? -1074 + static_cast<int>(random() % 1207) : -149 + static_cast<int>(random() % 200);
                std::vector<Ball<S, D>> balls(1 + random() % 4);
                for (auto& b : balls) {
                  for (int i = 0; i < D; ++i) {
                    const double x = any(random, common);
                    b.center[i] = S(std::abs(x) < 0x1p58 || sizeof(S) == 8 ? x : 1.);
                  }
                  const double r = std::abs(any(random, common));
                  b.radius = S(r < 0x1p58 || sizeof(S) == 8 ? r : 1.);
                }
                const Ball<S, D> as_computed = mean_ball<S, D>(std::span<const Ball<S, D>>(balls)), up = rounded_up(as_computed);
                const Ball<Rational, D> around{convert<Rational>(Vec<double, D>(up.center.template cast<double>())),
                                               Rational(double(up.radius))};
                for (const auto& b : balls)
                  if (encloses(around, Ball<Rational, D>{convert<Rational>(Vec<double, D>(b.center.template cast<double>())),
                                                         Rational(double(b.radius))}) != Verdict::holds)
                    return Checked(false, c, "case " + std::to_string(c));
                if (!(up.radius <= as_computed.radius * S(1 + most) + 2 * underflow_of_distance<S>()))
                  return Checked(false, c, "too much, case " + std::to_string(c));
              }
              return Checked(true, cases);
            });
}

}  // namespace

PROPTEST(round_up) {
  measured<double, 3>(t, "in R^3");
  measured<double, 4>(t, "in R^4");
  measured<float, 3>(t, "in R^3");
  t.example("infinity and what is not a number stay", {}, [] {
    const Ball3<double> infinite{{1, 2, 3}, INFINITY}, none{{1, 2, 3}, std::nan("")};
    return rounded_up(infinite).radius == INFINITY && rounded_up(infinite).center == infinite.center &&
           std::isnan(rounded_up(none).radius);
  });
  t.example(
      "a ball in float encloses that in double, exactly, by hardly more than float's digits; beyond its range it is all of space",
      {.number_type = "float"}, [] {
        std::mt19937_64 random(Session::get().seed() + 1);
        const long cases = Session::get().cases_for(40000);
        long infinite = 0;
        for (long c = 0; c < cases; ++c) {
          const int common = -1074 + static_cast<int>(random() % 1207);
          Ball3<double> ball;
          for (double& x : ball.center) x = any(random, common);
          ball.radius = std::abs(any(random, common));
          const Ball3<float> small = rounded_outward(ball);
          if (!small.center.allFinite()) return Checked(false, c, "no center, case " + std::to_string(c));
          const double size = std::max(ball.radius, ball.center.cwiseAbs().maxCoeff());
          if (small.radius == INFINITY) {
            ++infinite;
            if (size < 0x1p127) return Checked(false, c, "all of space, case " + std::to_string(c));
            continue;
          }
          const Ball3<Rational> around{convert<Rational>(Vec<double, 3>(small.center.cast<double>())),
                                       Rational(double(small.radius))};
          if (encloses(around, Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}) != Verdict::holds ||
              !(small.radius <= ball.radius + 0x1p-22 * size + 0x1p-147))
            return Checked(false, c, "case " + std::to_string(c));
        }
        return Checked(infinite > 0 && 10 * infinite < cases, cases, std::to_string(infinite) + " are all of space");
      });
  t.example(
      "the least float that is not below a double: of floats the same, beyond their range infinity, of denormals too", {}, [] {
        std::mt19937_64 random(Session::get().seed() + 2);
        const long cases = Session::get().cases_for(100000);
        for (long c = 0; c < cases; ++c) {
          const double x = c % 5 ? any(random, -160 + static_cast<int>(random() % 290)) : static_cast<float>(any(random, -20));
          if (!std::isfinite(x)) continue;
          const float f = float_above(x);
          const float before = std::nextafter(f, -INFINITY);
          if (!(f >= x) || !(before < x)) return Checked(false, c, std::to_string(x));
        }
        return Checked(float_above(0x1p130) == INFINITY && float_above(0) == 0 && float_above(0x1p-200) == 0x1p-149f, cases);
      });
}

}  // namespace proptests::suite_round_up
