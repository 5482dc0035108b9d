// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/packs/pack.hpp"

#include <random>

#include "algorithms/runtime/packs/targets.hpp"
#include "lemmas/vocabulary/rigid.hpp"
#include "proptests/harness.hpp"
#include "proptests/session.hpp"

namespace proptests::suite_pack {
namespace {

using namespace refitlab;

template <int D, class S>
Vec<S, D> numbers_of(const Vec<Pack<S>, D>& v, std::size_t lane) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = v[i][lane];
  return out;
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
