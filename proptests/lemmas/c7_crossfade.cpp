// SPDX-License-Identifier: GPL-3.0-or-later
// Tests crossfades of two clips.
#include "lemmas/c7_crossfade.hpp"

#include "lemmas/s43_minkowski_sum.hpp"
#include "proptests/counterexamples/c7_crossfade.hpp"
#include "proptests/gen/chain.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/slerp.hpp"

namespace proptests::suite_c7_crossfade {
namespace {

using namespace refitlab;
using gen::RationalMotion;
using gen::RationalQuaternion;
using gen::RationalVec;
using M = MultiprecisionInterval;

// Draws two rotations that move, on the shorter way to each other.
struct Fade {
  gen::TurningQuaternion first = gen::turning_quaternion(), second = gen::turning_quaternion();
  Rational weight = *gen::unit_interval_rational(), cosine;
  Fade() {
    if (dot(first.moment.value, second.moment.value) < 0) {
      auto& m = second.moment;
      m = {-m.value, -m.velocity, -m.acceleration};
    }
    cosine = dot(first.moment.value, second.moment.value);
  }
  bool is_degenerate() const { return cosine == 0 || cosine == 1 || weight == 0 || weight == 1; }
};

enum class Moving { first, second, weight };

// Returns the slerp of both as one of its three arguments moves, by jets of intervals.
Moment<M, 4> slerp_as(const Fade& f, Moving moving) {
  using J = oracle::Jet<M>;
  const auto jets = [](const Moment<Rational, 4>& m, bool moves) {
    Vec<J, 4> out;
    for (int i = 0; i < 4; ++i)
      out[i] = moves ? J(lift<M>(m.value[i]), lift<M>(m.velocity[i]), lift<M>(m.acceleration[i])) : J(lift<M>(m.value[i]));
    return out;
  };
  return oracle::moment_of<M, 4>(oracle::slerp<J>(jets(f.first.moment, moving == Moving::first),
                                                  jets(f.second.moment, moving == Moving::second),
                                                  J(lift<M>(f.weight), M(moving == Moving::weight ? 1 : 0), M(0))));
}

void nlerps_move_within_the_bounds(Suite& t) {
  t.holds("a nlerp of two moving rotations moves within the bounds, in each of the three parameters",
          {.form = "beyond",
           .number_type = "interval to exact root",
           .cases = 300,
           .degenerate_at_least = 0.1,
           .degenerate_at_most = 0.6},
          [] {
            const Fade f;
            const auto &p = f.first.moment, &q = f.second.moment;
            RC_ASSERT(crossfade_hypotheses(p.value, q.value, f.cosine, f.weight) == Verdict::holds);
            RC_CLASSIFY(f.is_degenerate(), "degenerate");
            const Rational most = std::min(Rational(1), Rational(f.weight + Rational(1, 10))),
                           least = std::max(Rational(0), Rational(f.weight - Rational(1, 10)));
            const Rational left = Rational(1) - least;
            const std::vector<RationalQuaternion> parts{p.value, p.velocity, p.acceleration, q.value, q.velocity, q.acceleration};
            const std::vector<Rational> bounds{f.first.motion.speed,
                                               f.first.motion.acceleration,
                                               f.second.motion.speed,
                                               f.second.motion.acceleration,
                                               left,
                                               most,
                                               f.weight,
                                               f.cosine};
            const Decision d = decide<ExactRoot>(
                []<class S>(const std::vector<Quaternion<S>>& n, const std::vector<S>& b) {
                  const Moment<S, 4> p{n[0], n[1], n[2]}, q{n[3], n[4], n[5]};
                  const Motion<S> of_p{S(1), b[0], b[1]}, of_q{S(1), b[2], b[3]};
                  const S &left = b[4], &most = b[5], &weight = b[6], &cosine = b[7];
                  return nlerp_moves<S>(fading_first<S, 4>(p, q.value, weight), faded_by_time(of_p, of_q.size, left), cosine) &
                         nlerp_moves<S>(fading_second<S, 4>(p.value, q, weight), faded_by_time(of_q, of_p.size, most), cosine) &
                         nlerp_moves<S>(fading_weight<S, 4>(p.value, q.value, weight),
                                        faded_by_weight(S(1), S(1), gap_of_units(cosine)), cosine);
                },
                parts, bounds);
            RC_ASSERT(d.verdict == Verdict::holds);
          });
}

void slerps_move_within_the_bounds(Suite& t) {
  t.holds("a slerp of two moving rotations moves within the bounds, by sines in intervals",
          {.form = "beyond", .number_type = "multiprecision interval", .cases = 400, .degenerate_at_most = 0.6}, [] {
            const Fade f;
            RC_ASSERT(is_shorter_way(f.cosine) == Verdict::holds);
            RC_PRE(f.cosine < 1);
            // As the weight moves it is as slow as the arc is long, but for 1/3 %.
            RC_ASSERT(less(slerp_by_weight(lift<M>(f.cosine)).speed, M(acos(lift<M>(f.cosine)) * M(1003.3) / M(1000))) ==
                      Verdict::holds);
            RC_CLASSIFY(f.is_degenerate(), "degenerate");
            const auto motion = [](const RationalMotion& m) {
              return Motion<M>{M(1), lift<M>(m.speed), lift<M>(m.acceleration)};
            };
            // The cell is one of weights about this one, with a cosine that is known a little less well.
            const Rational around = *rc::gen::element(Rational(0), Rational(1, 50), Rational(1, 3));
            const Rational low = std::max(Rational(0), Rational(f.weight - around)),
                           high = std::min(Rational(1), Rational(f.weight + around));
            const Rational product = low <= Rational(1, 2) && Rational(1, 2) <= high
                                         ? Rational(1, 4)
                                         : std::max(Rational(low * (1 - low)), Rational(high * (1 - high)));
            const M cosine = lift<M>(std::max(Rational(0), Rational(f.cosine - around / 10)));
            for (const auto& [m, bounds] :
                 {std::pair(slerp_as(f, Moving::first),
                            slerp_by_time(motion(f.first.motion), cosine, lift<M>(Rational(1 - low)), lift<M>(product))),
                  std::pair(slerp_as(f, Moving::second),
                            slerp_by_time(motion(f.second.motion), cosine, lift<M>(high), lift<M>(product))),
                  std::pair(slerp_as(f, Moving::weight), slerp_by_weight(lift<M>(f.cosine)))}) {
              RC_ASSERT(is_slerp_moment(m, bounds) != Verdict::fails);
              // Nothing moves at the end that does not move, but for the last digits.
              RC_ASSERT(less_equal(squared_norm(m.velocity), M(sq(bounds.speed) + M(1e-40))) == Verdict::holds);
              RC_ASSERT(less_equal(squared_norm(m.acceleration), M(sq(bounds.acceleration) + M(1e-40))) == Verdict::holds);
            }
          });
}

// Checks slerps in which p or q turns at a speed of 1, out of the plane of both or at an angle to it, and is at a right angle to
// the other one.
Checked check_slerps_across_a_right_angle() {
  using J = oracle::Jet<M>;
  long tried = 0;
  for (const Rational& share : {Rational(1, 1000), Rational(1, 10), Rational(1, 3), Rational(1, 2), Rational(2, 3), Rational(1)})
    for (const auto& [beside, across] : {std::pair(Rational(0), Rational(1)), {Rational(3, 5), Rational(4, 5)}})
      for (const bool is_first : {true, false}) {
        const J zero(M(0)), one(M(1));
        const Vec<J, 4> moving{one, J(M(0), lift<M>(beside), M(0)), J(M(0), lift<M>(across), M(0)), zero},
            held{zero, one, zero, zero};
        const J weight(lift<M>(is_first ? Rational(1 - share) : share));
        const auto moment = oracle::moment_of<M, 4>(oracle::slerp<J>(is_first ? moving : held, is_first ? held : moving, weight));
        const Motion<M> bound =
            slerp_by_time<M>({M(1), M(1), M(1)}, M(0), lift<M>(share), lift<M>(Rational(share * (1 - share))));
        ++tried;
        if (less_equal(squared_norm(moment.velocity), M(sq(bound.speed) + M(1e-40))) != Verdict::holds)
          return Checked(false, tried, "the share " + as_text(share) + " is faster");
        // The bound is a little more: it has pi/2 m at most in place of sin(pi/2 m).
        if (beside == 0 && less(sq(bound.speed), M(squared_norm(moment.velocity) * M(1.35))) != Verdict::holds)
          return Checked(false, tried, "the share " + as_text(share) + " is slower by far");
      }
  return Checked(true, tried);
}

void longer_slerps_move_within_the_bounds(Suite& t) {
  t.example("across a right angle a slerp moves as fast as the sine of its share of it, and the bound is little more",
            {.form = "beyond", .number_type = "multiprecision interval"}, check_slerps_across_a_right_angle);
  t.holds("a slerp that goes a little more than the shorter way moves within the bounds, by sines in intervals",
          {.form = "beyond",
           .number_type = "multiprecision interval",
           .cases = 300,
           .degenerate_at_most = 0.6,
           .tags_at_least = {{"beyond a right angle", 0.2}, {"nearly two thirds of a half turn", 0.01}}},
          [] {
            Fade f;
            if (*rc::gen::arbitrary<bool>() && f.cosine > 0 && 2 * f.cosine <= 1) {
              auto& m = f.second.moment;
              m = {-m.value, -m.velocity, -m.acceleration}, f.cosine = -f.cosine;
            }
            RC_ASSERT(is_hardly_the_longer_way(f.cosine) == Verdict::holds);
            RC_PRE(f.cosine < 1);
            if (f.cosine < 0) RC_TAG("beyond a right angle");
            if (5 * f.cosine < -2) RC_TAG("nearly two thirds of a half turn");
            RC_CLASSIFY(f.is_degenerate(), "degenerate");
            for (const auto& [moving, speed] : {std::pair(Moving::first, slerp_speed_beyond(lift<M>(f.first.motion.speed))),
                                                std::pair(Moving::second, slerp_speed_beyond(lift<M>(f.second.motion.speed))),
                                                std::pair(Moving::weight, slerp_by_weight(lift<M>(f.cosine)).speed)})
              RC_ASSERT(less_equal(squared_norm(slerp_as(f, moving).velocity), M(sq(speed) + M(1e-40))) == Verdict::holds);
          });
  t.example("across an arc of 113 degrees a slerp goes faster than its end, but not as fast as beyond is said",
            {.form = "beyond"}, [] {
              using J = oracle::Jet<M>;
              // p turns out of the plane of both, at a speed of 1.
              const Vec<J, 4> p{J(M(1)), J(M(0)), J(M(0), M(1), M(0)), J(M(0))},
                  q{J(M(-5) / M(13)), J(M(12) / M(13)), J(M(0)), J(M(0))};
              const auto m = oracle::moment_of<M, 4>(oracle::slerp<J>(p, q, J(M(1) / M(5))));
              return less(M(sq(M(1.08))), squared_norm(m.velocity)) == Verdict::holds &&
                     less(squared_norm(m.velocity), M(sq(slerp_speed_beyond(M(1))))) == Verdict::holds;
            });
}

void joints_fade_within_the_bounds(Suite& t) {
  t.holds("translations and scales fade within the bounds",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.02, .degenerate_at_most = 0.6},
          [] {
            const RationalMotion of_x = gen::any_motion(), of_y = gen::any_motion();
            const auto x = gen::moment_within<3>(of_x), y = gen::moment_within<3>(of_y);
            const Rational w = *gen::unit_interval_rational();
            const Rational gap = upper_root(squared_distance(x.value, y.value));
            RC_CLASSIFY(w == 0 || w == 1, "degenerate");
            const auto first = fading_first<Rational, 3>(x, y.value, w), second = fading_second<Rational, 3>(x.value, y, w),
                       third = fading_weight<Rational, 3>(x.value, y.value, w);
            RC_ASSERT(first.value == second.value && first.value == third.value);
            const Rational left = Rational(1) - w;
            RC_ASSERT(moves_within(first, faded_by_time(of_x, of_y.size, left)) == Verdict::holds);
            RC_ASSERT(moves_within(second, faded_by_time(of_y, of_x.size, w)) == Verdict::holds);
            RC_ASSERT(moves_within(third, faded_by_weight(of_x.size, of_y.size, gap)) == Verdict::holds);
            // The motion is computed by jets.
            using Jet = oracle::Jet<Rational>;
            const auto jx = oracle::jets_of(x), jy = oracle::jets_of(y);
            for (int i = 0; i < 3; ++i) {
              const Jet a = (Jet(1) - Jet(w)) * jx[i] + Jet(w) * Jet(y.value[i]),
                        b = (Jet(1) - Jet(w)) * Jet(x.value[i]) + Jet(w) * jy[i],
                        c = (Jet(1) - Jet(w, Rational(1), Rational(0))) * Jet(x.value[i]) +
                            Jet(w, Rational(1), Rational(0)) * Jet(y.value[i]);
              RC_ASSERT(a.first == first.velocity[i] && a.second == first.acceleration[i] && b.first == second.velocity[i] &&
                        b.second == second.acceleration[i] && c.first == third.velocity[i] && c.second == third.acceleration[i]);
            }
          });
  t.holds(
      "a point of a crossfaded joint is near the hull of the eight corners, exactly",
      {.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_most = 0.6}, [] {
        gen::RationalTurn first, second;
        if (dot(first.start, second.start) < 0) second.start = -second.start;
        const std::vector<Rational> sides{*gen::unit_interval_rational() / Rational(4),
                                          *gen::unit_interval_rational() / Rational(4), *gen::unit_interval_rational()};
        const std::vector<Rational> shares{*gen::unit_interval_rational(), *gen::unit_interval_rational(),
                                           *gen::unit_interval_rational()};
        const Rational cosine =
            dot(first.start, second.start) - first.motion().speed * sides[0] - second.motion().speed * sides[1];
        RC_PRE(cosine >= 0);
        RC_CLASSIFY((first.rate == 0 && second.rate == 0) || cosine == 1, "degenerate");
        const RationalVec<3> x = *gen::rational_vector<3>(), here = *gen::rational_vector<3>(),
                             there = *gen::rational_vector<3>();
        const auto f = [&](const Rational& a, const Rational& b, const Rational& w) {
          const RationalQuaternion blend = between<Rational, 4>(first.at(a), second.at(b), w);
          const RationalVec<3> moved = between<Rational, 3>(here, there, w);
          return RationalVec<3>(rotate_by<Rational>(blend, x) + moved);
        };
        // The weight starts at 0.
        const Rational least = gen::lower_root((Rational(1) + cosine) / Rational(2)),
                       gap = upper_root(Rational(2) - Rational(2) * cosine), apart = upper_root(squared_distance(here, there));
        const Rational size = upper_root(std::max(squared_norm(here), squared_norm(there))), length = upper_root(squared_norm(x));
        const auto of_point = [&](const RationalMotion& blend, const RationalMotion& translation) {
          return carried_motion(chain_of<Rational>({translation, normalized_motion(blend, least), at_rest(Rational(1))}),
                                at_rest(length));
        };
        const std::vector<RationalMotion> motions{
            of_point(faded_by_time(first.motion(), Rational(1), Rational(1)), at_rest(size)),
            of_point(faded_by_time(second.motion(), Rational(1), sides[2]), at_rest(size)),
            of_point(faded_by_weight(Rational(1), Rational(1), gap), faded_by_weight(size, size, apart))};
        std::vector<RationalVec<3>> corners;
        for (int k = 0; k < 8; ++k)
          corners.push_back(f(k & 1 ? sides[0] : Rational(0), k & 2 ? sides[1] : Rational(0), k & 4 ? sides[2] : Rational(0)));
        const RationalVec<3> at = f(sides[0] * shares[0], sides[1] * shares[1], sides[2] * shares[2]);
        const Rational slack = box_slack<Rational>(motions, sides);
        RC_ASSERT(squared_distance(at, BentPatch<Rational>::interpolated(corners, shares)) <= slack * slack);
      });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const Fade f;
    decide_by_all<ExactRoot>(
        []<class S>(const Quaternion<S>& p, const Quaternion<S>& q, const S& cosine, const S& weight) {
          return nlerp_moves<S>(fading_weight<S, 4>(p, q, weight), faded_by_weight(S(1), S(1), gap_of_units(cosine)), cosine);
        },
        f.first.moment.value, f.second.moment.value,
        Rational((f.cosine + *rc::gen::element(f.cosine, Rational(1))) / Rational(2)), f.weight);
  });
  t.holds("mutated moments of a slerp are rejected, and those beyond the bounds", {.number_type = "rational", .cases = 300}, [] {
    const auto turn = gen::turning_quaternion();
    RC_ASSERT(is_slerp_moment(turn.moment, turn.motion) == Verdict::holds);
    auto moment = turn.moment;
    const Rational amount = *gen::excess();
    // The change is along the quaternion, where it may not move.
    switch (gen::any_place(4)) {
      case 0: moment.value += turn.moment.value * amount; break;
      case 1: moment.velocity += turn.moment.value * amount; break;
      case 2: moment.acceleration += turn.moment.value * amount; break;
      // It has the acceleration that this speed would need.
      default:
        moment.velocity += turn.moment.value * amount;
        moment.acceleration += turn.moment.value * Rational(squared_norm(turn.moment.velocity) - squared_norm(moment.velocity));
    }
    const RationalMotion wide{Rational(1000), turn.motion.speed + Rational(1000), turn.motion.acceleration + Rational(1000000)};
    RC_ASSERT(is_slerp_moment(moment, wide) == Verdict::fails);
    const RationalMotion slow{Rational(1), turn.motion.speed * Rational(1, 2), turn.motion.acceleration};
    RC_ASSERT(is_slerp_moment(turn.moment, slow) == verdict_of(turn.motion.speed == 0));
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "a crossfade needs each part of the hypotheses", {.parts = 6, .share = 0.2},
      [] {
        const RationalQuaternion p = *gen::unit_quaternion();
        RationalQuaternion first = p, second = *gen::unit_quaternion();
        Rational cosine = dot(first, second), weight(1, 2);
        RC_PRE(cosine > Rational(-1) && cosine < Rational(1));
        const Rational amount = *rc::gen::element(Rational(1, 10), Rational(1, 1000000));
        std::string part;
        bool asked = true;
        switch (gen::any_place(6)) {
          case 0: part = "the first is no unit", first *= Rational(1) - amount; break;
          case 1: part = "the second is no unit", second *= Rational(1) - amount; break;
          case 2: part = "the cosine is greater than theirs", cosine += std::min(amount, Rational(Rational(1) - cosine)); break;
          case 3: part = "the weight is negative", weight = -amount, asked = false; break;
          case 4: part = "the weight is more than 1", weight = Rational(1) + amount, asked = false; break;
          default: part = "the cosine is not more than -1", cosine = Rational(-1), asked = false;
        }
        if (asked && part != "the cosine is greater than theirs") cosine = std::min(cosine, dot(first, second));
        return Weakening{
            part, crossfade_hypotheses(first, second, cosine, weight),
            asked ? std::optional(is_long_blend<Rational>(between<Rational, 4>(first, second, weight), cosine)) : std::nullopt};
      },
      400);
}

void pinned_cases(Suite& t) {
  t.example("between the clips a hand leaves the box of both, and not the bounds", {.form = "beyond"}, [] {
    using namespace c7;
    const Quaternion<Q> blend = between<Q, 4>(right, left, half);
    const Point middle = rotate_by<Q>(blend, hand);
    // As w moves, the point moves at 2 * (6/5) / (4/5) and bends by 2 (37/32 + 1) (3/2)^2 at most.
    const refitlab::Motion<Q> turn = normalized_motion<Q>({1, Q(6, 5), 0}, Q(4, 5));
    const refitlab::Motion<Q> point = carried_motion(chain_of<Q>({{0, 0, 0}, turn, {1, 0, 0}}), {1, 0, 0});
    return middle == Point(1, 0, 0) &&
           stays_in_slab_of_clips(of_both, of_both, hand, rotate_by<Q>(right, hand)) == Verdict::holds &&
           stays_in_slab_of_clips(of_both, of_both, hand, middle) == Verdict::fails && point.speed == 3 &&
           in_slab(interval_slab(of_both, of_both, chord_slack(point.acceleration, Q(1)), Q(1)), hand, middle) == Verdict::holds;
  });
  t.example("by the other sign the joint goes the long way: the bounds of the shorter one are no bounds",
            {.form = "beyond", .hypothesis = "(p, q) >= c"}, [] {
              using namespace c7;
              const Quaternion<Q> blend = between<Q, 4>(right, left_other_sign, half);
              return crossfade_hypotheses(right, left, cosine, half) == Verdict::holds &&
                     crossfade_hypotheses(right, left_other_sign, cosine, half) == Verdict::fails &&
                     is_long_blend(blend, cosine) == Verdict::fails && rotate_by<Q>(blend, hand) == Point(-1, 0, 0);
            });
  t.example("opposite rotations have no blend at halves", {.form = "beyond", .hypothesis = "c > -1"}, [] {
    using namespace c7;
    return crossfade_hypotheses(one, opposite, Q(-1), half) == Verdict::fails &&
           squared_norm(between<Q, 4>(one, opposite, half)) == 0;
  });
  t.example("beyond its clips a fade is faster than said", {.form = "beyond", .hypothesis = "0 <= w <= 1"}, [] {
    using namespace c7;
    const refitlab::Moment<Q, 3> moving{hand, hand, hand};
    return crossfade_hypotheses(right, left, cosine, Q(-1)) == Verdict::fails &&
           moves_within(fading_first<Q, 3>(moving, hand, Q(-1)), faded_by_time<Q>({1, 1, 1}, 1, 1)) == Verdict::fails;
  });
  t.example("the ways end at their cosines, 0 and -1/2, and no sooner", {.form = "beyond", .number_type = "rational"}, [] {
    using namespace c7;
    const Q less_than_nothing(-1, 1000000);
    return is_shorter_way(Q(0)) == Verdict::holds && is_shorter_way(less_than_nothing) == Verdict::fails &&
           is_hardly_the_longer_way(Q(-half)) == Verdict::holds &&
           is_hardly_the_longer_way(Q(less_than_nothing - half)) == Verdict::fails;
  });
  t.example("by the shorter way a slerp is no faster than the end that moves", {.form = "beyond", .number_type = "double"}, [] {
    return slerp_by_time<double>({1, 3, 1}, 0, 1, 0).speed == 3 && slerp_by_time<double>({1, 3, 1}, 0.5, 0.25, 0.1875).speed < 1;
  });
  t.example("a slerp of rotations more than a right angle apart may move faster than its ends",
            {.form = "beyond", .hypothesis = "c >= 0"}, [] {
              // The ends are nearly opposite: if one moves across the arc, the middle moves far faster than it.
              using J = oracle::Jet<M>;
              const M cosine = lift<M>(Rational(-99, 101)), sine = lift<M>(Rational(20, 101));
              const Quaternion<J> a(J(1), J(0), J(0), J(M(0), M(1), M(0))), b(J(cosine), J(sine), J(0), J(0));
              const auto m = oracle::moment_of<M, 4>(oracle::slerp<J>(a, b, J(M(1) / M(2))));
              return less(M(4), squared_norm(m.velocity)) == Verdict::holds && is_shorter_way(cosine) == Verdict::fails &&
                     is_slerp_moment(m, slerp_by_time<M>({M(1), M(1), M(1)}, M(0), M(M(1) / M(2)), M(M(1) / M(4)))) ==
                         Verdict::fails;
            });
}

PROPTEST(c7_crossfade) {
  nlerps_move_within_the_bounds(t);
  slerps_move_within_the_bounds(t);
  longer_slerps_move_within_the_bounds(t);
  joints_fade_within_the_bounds(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c7_crossfade
