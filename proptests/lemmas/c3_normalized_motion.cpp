// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what normalising a blend of quaternions does to its motion.
#include "lemmas/c3_normalized_motion.hpp"

#include "proptests/counterexamples/c3_normalized_motion.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/jet.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_c3_normalized_motion {
namespace {

using namespace refitlab;
using gen::RationalMotion;
using gen::RationalQuaternion;
using Span = std::span<const Rational>;

struct Blend {
  Moment<Rational, 4> moment;
  RationalMotion motion;
  Rational least;
  // Its length is rational, and mostly the least one; bounds are as tight as lengths are rational.
  Blend() {
    least = *gen::positive_rational();
    motion = gen::any_motion();
    moment = gen::moment_within<4>(motion);
    moment.value = *gen::unit_quaternion() * least;
    if (*rc::gen::inRange(0, 4) == 0) least = least * *gen::unit_interval_rational() / Rational(2) + least / Rational(3);
  }
  bool is_degenerate() const { return squared_norm(moment.velocity) == 0 || squared_norm(moment.acceleration) == 0; }
  std::vector<RationalQuaternion> parts() const { return {moment.value, moment.velocity, moment.acceleration}; }
};

// Returns the derivatives of p / ||p||^2 and of p / ||p|| times any constant, by jets: p / N where N = ||p||, with N N' = (p,
// p').
Moment<Rational, 4> inverse_by_jets(const Moment<Rational, 4>& m) {
  using Jet = oracle::Jet<Rational>;
  const auto p = oracle::jets_of(m);
  const Jet length = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3];
  Vec<Jet, 4> g;
  for (int i = 0; i < 4; ++i) g[i] = p[i] / length;
  return oracle::moment_of<Rational, 4>(g);
}
Moment<Rational, 4> normalized_by_jets(const Moment<Rational, 4>& m, const Rational& length) {
  using Jet = oracle::Jet<Rational>;
  const auto p = oracle::jets_of(m);
  const Jet squared = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3];
  const Rational first = squared.first / (Rational(2) * length),
                 second = (squared.second - Rational(2) * first * first) / (Rational(2) * length);
  const Jet root(length, first, second);
  RC_ASSERT((root * root).second == squared.second);
  Vec<Jet, 4> q;
  for (int i = 0; i < 4; ++i) q[i] = p[i] / root;
  return oracle::moment_of<Rational, 4>(q);
}

void normalised_blends_move_within_the_bounds(Suite& t) {
  t.holds("a normalised blend moves within the bounds",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.02, .degenerate_at_most = 0.5}, [] {
            const Blend b;
            RC_ASSERT(normalization_hypotheses(b.moment, b.motion, b.least) == Verdict::holds);
            RC_CLASSIFY(b.is_degenerate(), "degenerate");
            const auto found = normalized_moves(b.moment, b.motion, b.least);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_normalized_moment(b.moment, b.motion, b.least, found) == Verdict::holds);
            const Rational length = upper_root(squared_norm(b.moment.value));
            const auto twin = normalized_by_jets(b.moment, length);
            const RationalQuaternion velocity = found.velocity / length, acceleration = found.acceleration / length;
            RC_ASSERT(twin.velocity == velocity && twin.acceleration == acceleration);
            RC_ASSERT(moves_within(twin, normalized_motion(b.motion, b.least)) == Verdict::holds);
          });
  t.holds("so does its inverse",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.02, .degenerate_at_most = 0.5}, [] {
            const Blend b;
            RC_CLASSIFY(b.is_degenerate(), "degenerate");
            const auto found = inverse_moves(b.moment, b.motion, b.least);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_inverse_moment(b.moment, b.motion, b.least, found.moment) == Verdict::holds);
            const auto twin = inverse_by_jets(b.moment);
            RC_ASSERT(twin.value == found.moment.value && twin.velocity == found.moment.velocity &&
                      twin.acceleration == found.moment.acceleration);
          });
  t.holds(
      "the inverse reaches its bounds, and a turn without a bend reaches those of the normalised blend",
      {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
        // p'' is such that its reflection points where the rest does.
        const Rational least = *gen::positive_rational(), speed = *gen::positive_rational(), bend = *gen::positive_rational();
        const RationalQuaternion p = *gen::unit_quaternion(), v = *gen::unit_quaternion();
        const Moment<Rational, 4> still{p * least, v * speed, RationalQuaternion::Zero()};
        const auto rest = inverse_moves<Rational>(still, {Rational(0), speed, Rational(0)}, least).moment;
        const Rational long_rest = Rational(2) * speed * speed / (least * least * least);
        RC_ASSERT(squared_norm(rest.velocity) == sq(Rational(speed / (least * least))));
        RC_ASSERT(squared_norm(rest.acceleration) == long_rest * long_rest);
        const RationalQuaternion along = rest.acceleration / long_rest;
        const Moment<Rational, 4> all{still.value, still.velocity, (along - p * Rational(Rational(2) * dot(along, p))) * bend};
        const RationalMotion motion{Rational(0), speed, bend};
        const Rational greatest = inverse_motion(motion, least).acceleration;
        RC_ASSERT(squared_norm(inverse_moves(all, motion, least).moment.acceleration) == greatest * greatest);
      });
}

// Quaternions of one length, each two of one dot product, and all weighted alike: their blend is as short as (iii) says.
struct Alike {
  std::vector<RationalQuaternion> blended;
  std::vector<Rational> weights;
  Rational cosine, squared_length;
  // They are along the axes, but for a part that all have, and turned together.
  Alike() {
    const int count = *rc::gen::inRange(1, 5);
    const Rational common = *gen::rational(), own = *gen::positive_rational();
    const RationalQuaternion turn = *gen::unit_quaternion();
    for (int k = 0; k < count; ++k) {
      RationalQuaternion q(common, common, common, common);
      q[k] += own;
      blended.push_back(multiply<Rational>(turn, q));
    }
    weights.assign(blended.size(), Rational(1, count));
    cosine = Rational(4) * sq(common) + Rational(2) * common * own;
    squared_length = cosine + sq(own);
  }
};

void blends_are_as_long_as_said(Suite& t) {
  t.holds("of given weights a blend is as long as its cosines say, and at least as long as smaller ones say",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const auto units = *gen::unit_quaternions(1, 5);
            const auto w = *gen::convex_weights(static_cast<int>(units.size()));
            std::vector<Rational> cosines, lower;
            for (std::size_t k = 0; k < units.size(); ++k)
              for (std::size_t l = k + 1; l < units.size(); ++l) {
                cosines.push_back(dot(units[k], units[l]));
                lower.push_back(cosines.back() - *gen::unit_interval_rational());
              }
            const Rational length = squared_norm(combine<Rational, 4>(w, units));
            RC_ASSERT(least_squared_blend<Rational>(w, cosines) == length);
            RC_ASSERT(least_squared_blend<Rational>(w, lower) <= length);
          });
  t.holds("a blend of close quaternions is long, of few more than of many",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.05, .degenerate_at_most = 0.7},
          [] {
            const auto units = *gen::unit_quaternions(1, 5);
            const auto w = *gen::convex_weights(static_cast<int>(units.size()));
            Rational cosine(1);
            for (const auto& a : units)
              for (const auto& b : units) cosine = std::min(cosine, dot(a, b));
            const std::span<const RationalQuaternion> all(units);
            RC_ASSERT(are_close_units(all, cosine) == Verdict::holds);
            RC_CLASSIFY(units.size() == 1 || cosine == 1 || cosine == -1, "degenerate");
            RC_ASSERT(blend_is_long(all, cosine, Span(w)) == Verdict::holds);
            RC_ASSERT(least_squared_blend<Rational>(cosine, 3) >= least_squared_blend<Rational>(cosine, 4));
            const RationalQuaternion axis = *gen::nonzero_quaternion();
            RC_ASSERT(blend_is_long_by_axis(all, axis, Span(w)) == Verdict::holds);
            RC_ASSERT(blend_is_long_by_axis(all, combine<Rational, 4>(w, units), Span(w)) == Verdict::holds);
          });
  t.holds(
      "a blend of quaternions of any lengths is as long as the shortest of them and the least dot product say",
      {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.05, .degenerate_at_most = 0.7}, [] {
        auto blended = *gen::unit_quaternions(1, 5);
        const auto w = *gen::convex_weights(static_cast<int>(blended.size()));
        for (auto& q : blended) q *= *rc::gen::element(Rational(1), Rational(999, 1000), Rational(1, 2), Rational(3));
        Rational shortest = squared_norm(blended[0]), cosine = shortest;
        for (const auto& q : blended) shortest = std::min(shortest, squared_norm(q));
        for (std::size_t k = 0; k < blended.size(); ++k)
          for (std::size_t l = 0; l < k; ++l) cosine = std::min(cosine, dot(blended[k], blended[l]));
        cosine = std::min(cosine, shortest);
        RC_CLASSIFY(blended.size() == 1 || cosine == shortest, "degenerate");
        const std::span<const RationalQuaternion> all(blended);
        RC_ASSERT(blend_is_long(all, cosine, Span(w), shortest) == Verdict::holds);
        const Alike alike;
        RC_ASSERT(blend_is_long<Rational>(alike.blended, alike.cosine, alike.weights, alike.squared_length) == Verdict::holds);
        RC_ASSERT(least_squared_blend(alike.cosine, Rational(static_cast<int>(alike.blended.size())), alike.squared_length) ==
                  squared_norm(combine<Rational, 4>(alike.weights, alike.blended)));
      });
  t.holds("the shortest blend of a pair that is just as close is as long as said, and so by its axis",
          {.form = "beyond", .number_type = "rational", .cases = 200}, [] {
            const std::vector<RationalQuaternion> pair{*gen::unit_quaternion(), *gen::unit_quaternion()};
            const std::vector<Rational> halves{Rational(1, 2), Rational(1, 2)};
            const RationalQuaternion middle = combine<Rational, 4>(halves, pair);
            RC_ASSERT(least_squared_blend<Rational>(dot(pair[0], pair[1]), 2) == squared_norm(middle));
            RC_ASSERT(least_along<Rational>(pair, middle) == squared_norm(middle));
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const Blend b;
    const Rational share = *rc::gen::element(Rational(1), Rational(1, 2));
    const RationalQuaternion bounds(b.least, b.motion.speed * share, b.motion.acceleration * share, Rational(0));
    decide_by_all(
        []<class S>(const std::vector<Quaternion<S>>& p, const Quaternion<S>& bounds) {
          const Moment<S, 4> moment{p[0], p[1], p[2]};
          const Motion<S> motion{S(0), bounds[1], bounds[2]};
          return normalized_moves<S>(moment, motion, bounds[0]).verdict;
        },
        b.parts(), bounds);
    decide_by_all(
        []<class S>(const std::vector<Quaternion<S>>& p, const Quaternion<S>& bounds) {
          const Moment<S, 4> moment{p[0], p[1], p[2]};
          const Motion<S> motion{S(0), bounds[1], bounds[2]};
          return inverse_moves<S>(moment, motion, bounds[0]).verdict;
        },
        b.parts(), bounds);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const Blend b;
    const auto i = static_cast<int>(gen::any_place(4));
    const Rational amount = *gen::excess();
    auto normalized = normalized_moves(b.moment, b.motion, b.least);
    auto inverse = inverse_moves(b.moment, b.motion, b.least).moment;
    const bool first = *rc::gen::arbitrary<bool>();
    (first ? normalized.velocity : normalized.acceleration)[i] += amount;
    RC_ASSERT(is_normalized_moment(b.moment, b.motion, b.least, normalized) == Verdict::fails);
    (first ? inverse.velocity : *rc::gen::arbitrary<bool>() ? inverse.value : inverse.acceleration)[i] += amount;
    RC_ASSERT(is_inverse_moment(b.moment, b.motion, b.least, inverse) == Verdict::fails);
  });
  t.holds("true moments that are beyond the bounds are rejected", {.number_type = "rational", .cases = 300}, [] {
    Blend b;
    const bool first = *rc::gen::arbitrary<bool>();
    const Rational little(1, 1000);
    const auto normalized = normalized_moves(b.moment, b.motion, b.least);
    const auto inverse = inverse_moves(b.moment, b.motion, b.least).moment;
    if (first) {
      RC_PRE(squared_norm(normalized.velocity) > 0 && squared_norm(inverse.velocity) > 0);
      b.motion.speed *= little * little;
      b.motion.acceleration *= Rational(1000000);
      b.motion.acceleration += Rational(1000000);
      if (b.motion.speed * Rational(1000) > b.least) return;
    } else {
      RC_PRE(squared_norm(normalized.acceleration) > 0 && squared_norm(inverse.acceleration) > 0);
      // Both bound bends: what turns too slowly for its bend is rejected as well.
      b.motion = {Rational(0), b.motion.speed * little * little * little, b.motion.acceleration * little * little * little};
    }
    const bool too_small = normalization_hypotheses(b.moment, b.motion, b.least) == Verdict::fails;
    const auto now = normalized_moves(b.moment, b.motion, b.least);
    RC_ASSERT(is_normalized_moment(b.moment, b.motion, b.least, now) == now.verdict);
    RC_ASSERT(is_inverse_moment(b.moment, b.motion, b.least, inverse) == inverse_moves(b.moment, b.motion, b.least).verdict);
    RC_CLASSIFY(too_small && now.verdict == Verdict::fails, "beyond the bounds");
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "the bounds need each part of the hypotheses", {.parts = 6, .share = 0.15},
      [] {
        // A turn without a bend on the shortest blend, or a bend across it without a turn, reaches its bound.
        const Rational least = *gen::positive_rational(), speed = *gen::positive_rational();
        const RationalQuaternion p = *gen::unit_quaternion();
        const gen::RationalVec<3> axis = gen::unit_direction();
        const RationalQuaternion across = multiply<Rational>(RationalQuaternion(Rational(0), axis[0], axis[1], axis[2]), p);
        const Rational tiny = *gen::excess(), more = speed + tiny;
        const auto verdict = [&](const Moment<Rational, 4>& m, const RationalMotion& motion, const Rational& shortest) {
          return normalized_moves(m, motion, shortest).verdict & inverse_moves(m, motion, shortest).verdict;
        };
        const auto weakened = [&](const std::string& part, const Moment<Rational, 4>& m, const RationalMotion& motion,
                                  const Rational& shortest, bool asked = true) {
          return Weakening{part, normalization_hypotheses(m, motion, shortest),
                           asked ? std::optional(verdict(m, motion, shortest)) : std::nullopt};
        };
        const Moment<Rational, 4> turn{p * least, across * speed, RationalQuaternion::Zero()},
            bend{p * least, RationalQuaternion::Zero(), across * speed},
            fast{p * least, across * more, RationalQuaternion::Zero()},
            bent{p * least, RationalQuaternion::Zero(), across * more};
        const RationalMotion of_turn{Rational(0), speed, Rational(0)}, of_bend{Rational(0), Rational(0), speed};
        switch (gen::any_place(6)) {
          case 0: return weakened("the blend is shorter than the least", turn, of_turn, Rational(least + tiny));
          case 1: return weakened("the blend is faster", fast, of_turn, least);
          case 2: return weakened("the blend bends more", bent, of_bend, least);
          case 3: return weakened("the least is not positive", turn, of_turn, Rational(-least), false);
          case 4: return weakened("the speed's bound is negative", turn, {Rational(0), -speed, Rational(0)}, least, false);
          default:
            return weakened("the acceleration's bound is negative", bend, {Rational(0), Rational(0), -speed}, least, false);
        }
      },
      500);
  needs_each_part(t, "the length of a blend needs each part of its hypotheses", {.parts = 4, .share = 0.2}, [] {
    std::vector<RationalQuaternion> units{*gen::unit_quaternion(), *gen::unit_quaternion(), *gen::unit_quaternion()};
    std::vector<Rational> w(3, Rational(0));
    const std::size_t k = gen::any_place(3), l = (k + 1 + gen::any_place(2)) % 3;
    w[k] = w[l] = Rational(1, 2);
    units[3 - k - l] = units[k];
    Rational cosine = dot(units[k], units[l]);
    std::string part;
    if (*rc::gen::arbitrary<bool>()) {
      part = "the cosine is greater than theirs";
      cosine = std::min(Rational(1), Rational(cosine + *rc::gen::element(Rational(2), Rational(1, 2))));
      if (cosine == dot(units[k], units[l])) cosine += *gen::excess();
    } else {
      part = gen::place(k, 3) + " is no unit";
      units[l] = units[k], units[k] = units[k] * Rational(1, 10), cosine = Rational(1, 10);
    }
    const std::span<const RationalQuaternion> all(units);
    return Weakening{part, are_close_units(all, cosine), blend_is_long(all, cosine, Span(w))};
  });
}

void pinned_cases(Suite& t) {
  t.example("half-way between far quaternions the turn is faster than the blend, as the bounds say",
            {.form = "beyond", .hypothesis = "||p|| >= m"}, [] {
              using namespace c3;
              return normalized_moves(half_way, of_half_way, length).verdict == Verdict::holds &&
                     normalization_hypotheses(half_way, of_half_way, Q(1)) == Verdict::fails &&
                     moves_like_its_blend(half_way, of_half_way) == Verdict::fails &&
                     normalized_motion(of_half_way, length).speed == Q(8, 3);
            });
  t.example("near 0 a blend turns as fast as it wants to", {.form = "beyond", .hypothesis = "m > 0"}, [] {
    using namespace c3;
    const auto found = normalized_moves(nearly_zero, of_nearly_zero, Q(1, 1000));
    return found.verdict == Verdict::holds && squared_norm(found.velocity) == sq(Q(1000)) * squared_norm(nearly_zero.value);
  });
  t.example("the greatest bend without a bend of the blend is nearly reached", {.form = "beyond"}, [] {
    using namespace c3;
    // 37/32 is at least 2/sqrt(3), by less than 0.2 %.
    // This is a little more than sqrt(74).
    const Motion motion{0, Q(8602326, 1000000), 0};
    const auto found = normalized_moves(greatest_bend, motion, Q(1));
    const Motion less{0, motion.speed * Q(998, 1000), 0};
    return Q(37, 32) * Q(37, 32) * 3 >= 4 && Q(37, 32) * Q(37, 32) * 3 < Q(1003 * 4, 1000) && found.verdict == Verdict::holds &&
           squared_norm(normalized_moves(greatest_bend, motion, Q(1)).acceleration) >
               sq(normalized_motion(less, Q(1)).acceleration) &&
           normalization_hypotheses(greatest_bend, less, Q(1)) == Verdict::fails;
  });
  t.example("opposite quaternions have no blend of any length, and none is promised",
            {.form = "beyond", .hypothesis = "no less than c"}, [] {
              using namespace c3;
              return least_squared_blend(Q(-1), Q(2)) == 0 && blend_is_long<Q>(opposite, Q(0), halves) == Verdict::fails &&
                     least_squared_blend(Q(0), Q(2)) == Q(1, 2) &&
                     blend_is_long<Q>(right_angle, Q(0), halves) == Verdict::holds &&
                     least_along<Q>(opposite, {1, 0, 0, 0}) == -1;
            });
}

PROPTEST(c3_normalized_motion) {
  normalised_blends_move_within_the_bounds(t);
  blends_are_as_long_as_said(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c3_normalized_motion
