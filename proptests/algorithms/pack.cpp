// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/packs/pack.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "algorithms/runtime/packs/targets.hpp"
#include "lemmas/rotation_bound.hpp"
#include "lemmas/vocabulary/rigid.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"

namespace proptests::suite_pack {
namespace {

using namespace refitlab;

template <int D, class S>
Vec<S, D> numbers_of(const Vec<Pack<S>, D>& v, std::size_t lane) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = v[i][lane];
  return out;
}

// Draws unit quaternions that are close to each other, far apart, or opposite, and now and then one that is not a number.
template <class S>
std::vector<Quaternion<S>> unit_quaternions(std::mt19937_64& random, std::size_t count) {
  std::normal_distribution<S> normal;
  const auto drawn = [&] { return Quaternion<S>(normal(random), normal(random), normal(random), normal(random)).normalized(); };
  const Quaternion<S> middle = drawn();
  const S spread = std::pow(S(10), -S(random() % 6));
  std::vector<Quaternion<S>> out;
  for (std::size_t k = 0; k < count; ++k) {
    Quaternion<S> q = (middle + drawn() * spread).normalized();
    if (random() % 20 == 0 && k > 0) q = -out[0];
    if (random() % 50 == 0) q = Quaternion<S>::Constant(NAN);
    out.push_back(q);
  }
  return out;
}

// Says whether one lane of the bound is the scalar bound of the same quaternions, all of whose numbers are finite.
template <class S>
bool is_lane_of(const RotationBound<Pack<S>>& packs, std::size_t lane, const RotationBound<S>& scalar) {
  return numbers_of<4, S>(packs.apex, lane) == scalar.apex && packs.center_ratio[lane] == scalar.center_ratio &&
         packs.radius_ratio[lane] == scalar.radius_ratio && std::isfinite(scalar.radius_ratio);
}

template <class S>
Checked rotation_bounds_are_those_of_numbers() {
  using P = Pack<S>;
  std::mt19937_64 random(Session::get().seed());
  const long cases = Session::get().cases_for(4000);
  long any = 0, lanes = 0;
  for (long c = 0; c < cases; ++c) {
    const std::size_t m = 1 + random() % 6;
    std::vector<Quaternion<P>> packs(m);
    std::vector<std::vector<Quaternion<S>>> scalars;
    Quaternion<P> direction;
    for (std::size_t lane = 0; lane < P::size(); ++lane) {
      scalars.push_back(unit_quaternions<S>(random, m));
      Quaternion<S> sum = Quaternion<S>::Zero();
      for (std::size_t k = 0; k < m; ++k) {
        sum += scalars.back()[k];
        for (int i = 0; i < 4; ++i) packs[k][i][lane] = scalars.back()[k][i];
      }
      for (int i = 0; i < 4; ++i) direction[i][lane] = sum[i];
    }
    const auto found = bound_rotations<P>(packs, direction);
    for (std::size_t lane = 0; lane < P::size(); ++lane, ++lanes) {
      const auto expected = bound_rotations<S>(scalars[lane], numbers_of<4, S>(direction, lane));
      const bool has_none = std::any_of(scalars[lane].begin(), scalars[lane].end(), [](const auto& q) { return q.hasNaN(); });
      any += expected.center_ratio == 0;
      if (!is_lane_of<S>(found, lane, expected) || (has_none && expected.center_ratio != 0)) return Checked(false, c);
    }
  }
  return Checked(any > lanes / 10 && any < lanes / 2, lanes, std::to_string(any) + " of all rotations");
}

template <class S>
void properties(Suite& t, const std::string& number_type) {
  using P = Pack<S>;
  t.example("a transform of packs is, lane by lane, the transform of numbers, to the last bit: " + number_type,
            {.number_type = number_type + " pack"}, [] {
              std::mt19937_64 random(Session::get().seed());
              std::normal_distribution<S> normal;
              const auto drawn = [&] { return P([&](auto) { return normal(random); }); };
              const long cases = Session::get().cases_for(4000);
              for (long c = 0; c < cases; ++c) {
                const Quaternion<P> q(drawn(), drawn(), drawn(), drawn());
                const Vec<P, 3> x(drawn(), drawn(), drawn()), y(drawn(), drawn(), drawn());
                const Quaternion<P> unit = q / norm(q);
                const RigidTransform<P> rigid{unit, y};
                const Vec<P, 3> moved = apply(inverse(rigid), x), scaled = rotate_scaled(q, x);
                const P larger = max_of(x[0], y[0]), smaller = min_of(x[0], y[0]);
                for (std::size_t lane = 0; lane < P::size(); ++lane) {
                  const Quaternion<S> own = numbers_of<4, S>(q, lane);
                  const Vec<S, 3> a = numbers_of<3, S>(x, lane), b = numbers_of<3, S>(y, lane);
                  const RigidTransform<S> scalar{own / norm(own), b};
                  if (numbers_of<3, S>(moved, lane) != apply(inverse(scalar), a) ||
                      numbers_of<3, S>(scaled, lane) != rotate_scaled(own, a) || larger[lane] != std::max(a[0], b[0]) ||
                      smaller[lane] != std::min(a[0], b[0]))
                    return Checked(false, c);
                }
              }
              return Checked(true, cases);
            });
  t.example("rotation bounds of packs are, lane by lane, those of numbers, to the last bit: " + number_type,
            {.number_type = number_type + " pack"}, rotation_bounds_are_those_of_numbers<S>);
}

}  // namespace

PROPTEST(pack) {
  properties<double>(t, "double");
  properties<float>(t, "float");
  t.example("the baseline is always there, targets come narrowest first", {}, [] {
    const auto& targets = available_targets();
    return targets.front() == Target::baseline && std::is_sorted(targets.begin(), targets.end()) &&
           best_target() == targets.back();
  });
}

}  // namespace proptests::suite_pack
