// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/batch/rotation_bound_packs.hpp"

#include <random>

#include "proptests/harness.hpp"
#include "proptests/session.hpp"

namespace proptests::suite_rotation_bound_packs {
namespace {

using namespace refitlab;

// Returns close, far and opposite unit quaternions, and now and then one that is not a number.
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

template <class S>
bool is_near(S a, S b) {
  return std::abs(a - b) <= 8 * std::numeric_limits<S>::epsilon();
}

template <class S>
void properties(Suite& t, const std::string& number_type) {
  using P = Pack<S>;
  t.example("each lane is bound_rotations of its quaternions: " + number_type, {.number_type = number_type + " pack"}, [] {
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
      const auto found = bound_rotations_packs<S>(std::span<const Quaternion<P>>(packs), direction);
      for (std::size_t lane = 0; lane < P::size(); ++lane, ++lanes) {
        Quaternion<S> sum;
        for (int i = 0; i < 4; ++i) sum[i] = direction[i][lane];
        auto expected = bound_rotations<S>(scalars[lane], sum);
        // max_of may pass over such a number.
        for (const auto& q : scalars[lane])
          if (q.hasNaN()) expected = all_rotations<S>();
        any += expected.center_ratio == 0;
        bool same =
            is_near<S>(found.center_ratio[lane], expected.center_ratio) &&
            is_near<S>(found.radius_ratio[lane] * found.radius_ratio[lane], expected.radius_ratio * expected.radius_ratio);
        for (int i = 0; i < 4; ++i)
          same = same && (expected.center_ratio == 0 || is_near<S>(found.apex[i][lane], expected.apex[i]));
        for (int i = 0; i < 4; ++i) same = same && std::isfinite(S(found.apex[i][lane]));
        if (!same) return Checked(false, c);
      }
    }
    return Checked(any > lanes / 10 && any < lanes / 2, lanes, std::to_string(any) + " of all rotations");
  });
}

}  // namespace

PROPTEST(rotation_bound_packs) {
  properties<float>(t, "float");
  properties<double>(t, "double");
}

}  // namespace proptests::suite_rotation_bound_packs
