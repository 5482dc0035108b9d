#include "lemmas/t3_one_cap.hpp"

#include "proptests/counterexamples/t3_one_cap.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using t3_cap::Case;

// Quaternions of any length, none behind the axis, which is one of them, their sum, or any direction. The best kappa.
Case any_case() {
  auto quaternions = *rc::gen::mapcat(rc::gen::inRange(1, 6), [](int m) {
    return rc::gen::container<std::vector<Quaternion<Rational>>>(m, gen::nonzero_vector<4>());
  });
  Quaternion<Rational> axis = *rc::gen::oneOf(rc::gen::just(quaternions[0]), gen::nonzero_vector<4>());
  if (*rc::gen::arbitrary<bool>() && quaternions.size() > 1) {
    Quaternion<Rational> sum = Quaternion<Rational>::Zero();
    for (auto& q : quaternions) sum += dot(q, axis) < 0 ? Quaternion<Rational>(-q) : q;
    if (squared_norm(sum) != 0) axis = sum;
  }
  for (auto& q : quaternions)
    if (dot(q, axis) < 0) q = -q;
  auto coefficients = *gen::convex_weights(static_cast<int>(quaternions.size()));
  return {quaternions, axis, squared_cap_cosine<Rational>(quaternions, axis), coefficients};
}

OneCap<Rational> cap_of(const Case& c) {
  return one_cap<Rational>(c.quaternions, c.axis, c.squared_cosine, c.coefficients);
}
Verdict hypotheses_of(const Case& c) {
  return one_cap_hypotheses<Rational>(c.quaternions, c.axis, c.squared_cosine, c.coefficients);
}

PROPTEST(t3_one_cap) {
  t.holds("the cap of the least angle cosine holds every blend, for quaternions of any length",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const Case c = any_case();
            RC_CLASSIFY(c.quaternions.size() == 1 || c.squared_cosine == 0 || c.squared_cosine == 1, "degenerate");
            RC_ASSERT(hypotheses_of(c) == Verdict::holds);
            const auto cap = cap_of(c);
            RC_ASSERT(cap.verdict == Verdict::holds);
            RC_ASSERT(is_one_cap<Rational>(c.quaternions, c.axis, c.squared_cosine, cap.gram) == Verdict::holds);
          });
  t.holds("a blend that is not 0 turns v by at most the angle of the cap, doubled",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const Case c = any_case();
            const Quaternion<Rational> blend = combine<Rational, 4>(c.coefficients, c.quaternions);
            RC_PRE(squared_norm(blend) != 0);
            RC_CLASSIFY(c.quaternions.size() == 1 || c.squared_cosine == 0 || c.squared_cosine == 1, "degenerate");
            RC_ASSERT(one_cap_rotated(blend, c.axis, c.squared_cosine, *gen::rational_vector<3>()).verdict ==
                      Verdict::holds);
          });
  t.holds("no larger kappa will do, and lengths do not matter", {.form = "beyond", .number_type = "rational"}, [] {
    Case c = any_case();
    Case larger = c;
    larger.squared_cosine += *gen::positive_rational();
    RC_ASSERT(hypotheses_of(larger) == Verdict::fails);
    for (auto& q : c.quaternions) q *= *gen::positive_rational();
    c.axis *= *gen::positive_rational();
    RC_ASSERT(squared_cap_cosine<Rational>(c.quaternions, c.axis) == c.squared_cosine);
  });
  t.holds("a zero quaternion changes no cap", {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
    Case c = any_case();
    c.quaternions.push_back(Quaternion<Rational>::Zero());
    c.coefficients = *gen::convex_weights(static_cast<int>(c.quaternions.size()));
    RC_ASSERT(hypotheses_of(c) == Verdict::holds);
    RC_ASSERT(cap_of(c).verdict == Verdict::holds);
  });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 400}, [] {
    Case c = any_case();
    if (*rc::gen::arbitrary<bool>()) c.squared_cosine = *gen::unit_interval_rational();
    const auto conclusion = []<class S>(const std::vector<Quaternion<S>>& q, const Quaternion<S>& axis, const S& kappa2,
                                        const std::vector<S>& u) { return one_cap<S>(q, axis, kappa2, u).verdict; };
    const auto hypotheses = []<class S>(const std::vector<Quaternion<S>>& q, const Quaternion<S>& axis, const S& kappa2,
                                        const std::vector<S>& u) { return one_cap_hypotheses<S>(q, axis, kappa2, u); };
    decide_by_all(conclusion, c.quaternions, c.axis, c.squared_cosine, c.coefficients);
    decide_by_all(hypotheses, c.quaternions, c.axis, c.squared_cosine, c.coefficients);
  });

  t.holds("a mutated matrix is rejected", {.number_type = "rational", .cases = 400}, [] {
    const Case c = any_case();
    const auto good = cap_of(c).gram;
    const auto rejected = [&](const Rational& kappa2, const std::vector<Rational>& gram) {
      return is_one_cap<Rational>(c.quaternions, c.axis, kappa2, gram) == Verdict::fails;
    };
    auto changed = good, shorter = good;
    changed[*rc::gen::inRange<std::size_t>(0, good.size())] += *gen::positive_rational();
    shorter.pop_back();
    RC_ASSERT(rejected(c.squared_cosine, changed));
    RC_ASSERT(rejected(c.squared_cosine, shorter));
    // The matrix of a larger kappa: as defined, but with a negative entry.
    Case larger = c;
    larger.squared_cosine += *gen::positive_rational();
    RC_ASSERT(rejected(larger.squared_cosine, cap_of(larger).gram));
  });

  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const Case& c) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis},
              [&] { return hypotheses_of(c) == Verdict::fails && cap_of(c).verdict == Verdict::fails; });
  };
  fails_without("no quaternion is behind the axis", "a quaternion behind the axis turns a blend out of the cap",
                t3_cap::behind);
  fails_without("no quaternion is behind the axis", "a quaternion behind the axis is itself a blend behind it",
                t3_cap::only_behind);
  fails_without("kappa bounds every quaternion", "a quaternion outside the cap is a blend outside the cap",
                t3_cap::too_narrow);
  fails_without("the coefficients are convex", "beyond the hull a blend leaves the cap", t3_cap::not_convex);
  t.example("at a right angle to the axis a blend may be 0", {.form = "beyond", .hypothesis = "the blend is not 0"},
            [] {
              const Case& c = t3_cap::right_angles;
              return hypotheses_of(c) == Verdict::holds && cap_of(c).verdict == Verdict::holds &&
                     squared_norm(combine<Rational, 4>(c.coefficients, c.quaternions)) == Rational(0);
            });
}

}  // namespace
}  // namespace proptests
