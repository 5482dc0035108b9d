// SPDX-License-Identifier: GPL-3.0-or-later
// Tests skinning that blends scales first, then rotations.
#include "lemmas/a2_two_phase_skinning.hpp"

#include "lemmas/b6_dual_quaternion_ball.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "proptests/counterexamples/a2_two_phase_skinning.hpp"
#include "proptests/gen/affine.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_a2_two_phase_skinning {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Span = std::span<const Rational>;

struct Scaled {
  std::vector<AffineMap<Rational>> scales;
  std::vector<Rational> weights;
  RationalVec<3> vertex = *gen::rational_vector<3>();
  SquaredBall<Rational, 3> reference, around;  // This is around all scaled balls.
  Scaled() {
    const std::size_t count = 1 + gen::any_place(4);
    for (std::size_t k = 0; k < count; ++k) scales.push_back(gen::affine_map().map);
    weights = *gen::convex_weights(static_cast<int>(count));
    reference = {*gen::rational_vector<3>(), Rational(0)};
    reference.squared_radius = squared_distance(vertex, reference.center);
    around = {*gen::rational_vector<3>(), Rational(0)};
    Rational radius(0);
    for (const auto& ball : scaled_balls<Rational>(scales, reference))
      radius =
          std::max(radius, Rational(upper_root(squared_distance(ball.center, around.center)) + upper_root(ball.squared_radius)));
    around.squared_radius = radius * radius;
  }
  bool is_degenerate() const {
    bool one = scales.size() == 1 || reference.squared_radius == 0;
    for (const auto& w : weights) one = one || w == 1;
    return one;
  }
};

void skinned_vertices_are_in_the_balls(Suite& t) {
  t.holds("a vertex that is scaled first is in the ball around the scaled balls",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.6}, [] {
            const Scaled c;
            RC_ASSERT(two_phase_hypotheses<Rational>(c.scales, c.around, c.vertex, c.weights) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            const auto found = stays_in_scaled_ball<Rational>(c.scales, c.around, c.vertex, c.weights);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_scaled_vertex<Rational>(c.scales, c.around, c.vertex, c.weights, found.scaled) == Verdict::holds);
          });
  t.holds(
      "the ball of the rigid joints about what was scaled holds the skinned vertex: by dual quaternions, with the "
      "reach of the ball",
      {.form = "beyond", .number_type = "rational", .cases = 300, .degenerate_at_most = 0.6}, [] {
        const Scaled c;
        RC_CLASSIFY(c.is_degenerate(), "degenerate");
        auto rigid = *gen::rigid_transforms(static_cast<int>(c.scales.size()), static_cast<int>(c.scales.size()));
        gen::RationalQuaternion axis = gen::RationalQuaternion::Zero();
        for (auto& r : rigid) {
          if (dot(r.rotation, rigid[0].rotation) < 0) r.rotation = -r.rotation;
          axis += r.rotation;
        }
        for (const auto& r : rigid) RC_PRE(dot(r.rotation, axis) > 0);
        const auto scaled = stays_in_scaled_ball<Rational>(c.scales, c.around, c.vertex, c.weights).scaled;
        const RationalVec<3> vertex = oracle::dual_quaternion(rigid, c.weights, scaled);
        // The ball is that of b6 about the center, with the ball's radius added for what it turns.
        const auto ball = dual_quaternion_ball<Rational>(dual_blend(rigid, c.around.center), axis, *gen::rational_vector<3>());
        const Rational radius = upper_root(ball.squared_radius) + upper_root(c.around.squared_radius);
        RC_ASSERT(squared_distance(vertex, ball.center) <= radius * radius);
      });
  t.holds("one joint, or one scale for all, is what it was", {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
    Scaled c;
    for (auto& s : c.scales) s = c.scales[0];
    const auto rigid = *gen::rigid_transform();
    const RationalVec<3> scaled = stays_in_scaled_ball<Rational>(c.scales, c.around, c.vertex, c.weights).scaled;
    RC_ASSERT(scaled == apply(c.scales[0], c.vertex));
    const RationalVec<3> both = apply(rigid, scaled);
    RC_ASSERT(both == oracle::dual_quaternion<Rational>({rigid}, {Rational(1)}, scaled));
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const Scaled c;
    std::vector<RationalVec<3>> parts;
    for (const auto& s : c.scales) parts.insert(parts.end(), {s.columns[0], s.columns[1], s.columns[2], s.offset});
    decide_by_all(
        []<class S>(const std::vector<Vec<S, 3>>& parts, const Vec<S, 3>& center, const S& squared_radius,
                    const Vec<S, 3>& vertex, const std::vector<S>& w) {
          std::vector<AffineMap<S>> scales;
          for (std::size_t k = 0; k < parts.size(); k += 4)
            scales.push_back({{parts[k], parts[k + 1], parts[k + 2]}, parts[k + 3]});
          return stays_in_scaled_ball<S>(scales, {center, squared_radius}, vertex, w).verdict;
        },
        parts, c.around.center, Rational(c.around.squared_radius * *rc::gen::element(Rational(1), Rational(1, 10))), c.vertex,
        c.weights);
  });
  t.holds("mutated witnesses are rejected, and true ones outside of the ball", {.number_type = "rational", .cases = 400}, [] {
    const Scaled c;
    auto scaled = stays_in_scaled_ball<Rational>(c.scales, c.around, c.vertex, c.weights).scaled;
    const SquaredBall<Rational, 3> elsewhere{scaled, Rational(-1)},
        small{c.around.center, squared_distance(scaled, c.around.center) - *gen::excess()};
    RC_ASSERT(is_scaled_vertex<Rational>(c.scales, elsewhere, c.vertex, c.weights, scaled) == Verdict::fails);
    RC_ASSERT(is_scaled_vertex<Rational>(c.scales, small, c.vertex, c.weights, scaled) == Verdict::fails);
    scaled[static_cast<int>(gen::any_place(3))] += *gen::excess();
    RC_ASSERT(is_scaled_vertex<Rational>(c.scales, {c.around.center, c.around.squared_radius * Rational(4) + Rational(1000000)},
                                         c.vertex, c.weights, scaled) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "two phases need each part of the hypotheses", {.parts = 6, .share = 0.2},
      [] {
        Scaled c;
        std::string part;
        const RationalVec<3> moved = linear_blend<Rational>(c.scales, c.weights, c.vertex);
        bool asked = true;
        if (*rc::gen::arbitrary<bool>()) {
          part = "a scaled vertex";
          c.around = {moved, Rational(0)};
          const std::size_t k = gen::any_place(c.scales.size());
          c.scales[k].offset += *gen::nonzero_vector<3>();
          if (apply(c.scales[k], c.vertex) == moved) c.scales[k].offset[0] += Rational(1);
        } else {
          const auto broken = gen::broken_weights(c.weights);
          part = broken.part, c.weights = broken.weights;
          asked = part.find("more") != std::string::npos;
          Rational farthest(0);  // This is as small as it may be.
          c.around.center = RationalVec<3>::Zero();
          for (const auto& s : c.scales) farthest = std::max(farthest, squared_norm(apply(s, c.vertex)));
          c.around.squared_radius = farthest;
        }
        return Weakening{part, two_phase_hypotheses<Rational>(c.scales, c.around, c.vertex, c.weights),
                         asked ? std::optional(stays_in_scaled_ball<Rational>(c.scales, c.around, c.vertex, c.weights).verdict)
                               : std::nullopt};
      },
      900);
}

void pinned_cases(Suite& t) {
  t.example("between a joint that scales and one that does not a vertex leaves its ball",
            {.form = "beyond", .hypothesis = "the ball encloses the scaled vertices"}, [] {
              using namespace a2;
              return stays_in_reference_ball<Q>(scales, reference, vertex, halves) == Verdict::fails &&
                     two_phase_hypotheses<Q>(scales, reference, vertex, halves) == Verdict::fails &&
                     stays_in_scaled_ball<Q>(scales, around, vertex, halves).verdict == Verdict::holds &&
                     scaled_balls<Q>(scales, reference)[1].squared_radius == 9;
            });
  t.example("weights beyond the joints leave the ball", {.form = "beyond", .hypothesis = "the weights are convex"}, [] {
    using namespace a2;
    return two_phase_hypotheses<Q>(scales, around, vertex, beyond) == Verdict::fails &&
           stays_in_scaled_ball<Q>(scales, around, vertex, beyond).verdict == Verdict::fails;
  });
}

PROPTEST(a2_two_phase_skinning) {
  skinned_vertices_are_in_the_balls(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_a2_two_phase_skinning
