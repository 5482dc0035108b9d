// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b5_rotation_axis.hpp"

#include "proptests/counterexamples/b5_rotation_axis.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_b5_rotation_axis {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Span = std::span<const Rational>;

// Draws up to four weight vertices that turn about one axis, a cap about the sum of them (or about one) where there is one, and
// weights.
struct Twist {
  RationalVec<3> axis = *gen::nonzero_vector<3>();
  CapFallback<Rational> cap;
  RationalVec<3> x = *gen::rational_vector<3>();
  std::vector<Rational> weights;

  Twist() {
    const int m = *rc::gen::inRange(1, 5);
    for (int k = 0; k < m; ++k) cap.rotations.push_back(about_axis());
    cap.center_images.assign(m, RationalVec<3>::Zero());
    cap.axis = *rc::gen::arbitrary<bool>() ? cap.rotations[0] : Quaternion<Rational>(0, 0, 0, 0);
    if (squared_norm(cap.axis) == 0)
      for (const auto& q : cap.rotations) cap.axis += q;
    bool available = squared_norm(cap.axis) > 0;
    for (const auto& q : cap.rotations) available = available && squared_norm(q) > 0 && dot(q, cap.axis) >= 0;
    cap.squared_cosine = available ? squared_cap_cosine<Rational>(cap.rotations, cap.axis) : Rational(0);
    weights = *gen::convex_weights(m);
    if (*rc::gen::inRange(0, 5) == 0) x = axis * *gen::rational();
  }
  Quaternion<Rational> about_axis() const {
    const Rational s = *gen::rational(), t = *gen::rational();
    return {s, axis[0] * t, axis[1] * t, axis[2] * t};
  }
  bool applies() const { return twist_hypotheses<Rational>(axis, cap, weights) == Verdict::holds; }
  bool is_degenerate() const {
    return cap.rotations.size() == 1 || squared_norm<Rational, 3>(cross<Rational>(x, axis)) == 0 || dot(x, axis) == 0;
  }
};

// Draws three weight vertices in a cap of kappa^2 > 1/2, drawn together until they are in it, and a point that is not on the
// axis.
struct NarrowTwist : Twist {
  NarrowTwist() {
    cap.axis = about_axis();
    RC_PRE(squared_norm(cap.axis) > 0 && cross<Rational>(x, axis) != RationalVec<3>::Zero());
    cap.rotations = {about_axis(), about_axis(), about_axis()};
    cap.center_images.assign(3, RationalVec<3>::Zero());
    const auto is_near = [&](const Quaternion<Rational>& q) {
      return dot(q, cap.axis) > 0 && 2 * sq(dot(q, cap.axis)) > squared_norm(q) * squared_norm(cap.axis);
    };
    for (auto& q : cap.rotations)
      while (!is_near(q)) q = (q + cap.axis) / Rational(2);
    cap.squared_cosine = squared_cap_cosine<Rational>(cap.rotations, cap.axis);
    weights = *gen::convex_weights(3);
  }
};

void twists_keep_the_part_along_the_axis(Suite& t) {
  t.holds("on a twist a point keeps its part along the axis, and its ball has the radius of the part across",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2, .degenerate_at_most = 0.8}, [] {
            const Twist w;
            RC_PRE(w.applies());
            RC_CLASSIFY(w.is_degenerate(), "degenerate");
            const auto found = twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_twisted_point<Rational>(w.axis, w.cap, w.x, w.weights, found) == Verdict::holds);
            // The ball is smaller than the paper's by ||p||^2 / ||x||^2, squared.
            const auto tight = twist_ball(w.cap, found.parts), loose = fallback_ball(w.cap, w.x);
            RC_ASSERT(tight.squared_radius * squared_norm(w.x) == loose.squared_radius * squared_norm(found.parts.across));
          });
  t.holds("so do the control points",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1, .degenerate_at_most = 0.8}, [] {
            const Twist w;
            const auto p = w.about_axis(), q = w.about_axis();
            RC_CLASSIFY(w.is_degenerate() || p == q, "degenerate");
            RC_ASSERT(turns_about(w.axis, p) == Verdict::holds);
            RC_ASSERT(control_points_keep_axis(w.axis, p, q, w.x) == Verdict::holds);
            const RationalVec<3> on_axis = w.axis * *gen::rational();
            const RationalVec<3> control = mix_rotations<Rational>(p, q, on_axis).numerator, expected = on_axis * dot(p, q);
            RC_ASSERT(control == expected);
          });
  t.example("a point of the axis rests, and the paper's ball for it has the radius 24/25", {.form = "beyond"}, [] {
    const Span u(b5::halves);
    const auto found = twist_keeps_axis(b5::x_axis, b5::twist, b5::x_axis, u);
    return found.verdict == Verdict::holds && found.rotated == b5::x_axis &&
           twist_ball(b5::twist, found.parts).squared_radius == 0 &&
           fallback_ball(b5::twist, b5::x_axis).squared_radius == b5::Q(576, 625);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const Twist w;
    RC_PRE(squared_norm(combine<Rational, 4>(Span(w.weights), w.cap.rotations)) > 0 && squared_norm(w.cap.axis) > 0);
    const auto other_axis = *gen::nonzero_vector<3>();
    for (const auto& n : {w.axis, other_axis})
      decide_by_all(
          []<class S>(const Vec<S, 3>& n, const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r,
                      const Quaternion<S>& c, const S& squared_cosine, const Vec<S, 3>& x, const std::vector<S>& u) {
            return twist_keeps_axis<S>(n, {q, r, c, squared_cosine}, x, u).verdict;
          },
          n, w.cap.rotations, w.cap.center_images, w.cap.axis, w.cap.squared_cosine, w.x, w.weights);
  });

  t.holds("mutated parts or a mutated image are rejected", {.number_type = "rational", .cases = 400}, [] {
    const Twist w;
    RC_PRE(w.applies());
    const auto good = twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights);
    const auto rejected = [&](const TwistedPoint<Rational>& p) {
      return is_twisted_point<Rational>(w.axis, w.cap, w.x, w.weights, p) == Verdict::fails;
    };
    const RationalVec<3> bump = *gen::nonzero_vector<3>();
    auto split = good, sum = good, image = good;
    split.parts.along += bump, split.parts.across -= bump;  // This is consistent, but not along and across.
    sum.parts.across += bump;
    image.rotated += bump;
    RC_ASSERT(rejected(split) && rejected(sum) && rejected(image));
  });
}

void hypotheses_need_each_part(Suite& t) {
  t.holds("an axis is refused if it is 0, or if a quaternion turns about another in one coordinate",
          {.number_type = "rational", .cases = 100}, [] {
            const Rational s = *gen::rational(), length = *gen::excess(), off = *gen::excess();
            RC_ASSERT(turns_about<Rational>(RationalVec<3>(0, 0, 0), Quaternion<Rational>(1, 0, 0, 0)) == Verdict::fails);
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j) {
                if (i == j) continue;
                RationalVec<3> axis(0, 0, 0);
                axis[i] = length;
                Quaternion<Rational> q(s, 0, 0, 0);
                q[1 + i] = *gen::rational();
                RC_ASSERT(turns_about(axis, q) == Verdict::holds);
                q[1 + j] = off;  // the cross product differs from 0 in the third coordinate alone
                RC_ASSERT(turns_about(axis, q) == Verdict::fails);
              }
          });
  needs_each_part(
      t, "each part of the hypotheses is looked at by itself", {.parts = 9, .share = 0.1},
      [] {
        Twist w;
        while (w.cap.rotations.size() < 3) {
          w.cap.rotations.push_back(w.about_axis());
          w.cap.center_images.push_back(RationalVec<3>(0, 0, 0));
        }
        const std::size_t m = w.cap.rotations.size(), k = gen::any_place(m);
        w.weights = *gen::convex_weights(static_cast<int>(m));
        w.cap.squared_cosine = 0;  // Nothing is claimed of the angle.
        const auto other = *gen::nonzero_quaternion();
        RC_PRE(turns_about(w.axis, other) == Verdict::fails);
        std::string part;
        const std::size_t kind = gen::any_place(4);
        bool is_needed = true;
        if (kind < 2) {
          part = gen::place(k, m) + " turns about another axis";
          w.cap.rotations[k] = other;
        } else if (kind == 2) {
          part = "the cap's axis turns about another axis";
          w.cap.axis = other;
          is_needed = false;  // There is no cap.
        } else {
          const auto broken = gen::broken_weights(w.weights);
          part = broken.part;
          w.weights = broken.weights;
          is_needed = false;  // On a twist any weights keep the axis.
        }
        RC_PRE(squared_norm(combine<Rational, 4>(Span(w.weights), w.cap.rotations)) > 0);
        const Verdict hypothesis = twist_hypotheses<Rational>(w.axis, w.cap, w.weights);
        if (!is_needed) return Weakening{part, hypothesis, {}};
        return Weakening{part, hypothesis, twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights).verdict};
      },
      1500);
}

void each_part_of_a_witness_is_checked(Suite& t) {
  t.holds("each part of a twisted point is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    Twist w;
    w.cap.squared_cosine = 0;
    RC_PRE(w.applies());
    RC_PRE((squared_norm<Rational, 3>(cross<Rational>(w.x, w.axis)) > 0));
    const auto good = twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights);
    RC_ASSERT(good.verdict == Verdict::holds);
    const auto rejected = [&](const TwistedPoint<Rational>& p) {
      return is_twisted_point<Rational>(w.axis, w.cap, w.x, w.weights, p) == Verdict::fails;
    };
    const Rational amount = *gen::excess();
    auto along = good, rests = good;
    along.parts.along += w.axis * amount, along.parts.across -= w.axis * amount;
    rests.rotated = good.parts.along;  // This is in the ball and across, but no image.
    RC_ASSERT(rejected(along) && rejected(rests));
    for (int i = 0; i < 3; ++i) {
      auto sum = good, image = good, split = good;
      sum.parts.across[i] += amount;
      image.rotated[i] += amount;
      split.parts.along[i] += amount, split.parts.across[i] -= amount;
      RC_ASSERT(rejected(sum) && rejected(image) && rejected(split));
    }
    // The part across is longer, but still across: only the sum shows it.
    auto longer = good;
    longer.parts.across *= Rational(1) + amount;
    RC_ASSERT(rejected(longer));
  });
  t.holds("only the ball tells that a cap is too narrow", {.number_type = "rational", .cases = 300}, [] {
    Twist w;
    RC_PRE(squared_norm(w.cap.axis) > 0 && squared_norm(combine<Rational, 4>(Span(w.weights), w.cap.rotations)) > 0);
    w.cap.squared_cosine = *gen::unit_interval_rational();
    const RationalVec<3> along = w.axis * Rational(w.axis.dot(w.x) / w.axis.dot(w.axis)), across = w.x - along, zero(0, 0, 0);
    const Rational h = std::max<Rational>(2 * w.cap.squared_cosine - 1, Rational(0));
    const RationalVec<3> center = along + oracle::times(oracle::affine_of(w.cap.axis, zero), across) * h;
    const Rational r2 = (1 - h * h) * across.dot(across);
    const auto found = twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights);
    RC_ASSERT(found.parts.along == along && found.parts.across == across);
    const auto ball = twist_ball(w.cap, found.parts);
    RC_ASSERT(ball.center == center && ball.squared_radius == r2);
    const RationalVec<3> rotated =
        oracle::times(oracle::affine_of(Quaternion<Rational>(combine<Rational, 4>(Span(w.weights), w.cap.rotations)), zero), w.x);
    const RationalVec<3> gap = rotated - center;
    const bool inside = gap.dot(gap) <= r2;
    RC_CLASSIFY(!inside, "outside");
    RC_ASSERT(found.rotated == rotated && found.verdict == verdict_of(inside));
  });
  t.example("turned towards the axis a point is in the ball about its part along, but does not keep that part", {}, [] {
    // It turns (3, 4, 0) to (5, 0, 0), about the z axis.
    const b5::Fallback towards{{b5::Rotation(2, 0, 0, -1)}, {b5::Point(0, 0, 0)}, b5::Rotation(1, 0, 0, 0), 0};
    const auto found = twist_keeps_axis(b5::x_axis, towards, b5::Point(3, 4, 0), Span(b5::all));
    // It is split at the image: then its part along is kept, but the point's part across is not across.
    auto split_after = found;
    split_after.parts = {b5::Point(5, 0, 0), b5::Point(-2, 4, 0)};
    return found.rotated == b5::Point(5, 0, 0) && encloses(twist_ball(towards, found.parts), found.rotated) == Verdict::holds &&
           found.verdict == Verdict::fails &&
           is_twisted_point(b5::x_axis, towards, b5::Point(3, 4, 0), Span(b5::all), split_after) == Verdict::fails;
  });
  t.holds("of control points only what is said of rotations about the axis is said", {.number_type = "rational", .cases = 300},
          [] {
            const Twist w;
            const auto other = *gen::nonzero_quaternion(), p = w.about_axis();
            RC_PRE(turns_about(w.axis, other) == Verdict::fails);
            RC_ASSERT(control_points_keep_axis(w.axis, p, other, w.x) == Verdict::holds);
            RC_ASSERT(control_points_keep_axis(w.axis, other, p, w.x) == Verdict::holds);
            const RationalVec<3> moved = mix_rotations<Rational>(p, other, w.x).numerator -
                                         RationalVec<3>(w.axis * Rational(w.axis.dot(w.x) / w.axis.dot(w.axis))) * dot(p, other);
            RC_CLASSIFY(moved.dot(w.axis) != 0, "the part along the axis is not kept");
          });
}

void narrow_twists_have_smaller_balls(Suite& t) {
  t.holds("with a cap of less than all rotations the ball of a twist is as small as is said",
          {.number_type = "rational", .cases = 300}, [] {
            const NarrowTwist w;
            RC_ASSERT(w.applies());
            const auto found = twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights);
            RC_ASSERT(found.verdict == Verdict::holds);
          });
  reaches_share(t, "twists of several weight vertices, with a point beside the axis and a cap of its own", 0.5, [] {
    const NarrowTwist w;
    return w.applies() && !w.is_degenerate() && w.cap.squared_cosine > Rational(1, 2) && w.cap.squared_cosine < 1;
  });
}

PROPTEST(b5_rotation_axis) {
  twists_keep_the_part_along_the_axis(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  each_part_of_a_witness_is_checked(t);
  narrow_twists_have_smaller_balls(t);
  t.example("with rotations about two axes no axis is kept", {.form = "beyond", .hypothesis = "all turn about one axis"}, [] {
    const Span u(b5::halves);
    return twist_hypotheses(b5::x_axis, b5::two_axes, u) == Verdict::fails &&
           twist_keeps_axis(b5::x_axis, b5::two_axes, b5::x_axis, u).verdict == Verdict::fails;
  });
}

}  // namespace
}  // namespace proptests::suite_b5_rotation_axis
