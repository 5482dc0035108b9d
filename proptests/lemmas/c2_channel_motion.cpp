// SPDX-License-Identifier: GPL-3.0-or-later
// Tests channels of clips between two keys.
#include "lemmas/c2_channel_motion.hpp"

#include "proptests/counterexamples/c2_channel_motion.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/slerp.hpp"

namespace proptests::suite_c2_channel_motion {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using M = MultiprecisionInterval;

// Draws two keys and their tangents. Equal keys, and tangents of 0, come up often enough.
struct Keys {
  RationalVec<3> from = *gen::rational_vector<3>(), to = *gen::rational_vector<3>(), out = *gen::rational_vector<3>(),
                 into = *gen::rational_vector<3>();
  Rational duration = *gen::positive_rational(), share = *gen::unit_interval_rational();
  Keys() {
    if (*rc::gen::inRange(0, 8) == 0) to = from;
    if (*rc::gen::inRange(0, 8) == 0) out = into = RationalVec<3>::Zero();
  }
  bool is_degenerate() const { return to == from || share == 0 || share == 1; }
};

// Draws quaternions of length 1, n steps of one turn apart.
struct Arc {
  RationalQuaternion from, step, to;
  int steps, passed;
  Arc() : from(*gen::unit_quaternion()), steps(*rc::gen::inRange(2, 8)), passed(*rc::gen::inRange(0, steps + 1)) {
    // n turns by the angle of (n, 1) are less than half a turn in R^4.
    const RationalVec<3> v = *gen::rational_vector<3>() / Rational(100 * steps);
    const Rational s = squared_norm(v), scale = Rational(1) / (Rational(1) + s);
    step = {(Rational(1) - s) * scale, Rational(2) * v[0] * scale, Rational(2) * v[1] * scale, Rational(2) * v[2] * scale};
    to = from;
    for (int i = 0; i < steps; ++i) to = multiply<Rational>(step, to);
  }
  RationalQuaternion at() const {
    RationalQuaternion q = from;
    for (int i = 0; i < passed; ++i) q = multiply<Rational>(step, q);
    return q;
  }
  bool is_degenerate() const { return to == from || passed == 0 || passed == steps; }
};

void splines_and_linear_channels_are_within_their_bounds(Suite& t) {
  t.holds("a cubic spline is within its bounds, and its moment is what Taylor's polynomial says",
          {.form = "beyond",
           .number_type = "exact root to interval",
           .cases = 400,
           .degenerate_at_least = 0.1,
           .degenerate_at_most = 0.6},
          [] {
            const Keys k;
            RC_ASSERT(channel_hypotheses(k.duration, k.share) == Verdict::holds);
            RC_CLASSIFY(k.is_degenerate(), "degenerate");
            const auto curve = spline_curve<Rational, 3>(k.from, k.out, k.into, k.to, k.duration);
            RC_ASSERT(curve.points[0] == k.from && curve.points[3] == k.to);
            const auto v = curve.velocities();
            RC_ASSERT(v[0] == k.out && v[2] == k.into);
            const Moment<Rational, 3> moment = spline_moves<Rational, 3>(curve, k.share, by_greatest_factor).moment;
            RC_ASSERT(is_moment_of(curve, k.share, moment) == Verdict::holds);
            RC_ASSERT((spline_moves<Rational, 3>(curve, k.share, by_greatest_factor).verdict) == Verdict::holds);
            const auto decided = decide_by_all<ExactRoot>(
                []<class S>(const Vec<S, 3>& a, const Vec<S, 3>& out, const Vec<S, 3>& into, const Vec<S, 3>& b,
                            const S& duration, const S& share) {
                  return spline_moves<S, 3>(spline_curve<S, 3>(a, out, into, b, duration), share, by_length).verdict;
                },
                k.from, k.out, k.into, k.to, k.duration, k.share);
            RC_ASSERT(decided == Verdict::holds);
          });
  t.holds("a linear channel is within its bounds, and reaches them at a key",
          {.form = "beyond",
           .number_type = "exact root to interval",
           .cases = 300,
           .degenerate_at_least = 0.1,
           .degenerate_at_most = 0.6},
          [] {
            const Keys k;
            RC_CLASSIFY(k.is_degenerate(), "degenerate");
            const auto found = line_moves<Rational, 3>(k.from, k.to, k.duration, k.share, by_greatest_factor);
            RC_ASSERT(found.verdict == Verdict::holds);
            const auto line = gen::cubic_between(k.from, k.to, RationalVec<3>::Zero(), RationalVec<3>::Zero(), k.duration);
            RC_ASSERT(is_moment_of(line, k.share, found.moment) == Verdict::holds);
            const auto bounds = linear_motion<Rational, 3>(k.from, k.to, k.duration, by_greatest_factor);
            RC_ASSERT(bounds.size == std::max(by_greatest_factor(k.from), by_greatest_factor(k.to)));
            RC_ASSERT(bounds.speed * k.duration == by_greatest_factor(RationalVec<3>(k.to - k.from)));
            RC_ASSERT(decide_by_all<ExactRoot>(
                          []<class S>(const Vec<S, 3>& a, const Vec<S, 3>& b, const S& duration, const S& share) {
                            return line_moves<S, 3>(a, b, duration, share, by_length).verdict;
                          },
                          k.from, k.to, k.duration, k.share) == Verdict::holds);
          });
  t.holds("a factor of a scale stretches a vector by no more than the greatest", {.number_type = "rational", .cases = 300}, [] {
    const RationalVec<3> scale = *gen::rational_vector<3>(), x = *gen::rational_vector<3>();
    const RationalVec<3> stretched = scale.cwiseProduct(x);
    const Rational factor = by_greatest_factor(scale);
    RC_ASSERT(squared_norm(stretched) <= factor * factor * squared_norm(x));
    RC_ASSERT(factor >= 0 && (factor == scale[0] || factor == -scale[0] || factor == scale[1] || factor == -scale[1] ||
                              factor == scale[2] || factor == -scale[2]));
  });
}

void arcs_are_as_long_as_said(Suite& t) {
  t.holds("the angle between unit quaternions is at most the bound, which is 1/3 % too great on the shorter way",
          {.form = "beyond",
           .number_type = "multiprecision interval",
           .cases = 400,
           .degenerate_at_least = 0.02,
           .degenerate_at_most = 0.5},
          [] {
            const RationalQuaternion from = *gen::unit_quaternion(), to = *gen::unit_quaternion();
            const Rational cosine = dot(from, to);
            RC_PRE(cosine != Rational(-1));
            RC_ASSERT(has_an_arc(from, to) == Verdict::holds);
            RC_CLASSIFY(abs(cosine) == 1 || cosine == 0, "degenerate");
            const M bound = angle_at_most(lift<M>(from), lift<M>(to));
            if (cosine == 1) {
              RC_ASSERT(less_equal(M(0), bound) == Verdict::holds || to == from);
              return;
            }
            const M angle = acos(lift<M>(cosine));
            RC_ASSERT(less(angle, bound) == Verdict::holds);
            if (cosine >= 0) RC_ASSERT(less(bound, M(angle * M(1003.3) / M(1000))) == Verdict::holds);
          });
  t.holds("the shorter way is at most a right angle", {.number_type = "rational", .cases = 300}, [] {
    const RationalQuaternion from = *gen::unit_quaternion(), to = *gen::unit_quaternion();
    const RationalQuaternion way = by_shorter_way(from, to);
    RC_ASSERT(dot(from, way) >= 0);
    RC_ASSERT(way == to || way == RationalQuaternion(-to));
    RC_ASSERT(dot(from, to) != 0 || way == to);
  });
}

void slerps_are_within_their_bounds(Suite& t) {
  t.holds("a slerp is within its bounds: its derivatives, by sines in intervals",
          {.form = "beyond", .number_type = "multiprecision interval", .cases = 300, .degenerate_at_most = 0.6}, [] {
            const RationalQuaternion from = *gen::unit_quaternion(), to = by_shorter_way<Rational>(from, *gen::unit_quaternion());
            const Rational duration = *gen::positive_rational(), share = *gen::unit_interval_rational();
            RC_CLASSIFY(to == from || share == 0 || share == 1, "degenerate");
            const auto bounds = slerp_motion<M>(lift<M>(from), lift<M>(to), lift<M>(duration));
            // There is no arc, and the channel is at rest.
            if (to == from) {
              RC_ASSERT(less_equal(bounds.speed, M(1e-50)) == Verdict::holds);
              return;
            }
            using J = oracle::Jet<M>;
            const Quaternion<J> a = lift<M>(from).cast<J>(), b = lift<M>(to).cast<J>();
            const auto now =
                oracle::moment_of<M, 4>(oracle::slerp<J>(a, b, J(lift<M>(share), M(M(1) / lift<M>(duration)), M(0))));
            RC_ASSERT(less_equal(squared_norm(now.value), sq(bounds.size)) != Verdict::fails);
            RC_ASSERT(less_equal(squared_norm(now.velocity), sq(bounds.speed)) == Verdict::holds);
            RC_ASSERT(less_equal(squared_norm(now.acceleration), sq(bounds.acceleration)) == Verdict::holds);
            // The channel moves as said, by the great circle that it is on.
            const M speed = acos(lift<M>(Rational(dot(from, to)))) / lift<M>(duration);
            const Quaternion<M> across = now.velocity / speed;
            RC_ASSERT(slerp_moves<M>(now.value, across, speed, bounds).verdict != Verdict::fails);
            const auto said = slerp_moves<M>(now.value, across, speed, bounds).moment;
            for (int i = 0; i < 4; ++i) RC_ASSERT(equal(said.acceleration[i], now.acceleration[i]) != Verdict::fails);
          });
  t.holds("and, exactly, where it is after some of the equal steps that it consists of",
          {.form = "beyond",
           .number_type = "interval to exact root",
           .cases = 300,
           .degenerate_at_least = 0.1,
           .degenerate_at_most = 0.8},
          [] {
            const Arc arc;
            RC_CLASSIFY(arc.is_degenerate(), "degenerate");
            RC_ASSERT(has_an_arc(arc.from, arc.to) == Verdict::holds);
            const Decision decided = decide<ExactRoot>(
                []<class S>(const Quaternion<S>& from, const Quaternion<S>& to, const Quaternion<S>& at, const S& share) {
                  const Motion<S> bounds = slerp_motion<S>(from, to, S(2));
                  return is_near_chord<S, 4>(from, to, at, bounds.acceleration, S(2), share) &
                         is_near_chord_to_first_order<S, 4>(from, to, at, bounds.speed, S(2), share);
                },
                arc.from, arc.to, arc.at(), Rational(arc.passed, arc.steps));
            RC_ASSERT(decided.verdict == Verdict::holds);
          });
  t.holds("a moment within great-circle bounds is that of its speed, exactly",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const RationalQuaternion q = *gen::unit_quaternion();
            const RationalVec<3> axis = gen::unit_direction();
            const RationalQuaternion across = multiply<Rational>(RationalQuaternion(Rational(0), axis[0], axis[1], axis[2]), q);
            const Rational speed = *gen::positive_rational(), more = Rational(speed + *gen::excess()),
                           less = Rational(speed * Rational(999, 1000));
            const auto found = slerp_moves<Rational>(q, across, speed, circle_motion(speed));
            RC_ASSERT(found.verdict == Verdict::holds);
            const auto expected = gen::turning_moment(q, axis * speed, RationalVec<3>::Zero());
            RC_ASSERT(found.moment.velocity == expected.velocity && found.moment.acceleration == expected.acceleration);
            RC_ASSERT(slerp_moves<Rational>(q, across, speed, circle_motion(more)).verdict == Verdict::holds);
            RC_ASSERT(slerp_moves<Rational>(q, across, speed, circle_motion(less)).verdict == Verdict::fails);
            auto slow_bend = circle_motion(speed);
            slow_bend.acceleration = less * less;
            RC_ASSERT(slerp_moves<Rational>(q, across, speed, slow_bend).verdict == Verdict::fails);
          });
}

void moments_and_hypotheses_need_each_part(Suite& t) {
  t.holds("mutated moments are rejected", {.number_type = "rational", .cases = 400}, [] {
    const Keys k;
    const auto curve = spline_curve<Rational, 3>(k.from, k.out, k.into, k.to, k.duration);
    auto moment = spline_moves<Rational, 3>(curve, k.share, by_greatest_factor).moment;
    const auto i = static_cast<int>(gen::any_place(3));
    const Rational amount = *gen::excess();
    switch (gen::any_place(3)) {
      case 0: moment.value[i] += amount; break;
      case 1: moment.velocity[i] += amount; break;
      default: moment.acceleration[i] += amount;
    }
    RC_ASSERT(is_moment_of(curve, k.share, moment) == Verdict::fails);
  });
  needs_each_part(t, "an arc needs unit quaternions that are not opposite", {.parts = 3, .share = 0}, [] {
    RationalQuaternion from = *gen::unit_quaternion(), to = *gen::unit_quaternion();
    switch (gen::any_place(3)) {
      case 0: return Weakening{"the first is no unit", has_an_arc<Rational>(from * Rational(1001, 1000), to), {}};
      case 1: return Weakening{"the last is no unit", has_an_arc<Rational>(from, to * Rational(999, 1000)), {}};
      default: return Weakening{"they are opposite", has_an_arc<Rational>(from, -from), {}};
    }
  });
  needs_each_part(t, "a spline needs a time between its keys, and a share of it", {.parts = 2, .share = 0.2}, [] {
    // The channel rises from 0 to 1 and on. Beyond the keys it is longer, and faster, than the bounds say.
    Rational share = *gen::unit_interval_rational(), duration = *gen::positive_rational();
    std::string part;
    const bool before = *rc::gen::arbitrary<bool>();
    if (before) part = "the share is negative", share = -*gen::excess();
    else part = "the share is more than 1", share = Rational(1) + *gen::excess();
    const Rational end(before ? 0 : 1);
    const RationalVec<3> key = gen::unit_direction();
    const RationalVec<3> from = key * Rational(Rational(1) - end), to = key * end;
    const auto found = line_moves<Rational, 3>(from, to, duration, share, by_greatest_factor);
    return Weakening{part, channel_hypotheses(duration, share), found.verdict};
  });
}

void pinned_cases(Suite& t) {
  t.example("no time passes between keys that are at once", {.form = "beyond"}, [] {
    return channel_hypotheses(c2::Q(0), c2::Q(0)) == Verdict::fails && channel_hypotheses(c2::Q(-1), c2::Q(0)) == Verdict::fails;
  });
  t.example("a step between two keys is at rest", {.form = "beyond"}, [] {
    const auto bounds = at_rest(c2::Q(3));
    return bounds.size == 3 && bounds.speed == 0 && bounds.acceleration == 0 && is_motion(bounds) == Verdict::holds &&
           is_motion(Motion<c2::Q>{0, 0, -1}) == Verdict::fails && is_motion(Motion<c2::Q>{0, -1, 0}) == Verdict::fails &&
           is_motion(Motion<c2::Q>{-1, 0, 0}) == Verdict::fails;
  });
  t.example("a spline of scales goes above all of its keys, which the keys alone do not tell", {.form = "beyond"}, [] {
    using namespace c2;
    const auto curve = spline_curve<Q, 3>(one, up, down, one, Q(1));
    return by_greatest_factor(curve.at(Q(1, 2))) == Q(3, 2) && cubic_motion<Q, 3>(curve, by_greatest_factor).size == Q(5, 3) &&
           by_greatest_factor(one) == 1;
  });
  t.example("an engine that takes the long way turns by more than the bound of the shorter one",
            {.form = "beyond", .hypothesis = "the channel takes the shorter way"}, [] {
              using namespace c2;
              using D = Quaternion<double>;
              const D a = lift<double>(start), b = lift<double>(end), c = lift<double>(other_sign);
              const double angle = 2 * std::atan2(0.6, 0.8), bound = angle_at_most(a, b), way_round = angle_at_most(a, c);
              return bound > angle && bound < 1.0033 * angle && bound < 3.14159 - angle && way_round > 3.14159 - angle &&
                     by_shorter_way(start, other_sign) == end;
            });
}

PROPTEST(c2_channel_motion) {
  splines_and_linear_channels_are_within_their_bounds(t);
  arcs_are_as_long_as_said(t);
  slerps_are_within_their_bounds(t);
  moments_and_hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_c2_channel_motion
