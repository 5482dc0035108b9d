// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s43_rotated_cap.hpp"

#include "proptests/counterexamples/s43_rotated_cap.hpp"
#include "proptests/gen/cap_angle.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_s43_rotated_cap {
namespace {

using namespace refitlab;
using Vector = Vec<Rational, 3>;

bool is_special(const Rational& cosine) { return cosine == 0 || cosine == 1 || cosine == -1; }

// Returns cosine first + sine second, at an angle from the first direction that is drawn, but at most the given one.
template <int D>
Vec<Rational, D> point_within(const gen::PerpendicularPair<D>& frame, const gen::CapAngle& most) {
  const gen::CapAngle drawn = *gen::cap_angle();
  const gen::CapAngle& angle = drawn.cosine < most.cosine ? most : drawn;
  return frame.first * angle.cosine + frame.second * angle.sine;
}

// Draws a cap of rotations about an apex of any length, and a rotation of the cap.
struct CapOfRotations {
  gen::PerpendicularPair<4> frame = *gen::perpendicular_pair<4>();
  gen::CapAngle angle = *gen::cap_angle();
  Quaternion<Rational> apex = frame.first * *gen::positive_rational();
  Quaternion<Rational> rotation = point_within(frame, angle) * *gen::positive_rational();
};

void hypotheses_need_each_part(Suite& t) {
  needs_part(t, "the rotation is within the angle of the apex", [] {
    CapOfRotations c;
    RC_PRE(c.angle.cosine > Rational(-1));
    const gen::CapAngle beyond = *gen::cap_angle().as("angle beyond");
    RC_PRE(beyond.cosine < c.angle.cosine);
    c.rotation = (c.frame.first * beyond.cosine + c.frame.second * beyond.sine) * *gen::positive_rational();
    const Vector v = *gen::nonzero_vector<3>();
    return Weakening{rotated_cap_hypotheses(c.apex, c.angle.cosine, c.rotation),
                     rotated_cap(c.apex, c.rotation, v, rotated_cap_cosine_repaired(c.angle.cosine)).verdict};
  });
  t.holds("neither the apex nor the rotation of a cap is 0, nor the apex of a filled one", {.number_type = "rational"}, [] {
    const CapOfRotations c;
    const Quaternion<Rational> zero = Quaternion<Rational>::Zero();
    const Vector v = *gen::rational_vector<3>();
    RC_ASSERT(rotated_cap_hypotheses(c.apex, c.angle.cosine, c.rotation) == Verdict::holds);
    RC_ASSERT((within_angle<Rational, 4>(zero, c.rotation, c.angle.cosine) == Verdict::holds));
    RC_ASSERT(rotated_cap_hypotheses(zero, c.angle.cosine, c.rotation) == Verdict::fails);
    RC_ASSERT(rotated_cap_hypotheses(c.apex, c.angle.cosine, zero) == Verdict::fails);
    RC_ASSERT(filled_cap_hypotheses<Rational>(zero, v, v, Rational(-1)) == Verdict::fails);
    // For these the conclusions are empty: 0 takes every vector to every other.
    RC_ASSERT(is_rotated<Rational>(zero, v, *gen::rational_vector<3>()) == Verdict::holds);
    RC_ASSERT(is_rotation_onto<Rational>(c.apex, c.angle.cosine, v, v, zero) == Verdict::fails);
    RC_ASSERT(is_rotation_onto<Rational>(zero, c.angle.cosine, v, v, identity_quaternion<Rational>()) == Verdict::fails);
  });
  needs_part(t, "x is as long as v, not longer and not shorter", [] {
    const CapOfRotations c;
    const Vector v = *gen::nonzero_vector<3>();
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    const Vector turned = rotate_by(c.apex, v);
    const Vector x = *rc::gen::arbitrary<bool>().as("longer") ? Vector(turned * factor) : Vector(turned / factor);
    return Weakening{filled_cap_hypotheses(c.apex, v, x, rotated_cap_cosine_repaired(c.angle.cosine)),
                     rotation_onto(c.apex, c.angle.cosine, v, x).verdict};
  });
  needs_part(t, "x is within the doubled angle", [] {
    const CapOfRotations c;
    const Rational cosine = rotated_cap_cosine_repaired(c.angle.cosine);
    RC_PRE(cosine > Rational(-1));
    const auto frame = *gen::perpendicular_pair<3>();
    const gen::CapAngle beyond = *gen::cap_angle().as("angle beyond");
    RC_PRE(beyond.cosine < cosine);
    const Vector v = rotate_by<Rational>(conjugate(c.apex), frame.first);
    const Vector x = frame.first * beyond.cosine + frame.second * beyond.sine;
    return Weakening{filled_cap_hypotheses(c.apex, v, x, cosine), rotation_onto(c.apex, c.angle.cosine, v, x).verdict};
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.example("an interval does not decide the rotation bound where it is attained", {}, [] {
    const Interval third = lift<Interval>(Rational(1, 3));
    const Quaternion<Interval> q(third, third, third, third);
    return rotation_bound<Interval>(q, q, Vec<Interval, 3>(third, third, third)).verdict == Verdict::undecided;
  });
  t.holds("a slack that is a square but another one, or no square, is rejected", {.number_type = "rational"}, [] {
    const CapOfRotations c;
    const Vector v = *gen::rational_vector<3>();
    const auto good = rotation_bound(c.apex, c.rotation, v);
    auto other = good, no_square = good;
    other.along_axis = *gen::rational().as("another square");
    RC_PRE(sq(other.along_axis) != sq(good.along_axis));
    no_square.along_axis = other.along_axis;
    other.slack = Rational(2) * sq(other.along_axis);
    RC_CLASSIFY(other.slack < good.slack, "too small");
    RC_ASSERT(is_rotation_bound(c.apex, c.rotation, v, other) == Verdict::fails);
    RC_ASSERT(is_rotation_bound(c.apex, c.rotation, v, no_square) == Verdict::fails);
  });
  t.holds("a rotated pair is as close as its scalar product says, and no closer", {.number_type = "rational"}, [] {
    const CapOfRotations c;
    const Vector v = *gen::nonzero_vector<3>();
    const Rational cosine = dot(rotate_by(c.apex, v), rotate_by(c.rotation, v)) / squared_norm(v);
    const Rational amount = *gen::positive_rational().as("amount");
    const auto pair = rotated_cap(c.apex, c.rotation, v, cosine);
    RC_ASSERT(pair.verdict == Verdict::holds);
    RC_ASSERT(is_rotated_pair(c.apex, c.rotation, v, cosine, pair) == Verdict::holds);
    RC_ASSERT(rotated_cap<Rational>(c.apex, c.rotation, v, cosine + amount).verdict == Verdict::fails);
    RC_ASSERT(is_rotated_pair<Rational>(c.apex, c.rotation, v, cosine + amount, pair) == Verdict::fails);
  });
  t.holds("a rotated pair of which one vector is wrong is rejected, though it is close enough", {.number_type = "rational"}, [] {
    const CapOfRotations c;
    const Vector v = *gen::nonzero_vector<3>(), wrong = *gen::nonzero_vector<3>();
    const Vector at_apex = rotate_by(c.apex, v), rotated = rotate_by(c.rotation, v);
    const Rational any = min_of(dot(Vector(at_apex + wrong), rotated), dot(at_apex, Vector(rotated + wrong))) / squared_norm(v);
    RC_ASSERT(is_rotated_pair<Rational>(c.apex, c.rotation, v, any, {Verdict::holds, at_apex + wrong, rotated}) ==
              Verdict::fails);
    RC_ASSERT(is_rotated_pair<Rational>(c.apex, c.rotation, v, any, {Verdict::holds, at_apex, rotated + wrong}) ==
              Verdict::fails);
  });
  t.holds("0 is within every angle of every vector, and every vector of it", {.number_type = "rational"}, [] {
    const Vector a = *gen::rational_vector<3>(), zero = Vector::Zero();
    const auto angle = *gen::cap_angle();
    RC_ASSERT((within_angle<Rational, 3>(a, zero, angle.cosine) == Verdict::holds));
    RC_ASSERT((within_angle<Rational, 3>(zero, a, angle.cosine) == Verdict::holds));
  });
}

void rotations_fill_the_cap_of_the_doubled_angle(Suite& t) {
  t.holds("(R_p v, R_q v) >= ||v||^2 (2 c^2 - 1), and the slack is a square",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1}, [] {
            const Quaternion<Rational> p = *gen::rational_vector<4>(), q = *gen::rational_vector<4>();
            const Vector v = *gen::rational_vector<3>();
            RC_CLASSIFY(dot(p, q) == 0 || squared_norm(v) == 0 || p == q || p == -q, "degenerate");
            const auto bound = rotation_bound(p, q, v);
            RC_ASSERT(bound.verdict == Verdict::holds);
            RC_ASSERT(is_rotation_bound(p, q, v, bound) == Verdict::holds);
          });

  t.refuted("a cap of rotations of any angle takes v into the cap of the doubled angle",
            {.form = "printed", .number_type = "rational"}, [] {
              const CapOfRotations c;
              RC_ASSERT(rotated_cap<Rational>(c.apex, c.rotation, *gen::rational_vector<3>(),
                                              rotated_cap_cosine_printed(c.angle.cosine))
                            .verdict == Verdict::holds);
            });
  t.holds("a cap of rotations takes v into the cap of the doubled angle, or the whole sphere past pi/2",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const CapOfRotations c;
            const Vector v = *gen::rational_vector<3>();
            RC_CLASSIFY(is_special(c.angle.cosine) || squared_norm(v) == 0, "degenerate");
            RC_ASSERT(rotated_cap_hypotheses(c.apex, c.angle.cosine, c.rotation) == Verdict::holds);
            const Rational cosine = rotated_cap_cosine_repaired(c.angle.cosine);
            const auto pair = rotated_cap(c.apex, c.rotation, v, cosine);
            RC_ASSERT(pair.verdict == Verdict::holds);
            RC_ASSERT(is_rotated_pair(c.apex, c.rotation, v, cosine, pair) == Verdict::holds);
          });
  t.holds("the rotated cap is filled: some rotation of the cap takes v to each of its points",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const CapOfRotations c;
            const Rational length = *gen::unit_interval_rational(), cosine = rotated_cap_cosine_repaired(c.angle.cosine);
            const auto frame = *gen::perpendicular_pair<3>();
            // This is the doubled angle, which is pi past pi/2.
            const gen::CapAngle doubled{cosine, c.angle.cosine < 0 ? Rational(0) : 2 * c.angle.cosine * c.angle.sine};
            const Vector v = rotate_by<Rational>(conjugate(c.apex), frame.first * length);
            const Vector x = point_within(frame, doubled) * length;
            RC_CLASSIFY(is_special(c.angle.cosine) || length == 0 || x == -frame.first * length, "degenerate");
            RC_ASSERT(filled_cap_hypotheses(c.apex, v, x, cosine) == Verdict::holds);
            const auto onto = rotation_onto(c.apex, c.angle.cosine, v, x);
            RC_ASSERT(onto.verdict == Verdict::holds);
            RC_ASSERT(is_rotation_onto(c.apex, c.angle.cosine, v, x, onto.rotation) == Verdict::holds);
          });

  t.example("a vector along an axis is taken to its opposite by half a turn", {.form = "repaired", .number_type = "rational"},
            [] {
              const auto identity = identity_quaternion<Rational>();
              for (int i = 0; i < 3; ++i)
                for (const int sign : {1, -1}) {
                  const Vector v = Vector::Unit(i) * Rational(sign), x = -v;
                  if (rotation_onto<Rational>(identity, Rational(0), v, x).verdict != Verdict::holds)
                    return Checked(false, 2 * i);
                }
              return Checked(true, 6);
            });
  t.example("the half turn refutes the printed doubled angle of an angle past pi/2", {.form = "printed"}, [] {
    using namespace s43_cap;
    const Q printed = rotated_cap_cosine_printed(past_right_angle), repaired = rotated_cap_cosine_repaired(past_right_angle);
    return rotated_cap_hypotheses(no_turn, past_right_angle, half_turn_about_x) == Verdict::holds && printed == Q(7, 25) &&
           rotated_cap(no_turn, half_turn_about_x, y, printed).verdict == Verdict::fails && repaired == Q(-1) &&
           rotated_cap(no_turn, half_turn_about_x, y, repaired).verdict == Verdict::holds;
  });

  t.holds("membership in a cap agrees with a comparison of cosines where norms are rational", {.number_type = "rational"}, [] {
    const CapOfRotations c;
    const gen::CapAngle other = *gen::cap_angle();
    const Quaternion<Rational> q = (c.frame.first * other.cosine + c.frame.second * other.sine) * *gen::positive_rational();
    RC_ASSERT((within_angle<Rational, 4>(c.apex, q, c.angle.cosine) == verdict_of(c.angle.cosine <= other.cosine)));
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 400}, [] {
    const CapOfRotations c;
    const Vector v = *gen::rational_vector<3>();
    decide_by_all([]<class S>(const Quaternion<S>& p, const Quaternion<S>& q,
                              const Vec<S, 3>& x) { return rotation_bound<S>(p, q, x).verdict; },
                  c.apex, c.rotation, v);
    decide_by_all(
        []<class S>(const Quaternion<S>& p, const Quaternion<S>& q, const Vec<S, 3>& x, const S& cosine) {
          return rotated_cap_hypotheses<S>(p, cosine, q) & rotated_cap<S>(p, q, x, rotated_cap_cosine_printed(cosine)).verdict;
        },
        c.apex, c.rotation, v, c.angle.cosine);
    decide_by_all([]<class S>(const Quaternion<S>& p, const Quaternion<S>& q, const Vec<S, 3>& x,
                              const S& cosine) { return rotation_onto<S>(p, cosine, x, rotate_by<S>(q, x)).verdict; },
                  c.apex, c.rotation, v, c.angle.cosine);
  });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .cases = 500}, [] {
    const CapOfRotations c;
    const Vector v = *gen::nonzero_vector<3>();
    const Rational bump = *gen::positive_rational(), cosine = rotated_cap_cosine_repaired(c.angle.cosine);
    auto slack = rotation_bound(c.apex, c.rotation, v), axis = slack;
    slack.slack -= bump;
    axis.along_axis += 2 * abs(axis.along_axis) + bump;
    RC_ASSERT(is_rotation_bound(c.apex, c.rotation, v, slack) == Verdict::fails);
    RC_ASSERT(is_rotation_bound(c.apex, c.rotation, v, axis) == Verdict::fails);
    auto turned = rotated_cap(c.apex, c.rotation, v, cosine), apex = turned;
    turned.rotated[*rc::gen::inRange(0, 3)] += bump;
    apex.at_apex[*rc::gen::inRange(0, 3)] -= bump;
    RC_ASSERT(is_rotated_pair(c.apex, c.rotation, v, cosine, turned) == Verdict::fails);
    RC_ASSERT(is_rotated_pair(c.apex, c.rotation, v, cosine, apex) == Verdict::fails);
    // None of these is a witness: a rotation onto another point, the opposite of the rotation in a small cap, and no rotation at
    // all.
    const Vector x = rotate_by(c.rotation, v);
    RC_ASSERT(is_rotation_onto<Rational>(c.apex, c.angle.cosine, v, -x, c.rotation) == Verdict::fails);
    RC_ASSERT(is_rotation_onto<Rational>(c.apex, c.angle.cosine, v, x, c.rotation * Rational(0)) == Verdict::fails);
    if (c.angle.cosine > 0) RC_ASSERT(is_rotation_onto<Rational>(c.apex, c.angle.cosine, v, x, -c.rotation) == Verdict::fails);
  });
}

void pinned_cases(Suite& t) {
  t.example("a rotation outside the cap takes v out of the doubled cap",
            {.form = "repaired", .hypothesis = "the rotation is in the cap"}, [] {
              using namespace s43_cap;
              return rotated_cap_hypotheses(no_turn, before_right_angle, half_turn_about_x) == Verdict::fails &&
                     rotated_cap(no_turn, half_turn_about_x, y, rotated_cap_cosine_repaired(before_right_angle)).verdict ==
                         Verdict::fails;
            });
  t.example("0 is within every angle, and takes y to -y", {.form = "repaired", .hypothesis = "the rotation is not 0"}, [] {
    using namespace s43_cap;
    return rotated_cap_hypotheses(no_turn, before_right_angle, zero) == Verdict::fails &&
           within_angle<Q, 4>(no_turn, zero, before_right_angle) == Verdict::holds &&
           is_rotated<Q>(zero, y, -y) == Verdict::holds &&
           within_angle<Q, 3>(y, -y, rotated_cap_cosine_repaired(before_right_angle)) == Verdict::fails;
  });
  t.example("no rotation takes a vector to a longer one", {.form = "repaired", .hypothesis = "x is as long as v"}, [] {
    using namespace s43_cap;
    return filled_cap_hypotheses(no_turn, y, twice_y, Q(1)) == Verdict::fails &&
           rotation_onto(no_turn, Q(1), y, twice_y).verdict == Verdict::fails;
  });
  t.example("no rotation of the cap takes y to z, a right angle away",
            {.form = "repaired", .hypothesis = "x is within the doubled angle"}, [] {
              using namespace s43_cap;
              return filled_cap_hypotheses(no_turn, y, z, rotated_cap_cosine_repaired(before_right_angle)) == Verdict::fails &&
                     rotation_onto(no_turn, before_right_angle, y, z).verdict == Verdict::fails;
            });
}

PROPTEST(s43_rotated_cap) {
  hypotheses_need_each_part(t);
  checks_need_each_part(t);
  rotations_fill_the_cap_of_the_doubled_angle(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s43_rotated_cap
