// SPDX-License-Identifier: GPL-3.0-or-later
// Tests a curve against its chord.
#include "lemmas/c1_chord_bound.hpp"

#include "proptests/counterexamples/c1_chord_bound.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/jet.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_c1_chord_bound {
namespace {

using namespace refitlab;
using gen::BoundedCurve;
using gen::RationalVec;
using Curve = CubicCurve<Rational, 3>;

bool is_degenerate(const BoundedCurve& c) { return c.is_line || c.share == 0 || c.share == 1; }

// Returns a rational speed that is no less than the lengths of the velocities' Bezier points, and close.
Rational speed_of(const Curve& curve) {
  Rational greatest(0);
  for (const auto& v : curve.velocities()) greatest = std::max(greatest, squared_norm(v));
  return upper_root(greatest);
}

// Returns the squared distance of the curve from its chord.
Rational squared_deviation(const Curve& curve, const Rational& share) {
  return squared_distance<Rational, 3>(curve.at(share), between<Rational, 3>(curve.points[0], curve.points[3], share));
}

// Draws a curve that runs there at one speed and back at another.
Curve straight(const RationalVec<3>& along, const Rational& first, const Rational& second, const Rational& third) {
  const RationalVec<3> from = *gen::rational_vector<3>(), p = from + along * first, q = p + along * second;
  return {{from, p, q, RationalVec<3>(q + along * third)}, *gen::positive_rational()};
}

void curves_are_near_their_chords(Suite& t) {
  t.holds("a curve is as near to its chord as its second derivative allows",
          {.form = "beyond",
           .number_type = "rational",
           .degenerate_at_least = 0.05,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"parabola", 0.2}}},
          [] {
            const BoundedCurve c = gen::bounded_curve();
            RC_ASSERT(chord_hypotheses(c.curve, c.acceleration, c.share) == Verdict::holds);
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            RC_CLASSIFY(c.is_parabola, "parabola");
            const auto found = point_near_chord(c.curve, c.acceleration, c.share);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_chord_point(c.curve, c.acceleration, c.share, found) == Verdict::holds);
            const Rational slack = chord_slack(c.acceleration, c.curve.duration);
            RC_ASSERT(squared_deviation(c.curve, c.share) <= slack * slack);
            // The bound is sharp.
            if (c.is_parabola) RC_ASSERT(squared_deviation(c.curve, Rational(1, 2)) == slack * slack);
          });
  t.holds("and as near as its speed allows",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.05, .degenerate_at_most = 0.5}, [] {
            const BoundedCurve c = gen::bounded_curve();
            const Rational speed = speed_of(c.curve);
            RC_ASSERT(first_order_hypotheses(c.curve, speed, c.share) == Verdict::holds);
            RC_CLASSIFY(is_degenerate(c), "degenerate");
            const auto found = steps_near_chord(c.curve, speed, c.share);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(are_chord_steps(c.curve, speed, c.share, found) == Verdict::holds);
            const Rational slack = first_order_slack(speed, c.curve.duration);
            RC_ASSERT(squared_deviation(c.curve, c.share) <= slack * slack);
            const Motion<Rational> motion{Rational(0), speed, c.acceleration};
            RC_ASSERT(chord_slack(motion, c.curve.duration) == std::min(slack, chord_slack(c.acceleration, c.curve.duration)));
          });
  t.holds("velocities and accelerations are the derivatives", {.number_type = "rational", .cases = 300}, [] {
    const BoundedCurve c = gen::bounded_curve();
    using Jet = oracle::Jet<Rational>;
    CubicCurve<Jet, 3> curve;
    for (int i = 0; i < 4; ++i) curve.points[i] = c.curve.points[i].cast<Jet>();
    const auto now = oracle::moment_of<Rational, 3>(curve.at(Jet(c.share, Rational(1) / c.curve.duration, Rational(0))));
    RC_ASSERT(now.value == c.curve.at(c.share));
    const auto ends = c.curve.accelerations();
    const RationalVec<3> bend = between<Rational, 3>(ends[0], ends[1], c.share);
    RC_ASSERT(now.acceleration == bend);
    const auto v = c.curve.velocities();
    const RationalVec<3> early = between<Rational, 3>(v[0], v[1], c.share), late = between<Rational, 3>(v[1], v[2], c.share);
    const RationalVec<3> velocity = between<Rational, 3>(early, late, c.share);
    RC_ASSERT(now.velocity == velocity);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const BoundedCurve c = gen::bounded_curve();
    const Rational acceleration = c.acceleration * *rc::gen::element(Rational(1), Rational(1, 2), Rational(99, 100));
    const std::vector<RationalVec<3>> points(c.curve.points.begin(), c.curve.points.end());
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 3>>& p, const S& duration, const S& acceleration, const S& share) {
          const CubicCurve<S, 3> curve{{p[0], p[1], p[2], p[3]}, duration};
          return point_near_chord<S, 3>(curve, acceleration, share).verdict;
        },
        points, c.curve.duration, acceleration, c.share);
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 3>>& p, const S& duration, const S& speed, const S& share) {
          const CubicCurve<S, 3> curve{{p[0], p[1], p[2], p[3]}, duration};
          return steps_near_chord<S, 3>(curve, speed, share).verdict;
        },
        points, c.curve.duration, acceleration, c.share);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const BoundedCurve c = gen::bounded_curve();
    const Rational speed = speed_of(c.curve), amount = *gen::excess();
    const auto i = static_cast<int>(gen::any_place(3));
    auto point = point_near_chord(c.curve, c.acceleration, c.share);
    if (*rc::gen::arbitrary<bool>() || c.share == 0 || c.share == 1) point.on_chord[i] += amount;
    else point.bend[i] += amount;
    RC_ASSERT(is_chord_point(c.curve, c.acceleration, c.share, point) == Verdict::fails);
    auto steps = steps_near_chord(c.curve, speed, c.share);
    if ((*rc::gen::arbitrary<bool>() && c.share != 0) || c.share == 1) steps.before[i] += amount;
    else steps.after[i] += amount;
    RC_ASSERT(are_chord_steps(c.curve, speed, c.share, steps) == Verdict::fails);
  });
  t.holds("a witness that is right but for a bound is rejected", {.number_type = "rational", .cases = 300}, [] {
    // Where the share is 0 or 1 only the lengths show it.
    const BoundedCurve c = gen::bounded_curve();
    const Rational end = *rc::gen::element(Rational(0), Rational(1)), speed = speed_of(c.curve);
    auto point = point_near_chord(c.curve, c.acceleration, end);
    point.bend = gen::unit_direction() * Rational(c.acceleration + *gen::excess());
    RC_ASSERT(is_chord_point(c.curve, c.acceleration, end, point) == Verdict::fails);
    auto steps = steps_near_chord(c.curve, speed, end);
    (end == 0 ? steps.before : steps.after) = gen::unit_direction() * Rational(speed + *gen::excess());
    RC_ASSERT(are_chord_steps(c.curve, speed, end, steps) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "the bound by the second derivative needs each part of its hypotheses", {.parts = 6, .share = 0.2},
      [] {
        const RationalVec<3> direction = gen::unit_direction();
        Rational start = *gen::positive_rational(), end = start, share = *gen::unit_interval_rational(),
                 duration = *gen::positive_rational();
        const Rational acceleration = start;
        std::string part;
        std::optional<Verdict> none;
        bool asked = true;
        switch (gen::any_place(6)) {
          case 0: part = "the bend at the start", start += *gen::excess(); break;
          case 1: part = "the bend at the end", end += *gen::excess(); break;
          case 2: part = "the share is negative", share = -*gen::excess(); break;
          case 3: part = "the share is more than 1", share = Rational(1) + *gen::excess(); break;
          case 4: part = "the duration is negative", duration = -duration, asked = false; break;
          default: part = "the bound is negative", start = end = Rational(0), asked = false;
        }
        const Curve curve = gen::cubic_between(*gen::rational_vector<3>(), *gen::rational_vector<3>(), direction * start,
                                               direction * end, duration);
        const Rational bound = part == "the bound is negative" ? Rational(-acceleration) : acceleration;
        // Beyond the ends the bound as it is written is that of a share within; a wrong sign of it is not seen in its square.
        const Rational at = share;
        const auto conclusion = at < 0 || at > 1
                                    ? less_equal(squared_deviation(curve, at), sq(chord_slack(acceleration, duration)))
                                    : point_near_chord(curve, acceleration, at).verdict;
        return Weakening{part, chord_hypotheses(curve, bound, at), asked ? std::optional(conclusion) : none};
      },
      600);
  needs_each_part(t, "the bound by the speed needs each part of its hypotheses", {.parts = 3, .share = 0.2}, [] {
    // The curve runs there and back again, and on some part of its way faster than it is said to.
    const RationalVec<3> direction = gen::unit_direction();
    const Rational speed = *gen::positive_rational();
    const std::size_t fast = gen::any_place(3);
    std::string part = "the speed of " + gen::place(fast, 3);
    std::array<Rational, 3> steps{Rational(1), Rational(1), Rational(1)};
    Rational share = *gen::unit_interval_rational();
    steps[fast] += *rc::gen::element(Rational(3), Rational(20));
    Curve curve = straight(direction, steps[0], steps[1], steps[2]);
    curve.duration = Rational(3) / speed;
    // A curve that runs faster on one part than the speed of the others leaves the bound of this speed only if it is far faster.
    auto conclusion = std::optional(steps_near_chord(curve, speed, share).verdict);
    if (fast == 1) conclusion = std::nullopt;
    return Weakening{part, first_order_hypotheses(curve, speed, share), conclusion};
  });
}

void pinned_cases(Suite& t) {
  t.example("a kink is 1 from its chord without bending anywhere else", {.form = "beyond", .hypothesis = "f is differentiable"},
            [] {
              using namespace c1;
              return is_near_chord(kink_start, kink_end, Point(0, 0), Q(0), Q(2), half) == Verdict::fails &&
                     squared_distance(kink, kink_start) == sq(first_order_slack(Q(1), Q(2))) &&
                     is_near_chord_to_first_order(kink_start, kink_end, kink, Q(1), Q(2), half) == Verdict::holds &&
                     is_near_chord_to_first_order(kink_start, kink_end, kink, Q(99, 100), Q(2), half) == Verdict::fails;
            });
  t.example("a jump is as far from its chord as it likes", {.form = "beyond", .hypothesis = "f is continuous"}, [] {
    using namespace c1;
    return is_near_chord_to_first_order(before_jump, after_jump, after_jump, Q(0), Q(1), half) == Verdict::fails;
  });
  t.example("a curve that bends more than the bound deviates from its chord", {.form = "beyond", .hypothesis = "||f''|| <= M"},
            [] {
              using namespace c1;
              return chord_hypotheses(late_bend, Q(1), half) == Verdict::fails &&
                     point_near_chord(late_bend, Q(1), half).verdict == Verdict::fails &&
                     point_near_chord(late_bend, Q(6), half).verdict == Verdict::holds;
            });
  t.example("a curve that runs faster than the bound deviates from its chord", {.form = "beyond", .hypothesis = "||f'|| <= L"},
            [] {
              using namespace c1;
              return first_order_hypotheses(parabola, Q(1, 10), half) == Verdict::fails &&
                     steps_near_chord(parabola, Q(1, 10), half).verdict == Verdict::fails;
            });
  t.example("beyond its ends a parabola leaves the strip about its chord", {.form = "beyond", .hypothesis = "0 <= s <= 1"}, [] {
    using namespace c1;
    const Point at = parabola.at(Q(2)), chord = between<Q, 2>(parabola.points[0], parabola.points[3], Q(2));
    return chord_hypotheses(parabola, parabola_bends, Q(2)) == Verdict::fails &&
           squared_distance<Q, 2>(at, chord) > sq(chord_slack(parabola_bends, Q(1)));
  });
  t.example("a parabola reaches the bound, and the chord of the moments that are looked at misses it", {.form = "beyond"}, [] {
    using namespace c1;
    const Point at = parabola.at(half);
    const auto found = point_near_chord(parabola, parabola_bends, half);
    return found.verdict == Verdict::holds &&
           squared_distance<Q, 2>(at, found.on_chord) == sq(chord_slack(parabola_bends, Q(1))) &&
           point_near_chord(parabola, Q(199, 100), half).verdict == Verdict::fails &&
           is_on_chord_of_moments(parabola.points[0], parabola.points[3], at, half) == Verdict::fails &&
           is_on_chord_of_moments(arc_start, arc_end, arc_middle, half) == Verdict::fails;
  });
}

PROPTEST(c1_chord_bound) {
  curves_are_near_their_chords(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c1_chord_bound
