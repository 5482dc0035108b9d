// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b2_control_hull_encloses.hpp"

#include "proptests/counterexamples/b2_control_hull_encloses.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_b2_control_hull_encloses {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Weights = std::vector<Rational>;

template <class Blend>
void assert_in_hull(const Blend& blend, const Weights& w) {
  const std::span<const Rational> u(w);
  RC_ASSERT(control_hull_hypotheses(control_points(blend), u) == Verdict::holds);
  const auto found = image_in_control_hull(blend, u);
  RC_ASSERT(found.verdict == Verdict::holds);
  RC_ASSERT(is_blended_image(blend, u, found.image) == Verdict::holds);
  RC_ASSERT((is_hull_point<Rational, 3>(positions(control_points(blend)), found.image, found.coefficients) == Verdict::holds));
}

// Returns the ball about a center that touches the farthest of the balls.
Ball3<Rational> ball_around(const RationalVec<3>& center, const std::vector<RationalVec<3>>& points, const Rational& radius) {
  Rational farthest(0);
  for (const auto& p : points) farthest = std::max(farthest, squared_distance(p, center));
  return {center, upper_root(farthest) + radius};
}

void blended_points_are_in_the_hull(Suite& t) {
  const Options exact{
      .form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.15, .degenerate_at_most = 0.85};
  t.holds("with positive weights every blended point is a convex combination of the control points", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    RC_ASSERT(pairs_are_positive(c.blend.rotations) == Verdict::holds);
    assert_in_hull(c.blend, c.weights);
    const auto duals = *rc::gen::container<std::vector<gen::RationalQuaternion>>(c.weights.size(), gen::nonzero_quaternion());
    assert_in_hull(DualQuaternionBlend<Rational>{c.blend.rotations, duals, c.blend.x}, c.weights);
    assert_in_hull(LinearBlend<Rational>{c.blend.center_images}, c.weights);
  });
  t.holds("it is the weights of the control points that count, not the pairs",
          {.form = "beyond", .number_type = "rational", .cases = 300, .degenerate_at_least = 0.1, .degenerate_at_most = 0.85},
          [] {
            const auto c = *gen::blend_case(gen::Spread::any, 3);
            RC_PRE(control_weights_are_positive(control_points(c.blend)) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_CLASSIFY(pairs_are_positive(c.blend.rotations) == Verdict::fails, "a pair is not positive");
            assert_in_hull(c.blend, c.weights);
          });
  t.holds("a ball around the control balls encloses the vertices of the reference ball", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    const std::span<const Rational> u(c.weights);
    const Rational radius = *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::positive_rational());
    RC_CLASSIFY(c.is_degenerate() || radius == 0, "degenerate");
    const auto points = control_points(c.blend);
    const auto ball = ball_around(*gen::rational_vector<3>(), positions(points), radius);
    const RationalVec<3> offset = *gen::sphere_point<3>() * radius;
    RC_ASSERT(encloses_control_balls(ball, points, radius) == Verdict::holds);
    RC_ASSERT(control_balls_enclose(c.blend, u, ball, radius, offset) == Verdict::holds);
    const RationalVec<3> vertex = image_in_control_hull(c.blend, u).image + offset;
    RC_ASSERT(encloses(ball, vertex) == Verdict::holds);
    const auto centers_only = ball_around(ball.center, positions(points), Rational(0));
    if (radius > Rational(1, 1000)) RC_ASSERT(encloses_control_balls(centers_only, points, radius) == Verdict::fails);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 3);
    const auto wrong = *gen::affine_weights(static_cast<int>(c.weights.size()));
    const auto statement = []<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Vec<S, 3>& x,
                                       const std::vector<S>& u) {
      return image_in_control_hull(SphericalBlend<S>{q, r, x}, std::span<const S>(u)).verdict;
    };
    for (const auto& u : {c.weights, wrong}) {
      if (blend_has_image(c.blend, std::span<const Rational>(u)) != Verdict::holds) continue;
      decide_by_all(statement, c.blend.rotations, c.blend.center_images, c.blend.x, u);
    }
    decide_by_all([]<class S>(const std::vector<Quaternion<S>>& q) { return pairs_are_positive<S>(q); }, c.blend.rotations);
  });

  t.holds("mutated coefficients or a mutated image are rejected", {.number_type = "rational", .cases = 300}, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    const std::span<const Rational> u(c.weights);
    const auto points = positions(control_points(c.blend));
    const auto good = image_in_control_hull(c.blend, u);
    auto coefficients = good.coefficients;
    coefficients[*rc::gen::inRange<std::size_t>(0, coefficients.size())] += *gen::positive_rational();
    RC_ASSERT((is_hull_point<Rational, 3>(points, good.image, coefficients) == Verdict::fails));
    const RationalVec<3> moved = good.image + *gen::nonzero_vector<3>();
    RC_ASSERT((is_hull_point<Rational, 3>(points, moved, good.coefficients) == Verdict::fails));
    RC_ASSERT(is_blended_image(c.blend, u, moved) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "each control point's weight and all of the weights are looked at by themselves", {.parts = 6, .share = 0.1},
      [] {
        auto c = *gen::blend_case(gen::Spread::positive, 4);
        const std::size_t m = c.blend.weight_vertex_count();
        RC_PRE(m > 1u);
        if (*rc::gen::inRange(0, 3) == 0) {
          const auto broken = gen::broken_weights(c.weights);
          const std::span<const Rational> u(broken.weights);
          RC_PRE(blend_has_image(c.blend, u) == Verdict::holds);
          return Weakening{broken.part, control_hull_hypotheses(control_points(c.blend), u),
                           image_in_control_hull(c.blend, u).verdict};
        }
        // One weight vertex is turned until just a part of the control points has a weight below 0.
        const std::size_t k = gen::any_place(m);
        c.blend.rotations[k] = *gen::nonzero_quaternion();
        const auto points = control_points(c.blend);
        long negative = 0, zero = 0;
        for (const auto& p : points) negative += p.weight < 0, zero += p.weight == 0;
        const std::span<const Rational> u(c.weights);
        RC_PRE(negative > 0 && zero == 0 && blend_has_image(c.blend, u) == Verdict::holds);
        return Weakening{"the weight of a control point", control_hull_hypotheses(points, u),
                         image_in_control_hull(c.blend, u).verdict};
      },
      500);
  t.holds("one weight that is not positive is enough to refuse, whichever it is", {.number_type = "rational", .cases = 100}, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    const auto good = control_points(c.blend);
    for (std::size_t k = 0; k < good.size(); ++k) {
      auto points = good;
      points[k].weight = *rc::gen::oneOf(rc::gen::just(Rational(0)),
                                         rc::gen::map(gen::excess(), [](const Rational& x) { return Rational(-x); }));
      RC_ASSERT(control_weights_are_positive(points) == Verdict::fails);
      points[k].weight = *gen::excess();
      RC_ASSERT(control_weights_are_positive(points) == Verdict::holds);
    }
  });
  needs_each_part(
      t, "each pair of weight vertices, and each weight vertex with itself, is looked at", {.parts = 7, .share = 0.2},
      [] {
        auto q = (*gen::blend_case(gen::Spread::positive, 4)).blend.rotations;
        RC_PRE(q.size() > 2u);
        const std::size_t m = q.size(), k = gen::any_place(m);
        std::string part;
        if (*rc::gen::arbitrary<bool>()) {
          part = gen::place(k, m) + " is 0";
          q[k].setZero();
        } else {
          const std::size_t l = (k + 1 + gen::any_place(m - 1)) % m;
          part = "the pair of " + gen::place(std::min(k, l), m) + " and " + gen::place(std::max(k, l), m);
          const Rational below = *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::excess());
          const RationalQuaternion other = q[k];
          q[l] -= other * Rational((dot(q[l], other) + below) / squared_norm(other));
          RC_PRE(squared_norm(q[l]) > 0);
          for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = 0; j < m; ++j)
              if (i != j && std::minmax(i, j) != std::minmax(k, l)) RC_PRE(dot(q[i], q[j]) > 0);
        }
        // This is sufficient for positive weights of the control points of degree 2.
        const DualQuaternionBlend<Rational> blend{q, q, RationalVec<3>(1, 2, 3)};
        return Weakening{part, pairs_are_positive(q), control_weights_are_positive(control_points(blend))};
      },
      2400);
}

void statements_say_their_words(Suite& t) {
  t.holds("what is said of control balls is said of just those cases that it speaks of",
          {.number_type = "rational", .cases = 600}, [] {
            auto c = *gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), 3);
            const std::span<const Rational> u(c.weights);
            const auto control = control_points(c.blend);
            for (const auto& p : control) RC_PRE(p.weight != 0);
            RC_PRE(blend_has_image(c.blend, u) == Verdict::holds);
            const Rational size = *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::positive_rational()), excess = *gen::excess();
            const Rational radius = size * *rc::gen::element(Rational(1), Rational(1), Rational(-1));
            const RationalVec<3> offset =
                *gen::sphere_point<3>() *
                Rational(size * *rc::gen::element(Rational(1), Rational(1, 2), Rational(1 + excess), Rational(20)));
            Ball3<Rational> ball = ball_around(*gen::rational_vector<3>(), positions(control), radius);
            ball.radius += *rc::gen::element(Rational(0), Rational(0), excess, Rational(-excess), Rational(-2 * ball.radius));
            bool around = true;
            std::vector<RationalVec<3>> centers;
            for (const auto& p : control) centers.push_back(p.numerator / p.weight);
            for (const auto& p : centers) {
              const RationalVec<3> gap = p - ball.center;
              const Rational room = ball.radius - radius;
              around = around && room >= 0 && gap.dot(gap) <= room * room;
            }
            const auto at = c.blend.at(u);
            const RationalVec<3> vertex = at.numerator / at.denominator + offset, gap = vertex - ball.center;
            const bool inside = ball.radius >= 0 && gap.dot(gap) <= ball.radius * ball.radius;
            const bool short_enough = offset.dot(offset) <= radius * radius;
            RC_CLASSIFY(around && short_enough && radius >= 0 && inside, "holds as the theorem says");
            RC_CLASSIFY(around && short_enough && radius >= 0 && !inside, "fails: a weight is not positive");
            RC_CLASSIFY(around && short_enough && radius < 0 && !inside, "nothing is said: only the radius is negative");
            RC_CLASSIFY(around && !short_enough && radius >= 0 && !inside, "nothing is said: only the offset is too long");
            RC_CLASSIFY(!around && short_enough && radius >= 0 && !inside, "nothing is said: only the ball is too small");
            RC_ASSERT(encloses_control_balls(ball, control, radius) == verdict_of(around));
            RC_ASSERT(control_balls_enclose(c.blend, u, ball, radius, offset) ==
                      verdict_of(!(around && short_enough && radius >= 0) || inside));
          });
  t.example("a single weight vertex that is 0 is refused, though it has no other to be at a right angle to", {}, [] {
    const std::vector<RationalQuaternion> zero{RationalQuaternion(0, 0, 0, 0)};
    return pairs_are_positive(zero) == Verdict::fails;
  });
  t.example("where a weight is negative, a ball around the control balls need not hold the vertex", {}, [] {
    // Seen from far below, the image is above all control points.
    const auto points = control_points(b2::far_apart);
    const auto ball = ball_around(b2::upwards * Rational(-1000000), positions(points), Rational(0));
    return encloses_control_balls(ball, points, Rational(0)) == Verdict::holds &&
           control_balls_enclose(b2::far_apart, std::span<const Rational>(b2::halves), ball, Rational(0),
                                 RationalVec<3>(0, 0, 0)) == Verdict::fails;
  });
  t.holds("a single control ball that is not inside is enough, whichever it is", {.number_type = "rational", .cases = 100}, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    const auto good = control_points(c.blend);
    const Rational radius = *gen::positive_rational();
    auto ball = ball_around(*gen::rational_vector<3>(), positions(good), radius);
    for (std::size_t k = 0; k < good.size(); ++k) {
      auto points = good;
      const RationalVec<3> direction = *gen::sphere_point<3>(),
                           touching = ball.center + direction * Rational(ball.radius - radius);
      points[k].numerator = touching * points[k].weight;
      RC_ASSERT(encloses_control_balls(ball, points, radius) == Verdict::holds);
      points[k].numerator += direction * *gen::excess();
      RC_ASSERT(encloses_control_balls(ball, points, radius) == Verdict::fails);
    }
  });
}

void pinned_cases(Suite& t) {
  t.example("with a negative weight the image is outside the hull", {.form = "beyond", .hypothesis = "all W_I are positive"}, [] {
    const std::span<const Rational> u(b2::halves);
    const auto points = control_points(b2::far_apart);
    const auto found = image_in_control_hull(b2::far_apart, u);
    return control_weights_are_positive(points) == Verdict::fails && found.verdict == Verdict::fails &&
           separates<Rational, 3>(b2::upwards, found.image, positions(points)) == Verdict::holds;
  });
  t.example("weights beyond the weight vertices make images outside the hull",
            {.form = "beyond", .hypothesis = "the weights are convex"}, [] {
              const std::span<const Rational> u(b2::beyond_the_first);
              const auto points = control_points(b2::near);
              const auto found = image_in_control_hull(b2::near, u);
              return control_weights_are_positive(points) == Verdict::holds && found.verdict == Verdict::fails &&
                     separates<Rational, 3>(b2::downwards, found.image, positions(points)) == Verdict::holds;
            });
  t.example("a vertex outside the reference ball may leave the ball around the control balls",
            {.form = "beyond", .hypothesis = "||y|| <= r"}, [] {
              const RationalVec<3> vertex =
                  image_in_control_hull(b2::resting, std::span<const Rational>(b2::all)).image + b2::too_long;
              return encloses_control_balls<Rational>(b2::unit_ball, control_points(b2::resting), 1) == Verdict::holds &&
                     encloses(b2::unit_ball, vertex) == Verdict::fails;
            });
  t.example("degree 3 reaches beyond half a turn, where a pair is negative", {.form = "beyond"}, [] {
    return pairs_are_positive(b2::beyond_half_a_turn.rotations) == Verdict::fails &&
           control_weights_are_positive(control_points(b2::beyond_half_a_turn)) == Verdict::holds &&
           image_in_control_hull(b2::beyond_half_a_turn, std::span<const Rational>(b2::halves)).verdict == Verdict::holds;
  });
}

PROPTEST(b2_control_hull_encloses) {
  blended_points_are_in_the_hull(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  statements_say_their_words(t);
  reaches_share(t, "cases of several weight vertices that differ, at neither right angle nor 0", 0.3,
                [] { return !(*gen::blend_case(gen::Spread::positive, 4)).is_degenerate(); });
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b2_control_hull_encloses
