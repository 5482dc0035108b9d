// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b6_dual_quaternion_ball.hpp"

#include "proptests/counterexamples/b6_dual_quaternion_ball.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/nearest_point.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_b6_dual_quaternion_ball {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Span = std::span<const Rational>;
using Blend = DualQuaternionBlend<Rational>;

// Draws weight vertices of any length and duals of any kind. The axis is the weight vertices' sum, one of them, their nearest
// point to 0, or any.
struct BallCase {
  Blend blend;
  std::vector<Rational> weights;
  bool is_degenerate;
  RationalQuaternion axis = RationalQuaternion::Zero();
  RationalVec<3> center;
  explicit BallCase(int most) {
    const auto c = *gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), most);
    is_degenerate = c.is_degenerate();
    weights = c.weights;
    blend = {c.blend.rotations, {}, c.blend.x};
    for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k) blend.duals.push_back(*gen::rational_vector<4>());
    const int kind = *rc::gen::inRange(0, 4);
    if (kind == 0)
      for (const auto& q : blend.rotations) axis += q;
    if (kind == 1) axis = blend.rotations[0];
    if (kind == 2) axis = combine<Rational, 4>(nearest_point_coefficients<4>(blend.rotations), blend.rotations);
    if (kind == 3) axis = *gen::nonzero_quaternion();
    center = *gen::rational_vector<3>();
  }
  Span u() const { return weights; }
  bool applies() const { return dual_quaternion_ball_hypotheses(blend, axis, u()) == Verdict::holds; }
};

// Draws the same with at least so many weight vertices, all of them turned to the axis' side.
struct AheadCase : BallCase {
  explicit AheadCase(std::size_t least) : BallCase(4) {
    RC_PRE(blend.weight_vertex_count() >= least && squared_norm(axis) > 0);
    for (auto& q : blend.rotations) {
      RC_PRE(dot(q, axis) != 0);
      if (dot(q, axis) < 0) q = -q;
    }
  }
};

void images_are_in_the_ball(Suite& t) {
  t.holds("the ball holds every image, and no blend is 0",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const BallCase c(4);
            RC_PRE(c.applies());
            RC_CLASSIFY(c.is_degenerate, "degenerate");
            const auto ball = dual_quaternion_ball(c.blend, c.axis, c.center);
            const auto reached = dual_quaternion_ball_encloses(c.blend, c.axis, c.center, c.u());
            RC_ASSERT(reached.verdict == Verdict::holds);
            RC_ASSERT(is_reached_image(c.blend, c.axis, ball, c.u(), reached) == Verdict::holds);
          });
  t.holds("what is measured at a weight vertex is the distance of its image, and the part of its dual along it",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const BallCase c(4);
            RC_CLASSIFY(c.is_degenerate, "degenerate");
            for (std::size_t k = 0; k < c.blend.weight_vertex_count(); ++k)
              if (squared_norm(c.blend.rotations[k]) > 0) RC_ASSERT(reach_is_distance(c.blend, k, c.center) == Verdict::holds);
          });
  t.holds("of rigid transforms it is the distance alone", {.form = "beyond", .number_type = "rational", .cases = 400}, [] {
    const auto joint = *gen::rigid_transform();
    const auto& x = joint.translation;
    const RationalVec<3> p = *gen::rational_vector<3>(), f = *gen::rational_vector<3>();
    const auto twice_dual = oracle::hamilton<Rational>({0, x[0], x[1], x[2]}, joint.rotation);
    const Blend blend{{joint.rotation}, {twice_dual / Rational(2)}, p};
    RC_ASSERT(squared_norm(reach_at(blend, 0, f)) == (squared_distance<Rational, 3>(apply(joint, p), f)));
  });
  t.holds("there is an axis if and only if no blend is 0",
          {.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2}, [] {
            const BallCase c(5);
            RC_CLASSIFY(c.is_degenerate, "degenerate");
            const auto& q = c.blend.rotations;
            const auto nearest = combine<Rational, 4>(nearest_point_coefficients<4>(q), q);
            const bool vanishes = squared_norm(nearest) == 0;
            RC_CLASSIFY(vanishes, "a blend is 0");
            RC_ASSERT((are_strictly_ahead(q, nearest) == Verdict::holds) == !vanishes);
            if (are_strictly_ahead(q, c.axis) == Verdict::holds) RC_ASSERT(!vanishes);
          });
  t.example("near a blend that is 0 a vertex is carried as far as wanted", {.form = "beyond"}, [] {
    for (const b6::Q far : {1, 1000, 1000000}) {
      // Just before half-way q = e and d = (0, -(1 - e) / 2, 0, 0), so the image of the origin is (1 - 1/e, 0, 0).
      const b6::Q e = Rational(1) / (Rational(3) * far);
      const std::vector<b6::Q> u{(Rational(1) + e) / Rational(2), (Rational(1) - e) / Rational(2)};
      const auto at = b6::opposite.at(u);
      if (!(squared_norm<b6::Q, 3>(at.numerator / at.denominator) > far * far)) return false;
    }
    return true;
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const BallCase c(3);
    RC_PRE(squared_norm(combine<Rational, 4>(c.u(), c.blend.rotations)) > 0);
    for (const auto& q : c.blend.rotations) RC_PRE(dot(q, c.axis) != 0);
    decide_by_all(
        []<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Quaternion<S>>& d, const Vec<S, 3>& p,
                    const Quaternion<S>& axis, const Vec<S, 3>& center, const std::vector<S>& u) {
          return dual_quaternion_ball_encloses<S>({q, d, p}, axis, center, u).verdict;
        },
        c.blend.rotations, c.blend.duals, c.blend.point, c.axis, c.center, c.weights);
  });

  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const BallCase c(4);
    RC_PRE(c.applies());
    const auto ball = dual_quaternion_ball(c.blend, c.axis, c.center);
    const auto good = dual_quaternion_ball_encloses(c.blend, c.axis, c.center, c.u());
    const auto rejected = [&](const ReachedImage<Rational>& witness) {
      return is_reached_image(c.blend, c.axis, ball, c.u(), witness) == Verdict::fails;
    };
    auto image = good, reach = good, longer = good;
    image.image += *gen::nonzero_vector<3>();
    reach.reach += *gen::nonzero_quaternion();
    // A change along the blend does not show in the image: only the length shows it.
    const RationalQuaternion q = combine<Rational, 4>(c.u(), c.blend.rotations);
    const Rational size = ball.squared_radius + Rational(1);
    longer.reach += q * (Rational(2) * size + squared_norm(good.reach) / squared_norm(q));
    RC_ASSERT(rejected(image) && rejected(longer));
    const auto led = [&](const ReachedImage<Rational>& r) { return imaginary(multiply(r.reach, conjugate(q))); };
    RC_ASSERT(rejected(reach) || led(reach) == led(good));
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "each weight vertex and each of the weights is looked at by itself", {.parts = 11, .share = 0.02},
      [] {
        const AheadCase c(3);
        auto blend = c.blend;
        auto u = c.weights;
        const std::size_t m = blend.weight_vertex_count(), k = gen::any_place(m);
        auto& q = blend.rotations[k];
        std::string part;
        const std::size_t kind = gen::any_place(3);
        if (kind == 0) {
          part = gen::place(k, m) + " is behind the axis";
          q = -q;
        } else if (kind == 1) {
          part = gen::place(k, m) + " is at a right angle to the axis";
          q -= c.axis * Rational(dot(q, c.axis) / squared_norm(c.axis));
        } else {
          const auto broken = gen::broken_weights(u);
          part = broken.part, u = broken.weights;
        }
        const Verdict hypothesis = dual_quaternion_ball_hypotheses(blend, c.axis, Span(u));
        // At a right angle the ball's radius is no number. The image depends on the ratios of the weights, not on their sum.
        if (kind == 1 || (kind == 2 && std::none_of(u.begin(), u.end(), [](const Rational& x) { return x < 0; })))
          return Weakening{part, hypothesis, {}};
        RC_PRE(squared_norm(combine<Rational, 4>(Span(u), blend.rotations)) > 0);
        return Weakening{part, hypothesis, dual_quaternion_ball_encloses(blend, c.axis, c.center, Span(u)).verdict};
      },
      3000);
}

void each_part_of_a_witness_is_checked(Suite& t) {
  t.holds("the ball's radius is the greatest of the weight vertices', and its verdict is whether the image is inside",
          {.number_type = "rational", .cases = 500}, [] {
            const AheadCase c(1);
            auto blend = c.blend;
            for (auto& q : blend.rotations)
              if (*rc::gen::inRange(0, 4) == 0) q = -q;
            RC_PRE(squared_norm(combine<Rational, 4>(c.u(), blend.rotations)) > 0);
            const auto pure = [](const RationalVec<3>& x) { return RationalQuaternion(0, x[0], x[1], x[2]); };
            Rational greatest(0);
            RationalQuaternion reach(0, 0, 0, 0), q(0, 0, 0, 0), d(0, 0, 0, 0);
            for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k) {
              const auto& r = blend.rotations[k];
              const RationalQuaternion e =
                  blend.duals[k] * Rational(2) + oracle::hamilton(r, pure(blend.point)) - oracle::hamilton(pure(c.center), r);
              RC_ASSERT(reach_at(blend, k, c.center) == e);
              greatest = std::max<Rational>(greatest, e.dot(e) / (r.dot(c.axis) * r.dot(c.axis)));
              reach += e * c.weights[k], q += r * c.weights[k], d += blend.duals[k] * c.weights[k];
            }
            const auto ball = dual_quaternion_ball(blend, c.axis, c.center);
            RC_ASSERT(ball.center == c.center && ball.squared_radius == greatest * c.axis.dot(c.axis));
            // The image satisfies ||q||^2 v' = Im(q p q* + 2 d q*).
            const RationalQuaternion back(q[0], -q[1], -q[2], -q[3]);
            const RationalQuaternion scaled =
                oracle::hamilton(oracle::hamilton(q, pure(blend.point)), back) + oracle::hamilton(d, back) * Rational(2);
            const RationalVec<3> image = RationalVec<3>(scaled[1], scaled[2], scaled[3]) / q.dot(q), gap = image - c.center;
            const auto found = dual_quaternion_ball_encloses(blend, c.axis, c.center, c.u());
            RC_ASSERT(found.image == image && found.reach == reach);
            const bool inside = gap.dot(gap) <= ball.squared_radius;
            RC_CLASSIFY(!inside, "outside");
            RC_ASSERT(found.verdict == verdict_of(inside));
          });
  t.holds("each part of a witness is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    const AheadCase c(2);
    const auto good = dual_quaternion_ball_encloses(c.blend, c.axis, c.center, c.u());
    const SquaredBall<Rational, 3> huge{c.center, Rational(1000000000) * Rational(1000000000) * Rational(1000000000)};
    const auto verdict = [&](const SquaredBall<Rational, 3>& ball, const ReachedImage<Rational>& w) {
      return is_reached_image(c.blend, c.axis, ball, c.u(), w);
    };
    RC_ASSERT(verdict(huge, good) == Verdict::holds);
    const RationalQuaternion q = combine<Rational, 4>(c.u(), c.blend.rotations);
    const Rational amount = *gen::excess();
    for (int i = 0; i < 3; ++i) {
      RationalVec<3> step(0, 0, 0);
      step[i] = amount;
      // This leads to an image that is off by the step.
      const RationalQuaternion led = multiply(pure_quaternion(step), q);
      auto image = good, reach = good, both = good;
      image.image += step, reach.reach += led;
      both.image += step, both.reach += led;
      RC_ASSERT(verdict(huge, image) == Verdict::fails && verdict(huge, reach) == Verdict::fails &&
                verdict(huge, both) == Verdict::fails);
    }
    // The witness just reaches one ball, and the other is a little smaller.
    const Rational along = dot(q, c.axis), reached = squared_norm(good.reach) * squared_norm(c.axis) / (along * along);
    RC_ASSERT(verdict({c.center, reached}, good) == Verdict::holds);
    RC_ASSERT(verdict({c.center, reached - amount}, good) == Verdict::fails);
  });
  t.example("where the blend is 0 nothing is reached, though nothing else says so", {}, [] {
    const std::vector<b6::Q> halves{b6::Q(1, 2), b6::Q(1, 2)};
    return is_reached_image<b6::Q>(b6::still, b6::identity, {b6::between, 1}, Span(halves),
                                   {Verdict::holds, b6::between, b6::none}) == Verdict::fails;
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const b6::Blend& blend,
                                  const b6::Point& center, const std::vector<b6::Q>& u) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      const Span weights(u);
      return dual_quaternion_ball_hypotheses(blend, b6::identity, weights) == Verdict::fails &&
             dual_quaternion_ball_encloses(blend, b6::identity, center, weights).verdict == Verdict::fails;
    });
  };
  fails_without("all weight vertices are ahead of the axis", "with a weight vertex behind the axis a vertex leaves the ball",
                b6::opposite, b6::between, b6::third);
  fails_without("the weights are convex", "beyond the weight vertices a vertex leaves the ball", b6::turning, b6::turning.point,
                b6::beyond_the_first);
}

PROPTEST(b6_dual_quaternion_ball) {
  images_are_in_the_ball(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  each_part_of_a_witness_is_checked(t);
  reaches_share(t, "cases of several weight vertices ahead of the axis, that differ", 0.1, [] {
    const BallCase c(4);
    return c.applies() && !c.is_degenerate;
  });
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b6_dual_quaternion_ball
