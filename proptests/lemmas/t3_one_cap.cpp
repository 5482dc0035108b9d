// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/t3_one_cap.hpp"

#include "proptests/counterexamples/t3_one_cap.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_t3_one_cap {
namespace {

using namespace refitlab;
using t3_cap::Case;

// Draws quaternions of any length, none of which is behind the axis. The axis is one of them, their sum, or any direction, and
// kappa is the best one.
Case any_case(int least = 1) {
  auto quaternions = *rc::gen::mapcat(rc::gen::inRange(least, 6), [](int m) {
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

OneCap<Rational> cap_of(const Case& c) { return one_cap<Rational>(c.quaternions, c.axis, c.squared_cosine, c.coefficients); }
Verdict hypotheses_of(const Case& c) {
  return one_cap_hypotheses<Rational>(c.quaternions, c.axis, c.squared_cosine, c.coefficients);
}

Quaternion<Rational> blend_of(const Case& c) {
  Quaternion<Rational> blend = Quaternion<Rational>::Zero();
  for (std::size_t k = 0; k < c.quaternions.size(); ++k) blend += c.quaternions[k] * c.coefficients[k];
  return blend;
}

// Returns (q_k, c)^2 / (||q_k||^2 ||c||^2).
Rational squared_cosine_to(const Case& c, std::size_t k) {
  const auto& q = c.quaternions[k];
  const Rational along = q.dot(c.axis);
  return along * along / (q.dot(q) * c.axis.dot(c.axis));
}

// Judges the statement by itself: the blend is in the cap.
Verdict one_cap_holds(const Case& c) {
  const Quaternion<Rational> blend = blend_of(c);
  const Rational along = blend.dot(c.axis);
  const bool all_ahead =
      std::all_of(c.quaternions.begin(), c.quaternions.end(), [&](const auto& q) { return q.dot(c.axis) > 0; });
  return verdict_of(along >= 0 && c.squared_cosine * c.axis.dot(c.axis) * blend.dot(blend) <= along * along &&
                    (!all_ahead || blend.dot(blend) > 0));
}

// Draws also what no hypothesis allows: quaternions on both sides, a cap that is too narrow, coefficients of any sum.
Case wild_case() {
  Case c = any_case();
  for (auto& q : c.quaternions)
    if (*rc::gen::inRange(0, 4) == 0)
      q = *rc::gen::oneOf(gen::rational_vector<4>(),
                          rc::gen::just(Quaternion<Rational>(q - c.axis * Rational(dot(q, c.axis) / squared_norm(c.axis)))));
  const std::size_t kind = gen::any_place(4);
  if (kind == 0) c.squared_cosine = *gen::unit_interval_rational();
  if (kind == 1) c.coefficients = gen::broken_weights(c.coefficients).weights;
  if (kind == 2) c.coefficients.assign(c.quaternions.size(), Rational(0));
  return c;
}

void one_cap_holds_every_blend(Suite& t) {
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
            RC_ASSERT(one_cap_rotated(blend, c.axis, c.squared_cosine, *gen::rational_vector<3>()).verdict == Verdict::holds);
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
}

void verdicts_and_witnesses_are_checked(Suite& t) {
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
    // The matrix of a larger kappa is as defined, but has a negative entry.
    Case larger = c;
    larger.squared_cosine += *gen::positive_rational();
    RC_ASSERT(rejected(larger.squared_cosine, cap_of(larger).gram));
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "each part of the hypotheses is looked at by itself", {.parts = 14, .share = 0.1},
      [] {
        Case c = any_case(3);
        const std::size_t m = c.quaternions.size(), k = gen::any_place(m);
        auto& q = c.quaternions[k];
        const std::size_t kind = gen::any_place(4);
        std::string part;
        if (kind == 0) {
          part = gen::place(k, m) + " is behind the axis";
          RC_PRE(dot(q, c.axis) > 0);
          q = -q;
        } else if (kind == 1) {
          part = gen::place(k, m) + " is just behind the axis";
          const Rational along = dot(q, c.axis) / squared_norm(c.axis) + *gen::excess();
          q -= c.axis * along;
          c.squared_cosine = 0;
        } else if (kind == 2) {
          part = gen::place(k, m) + " is outside the cap";
          for (std::size_t i = 0; i < m; ++i)
            if (squared_cosine_to(c, i) < squared_cosine_to(c, k)) std::swap(c.quaternions[i], q);
          c.squared_cosine = 1;
          for (std::size_t i = 0; i < m; ++i)
            if (i != k) c.squared_cosine = std::min<Rational>(c.squared_cosine, squared_cosine_to(c, i));
          RC_PRE(squared_cosine_to(c, k) < c.squared_cosine);
        } else {
          auto broken = gen::broken_weights(c.coefficients);
          part = broken.part;
          c.coefficients = broken.weights;
        }
        // The blend is one of those that the theorem speaks of, or the weight vertex itself.
        if (kind < 3 && *rc::gen::arbitrary<bool>()) {
          c.coefficients.assign(m, Rational(0));
          c.coefficients[k] = 1;
        }
        // A cap is one of rays: of coefficients that are not negative any sum will do, but for 0.
        const bool is_needed = kind < 3 || squared_norm(blend_of(c)) == 0 ||
                               std::any_of(c.coefficients.begin(), c.coefficients.end(), [](const Rational& u) { return u < 0; });
        return Weakening{part, hypotheses_of(c), is_needed ? std::optional(one_cap_holds(c)) : std::nullopt};
      },
      2700);
  t.holds("on the edge of a hypothesis it holds", {.number_type = "rational", .cases = 300}, [] {
    Case c = any_case(3);
    RC_ASSERT(hypotheses_of(c) == Verdict::holds);
    auto& q = c.quaternions[gen::any_place(c.quaternions.size())];
    q -= c.axis * Rational(dot(q, c.axis) / squared_norm(c.axis));  // They are at a right angle.
    c.squared_cosine = 0;
    RC_ASSERT(hypotheses_of(c) == Verdict::holds);
    RC_ASSERT(cap_of(c).verdict == Verdict::holds);
  });
}

void statements_say_their_words(Suite& t) {
  t.holds("the verdict is that of its three parts, whatever the inputs", {.number_type = "rational", .cases = 1000}, [] {
    const Case c = wild_case();
    const Quaternion<Rational> blend = blend_of(c);
    const Rational along = blend.dot(c.axis), b2 = blend.dot(blend);
    const bool all_ahead =
        std::all_of(c.quaternions.begin(), c.quaternions.end(), [&](const auto& q) { return q.dot(c.axis) > 0; });
    const bool ahead = along >= 0, inside = c.squared_cosine * c.axis.dot(c.axis) * b2 <= along * along,
               is_blend = !all_ahead || b2 > 0;
    RC_CLASSIFY(!ahead && inside && is_blend, "only the side is wrong");
    RC_CLASSIFY(ahead && !inside && is_blend, "only the angle is wrong");
    RC_CLASSIFY(ahead && inside && !is_blend, "only the blend is 0");
    RC_CLASSIFY(ahead && inside && b2 == 0 && !all_ahead, "the blend may be 0");
    const auto cap = cap_of(c);
    RC_ASSERT(cap.verdict == verdict_of(ahead && inside && is_blend));
    const std::size_t m = c.quaternions.size();
    RC_ASSERT(cap.gram.size() == m * m);
    bool is_witness = true;
    for (std::size_t k = 0; k < m; ++k) {
      is_witness = is_witness && c.quaternions[k].dot(c.axis) >= 0;
      for (std::size_t l = 0; l < m; ++l) {
        const auto &p = c.quaternions[k], &q = c.quaternions[l];
        const Rational expected = p.dot(c.axis) * q.dot(c.axis) - c.squared_cosine * c.axis.dot(c.axis) * p.dot(q);
        RC_ASSERT(cap.gram[k * m + l] == expected);
        is_witness = is_witness && expected >= 0;
      }
    }
    RC_ASSERT(is_one_cap<Rational>(c.quaternions, c.axis, c.squared_cosine, cap.gram) == verdict_of(is_witness));
  });
  t.holds("each entry of the matrix is checked from both sides, and so is the side of the axis",
          {.number_type = "rational", .cases = 200}, [] {
            Case c = any_case(3);
            const auto good = cap_of(c).gram;
            const auto rejected = [&](const std::vector<Rational>& gram) {
              return is_one_cap<Rational>(c.quaternions, c.axis, c.squared_cosine, gram) == Verdict::fails;
            };
            const Rational amount = *gen::excess();
            for (std::size_t i = 0; i < good.size(); ++i) {
              auto more = good, less = good;
              more[i] += amount;
              less[i] = good[i] > 0 ? Rational(good[i] / 2) : Rational(-amount);
              RC_ASSERT(rejected(more) && rejected(less));
            }
            auto longer = good;
            longer.push_back(Rational(0));
            RC_ASSERT(rejected(longer));
            // If all quaternions are turned round, the matrix is the same.
            RC_PRE(std::any_of(c.quaternions.begin(), c.quaternions.end(), [&](const auto& q) { return dot(q, c.axis) > 0; }));
            for (auto& q : c.quaternions) q = -q;
            RC_ASSERT(cap_of(c).gram == good && rejected(good));
          });
  t.holds("the rotated pair and its verdict are those of the rotation matrices", {.number_type = "rational", .cases = 500}, [] {
    const Quaternion<Rational> blend = *gen::nonzero_vector<4>(), axis = *gen::nonzero_vector<4>();
    const Vec<Rational, 3> v = *gen::rational_vector<3>(), zero(0, 0, 0);
    const Vec<Rational, 3> at_axis = oracle::times(oracle::affine_of(axis, zero), v),
                           rotated = oracle::times(oracle::affine_of(blend, zero), v);
    const Rational along = at_axis.dot(rotated), v2 = v.dot(v), excess = *gen::excess();
    // kappa^2 is exactly what the angle allows, a little more or less, or anything.
    Rational kappa2 = *gen::unit_interval_rational();
    if (v2 > 0 && *rc::gen::arbitrary<bool>())
      kappa2 = (along / v2 + 1) / 2 + *rc::gen::element(Rational(0), excess, Rational(-excess));
    const auto pair = one_cap_rotated(blend, axis, kappa2, v);
    RC_ASSERT(pair.at_apex == at_axis && pair.rotated == rotated);
    RC_ASSERT(pair.verdict == verdict_of(v2 * (2 * kappa2 - 1) <= along));
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const Case& c) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis},
              [&] { return hypotheses_of(c) == Verdict::fails && cap_of(c).verdict == Verdict::fails; });
  };
  fails_without("no quaternion is behind the axis", "a quaternion behind the axis turns a blend out of the cap", t3_cap::behind);
  fails_without("no quaternion is behind the axis", "a quaternion behind the axis is itself a blend behind it",
                t3_cap::only_behind);
  fails_without("kappa bounds every quaternion", "a quaternion outside the cap is a blend outside the cap", t3_cap::too_narrow);
  fails_without("the coefficients are convex", "beyond the hull a blend leaves the cap", t3_cap::not_convex);
  t.example("at a right angle to the axis a blend may be 0", {.form = "beyond", .hypothesis = "the blend is not 0"}, [] {
    const Case& c = t3_cap::right_angles;
    return hypotheses_of(c) == Verdict::holds && cap_of(c).verdict == Verdict::holds &&
           squared_norm(combine<Rational, 4>(c.coefficients, c.quaternions)) == Rational(0);
  });
}

PROPTEST(t3_one_cap) {
  one_cap_holds_every_blend(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  statements_say_their_words(t);
  reaches_share(t, "cases of several quaternions with a cap between none and all", 0.4, [] {
    const Case c = any_case();
    return c.quaternions.size() > 1 && c.squared_cosine > 0 && c.squared_cosine < 1;
  });
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_t3_one_cap
