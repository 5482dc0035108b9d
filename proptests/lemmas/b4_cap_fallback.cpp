// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b4_cap_fallback.hpp"

#include "lemmas/b2_control_hull_encloses.hpp"
#include "lemmas/s44_sum_of_bounds.hpp"
#include "proptests/counterexamples/b4_cap_fallback.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_b4_cap_fallback {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Span = std::span<const Rational>;
using Span4 = std::span<const RationalQuaternion>;
using Fallback = CapFallback<Rational>;

// Returns the best cap about the sum of the weight vertices, about one of them or about any axis, or all rotations where there is
// none.
Fallback fallback_of(const SphericalBlend<Rational>& blend) {
  Fallback cap{blend.rotations, blend.center_images, Quaternion<Rational>(0, 0, 0, 0), Rational(0)};
  const int kind = *rc::gen::inRange(0, 4);
  if (kind < 2)
    for (const auto& q : blend.rotations) cap.axis += q;
  else cap.axis = kind == 2 ? blend.rotations[0] : *gen::nonzero_quaternion();
  bool available = squared_norm(cap.axis) > 0;
  for (const auto& q : cap.rotations) available = available && squared_norm(q) > 0 && dot(q, cap.axis) >= 0;
  if (available) cap.squared_cosine = squared_cap_cosine<Rational>(cap.rotations, cap.axis);
  if (*rc::gen::inRange(0, 4) == 0) cap.squared_cosine /= 2;
  return cap;
}

struct FallbackCase {
  gen::BlendCase c;
  Fallback cap;
  Rational radius;
  RationalVec<3> offset;
  explicit FallbackCase(int most)
      : c(*gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), most)),
        cap(fallback_of(c.blend)),
        radius(*rc::gen::oneOf(rc::gen::just(Rational(0)), gen::positive_rational())),
        offset(*gen::sphere_point<3>() * radius) {}
  Span u() const { return c.weights; }
  bool applies() const { return cap_fallback_hypotheses(cap, u()) == Verdict::holds; }
};

// Draws three or four weight vertices in a cap of kappa^2 > 1/2, which claims something. They are drawn together until they are
// in it.
struct NarrowCap {
  Fallback cap;
  std::vector<Rational> weights;
  NarrowCap() {
    const int m = *rc::gen::inRange(3, 5);
    cap.axis = *gen::nonzero_quaternion();
    cap.rotations = *rc::gen::container<std::vector<RationalQuaternion>>(m, gen::nonzero_quaternion());
    cap.center_images = *rc::gen::container<std::vector<RationalVec<3>>>(m, gen::rational_vector<3>());
    const auto is_near = [&](const RationalQuaternion& q) {
      return dot(q, cap.axis) > 0 && 2 * sq(dot(q, cap.axis)) > squared_norm(q) * squared_norm(cap.axis);
    };
    for (auto& q : cap.rotations)
      while (!is_near(q)) q = (q + cap.axis) / Rational(2);
    cap.squared_cosine = squared_cap_cosine<Rational>(cap.rotations, cap.axis);
    weights = *gen::convex_weights(m);
  }
};

void vertices_are_in_the_hull_of_the_balls(Suite& t) {
  t.holds("the hull of the cap's balls holds every vertex, whatever the signs of the dot products",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2, .degenerate_at_most = 0.85},
          [] {
            const FallbackCase f(4);
            RC_PRE(f.applies());
            RC_CLASSIFY(f.c.is_degenerate() || f.radius == 0, "degenerate");
            RC_CLASSIFY(f.cap.squared_cosine <= Rational(1, 2), "all rotations");
            RC_CLASSIFY(pairs_are_positive(f.cap.rotations) == Verdict::fails, "the control hull is no bound");
            const auto steps = cap_fallback_encloses(f.cap, f.c.blend.x, f.u(), f.offset);
            RC_ASSERT(steps.verdict == Verdict::holds);
            RC_ASSERT(is_fallback_steps(f.cap, f.c.blend.x, f.u(), f.offset, steps) == Verdict::holds);
            const RationalVec<3> image = steps.vertex - f.offset;
            RC_ASSERT(is_blended_image(f.c.blend, f.u(), image) == Verdict::holds);
          });
  t.holds("so a ball around the balls encloses it, by the sum of bounds of section 4.4",
          {.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2, .degenerate_at_most = 0.85},
          [] {
            const FallbackCase f(4);
            RC_PRE(f.applies());
            RC_CLASSIFY(f.c.is_degenerate() || f.radius == 0, "degenerate");
            const auto steps = cap_fallback_encloses(f.cap, f.c.blend.x, f.u(), f.offset);
            const auto turned = fallback_ball(f.cap, f.c.blend.x);
            const PartBounds<Rational> bounds{f.cap.center_images, {turned.center, upper_root(turned.squared_radius)}, f.radius};
            const RationalVec<3> center = *gen::rational_vector<3>();
            Rational farthest(0);
            for (const auto& r : f.cap.center_images)
              farthest = std::max<Rational>(farthest, squared_distance<Rational, 3>(r + turned.center, center));
            const Ball3<Rational> ball{center, upper_root(farthest) + bounds.spherical.radius};
            RC_ASSERT(encloses_equal_balls(ball, bounds) == Verdict::holds);
            RC_ASSERT(encloses(inflate(ball, f.radius), steps.vertex) == Verdict::holds);
          });
  t.holds("where all dot products are at least 0 the cap about the sum of the weight vertices is there",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.15, .degenerate_at_most = 0.85},
          [] {
            const auto c = *gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), 4);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(positive_pairs_are_ahead(c.blend.rotations) == Verdict::holds);
          });
  t.example("the cap reaches weight vertices that the control hull does not: dot products below 0, ahead of a common axis",
            {.form = "beyond"}, [] {
              return less(dot(b4::wide_pair[0], b4::wide_pair[1]), b4::Q(0)) == Verdict::holds &&
                     are_ahead<b4::Q>(b4::wide_pair, b4::identity) == Verdict::holds;
            });
  t.example("a control point of degree 2 leaves the cap's ball beyond a right angle between the rotations, not before",
            {.form = "beyond"}, [] {
              const auto inside = [](const std::vector<b4::Rotation>& q) {
                const b4::Fallback cap{q, b4::at_origin, b4::identity, squared_cap_cosine<b4::Q>(q, b4::identity)};
                const b4::Point control = mix_rotations<b4::Q>(q[0], q[1], b4::x).numerator / dot(q[0], q[1]);
                return encloses(fallback_ball(cap, b4::x), control);
              };
              return inside(b4::below_a_right_angle) == Verdict::holds && inside(b4::beyond_a_right_angle) == Verdict::fails;
            });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const FallbackCase f(3);
    RC_PRE(squared_norm(combine<Rational, 4>(f.u(), f.cap.rotations)) > 0);
    auto wrong = f.cap;  // This cap may be too narrow.
    wrong.squared_cosine = *gen::unit_interval_rational();
    RC_PRE(squared_norm(f.cap.axis) > 0);
    for (const auto& cap : {f.cap, wrong})
      decide_by_all(
          []<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Quaternion<S>& axis,
                      const S& squared_cosine, const Vec<S, 3>& x, const std::vector<S>& u, const Vec<S, 3>& y) {
            return cap_fallback_encloses<S>({q, r, axis, squared_cosine}, x, u, y).verdict;
          },
          cap.rotations, cap.center_images, cap.axis, cap.squared_cosine, f.c.blend.x, f.c.weights, f.offset);
  });

  t.holds("mutated steps are rejected", {.number_type = "rational", .cases = 400}, [] {
    const FallbackCase f(4);
    RC_PRE(f.applies());
    const auto good = cap_fallback_encloses(f.cap, f.c.blend.x, f.u(), f.offset);
    const auto rejected = [&](const FallbackSteps<Rational>& steps) {
      return is_fallback_steps(f.cap, f.c.blend.x, f.u(), f.offset, steps) == Verdict::fails;
    };
    const RationalVec<3> bump = *gen::nonzero_vector<3>();
    auto vertex = good, hull = good, step = good;
    vertex.vertex += bump;
    hull.hull_point += bump, hull.vertex += bump;     // This is consistent, but off the hull point of u.
    step.rotation_step += bump, step.vertex += bump;  // This is consistent, but no rotation of x by the blend.
    RC_ASSERT(rejected(vertex) && rejected(hull) && rejected(step));
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "each part of the hypotheses is looked at by itself", {.parts = 13, .share = 0.05},
      [] {
        NarrowCap n;
        auto& cap = n.cap;
        const std::size_t m = cap.rotations.size(), k = gen::any_place(m);
        auto& q = cap.rotations[k];
        const Rational excess = *gen::excess();
        std::string part;
        const std::size_t kind = gen::any_place(5);
        bool is_image = true;
        if (kind == 0) {
          part = gen::place(k, m) + " is behind the axis";
          q = -q;
        } else if (kind == 1) {
          part = gen::place(k, m) + " is outside the cap";
          const RationalQuaternion other = *gen::unit_quaternion();
          const Rational ratio = sq(dot(other, cap.axis)) / squared_norm(cap.axis);
          RC_PRE(ratio < cap.squared_cosine);
          q = dot(other, cap.axis) < 0 ? RationalQuaternion(-other) : other;
        } else if (kind == 2) {
          const auto broken = gen::broken_weights(n.weights);
          part = broken.part;
          n.weights = broken.weights;
        } else if (kind == 3) {
          part = "the blend is 0";
          q.setZero(), n.weights.assign(m, Rational(0)), n.weights[k] = 1;
          is_image = false;
        } else {
          part = "the axis is 0";
          cap.axis.setZero();
          is_image = false;
        }
        // By itself it is the same rotation: what is half-way to it is far off.
        if (kind == 0) {
          for (auto& w : n.weights) w /= 2;
          n.weights[k] += Rational(1, 2);
        }
        if (kind == 1 && *rc::gen::arbitrary<bool>()) n.weights.assign(m, Rational(0)), n.weights[k] = 1;
        if (squared_norm(combine<Rational, 4>(Span(n.weights), Span4(cap.rotations))) == 0) is_image = false;
        const Verdict hypothesis = cap_fallback_hypotheses(cap, Span(n.weights));
        // Without a blend or an axis there is no image or no ball.
        if (!is_image) return Weakening{part, hypothesis, {}};
        const RationalVec<3> x = *gen::nonzero_vector<3>();
        return Weakening{part, hypothesis, cap_fallback_encloses(cap, x, Span(n.weights), RationalVec<3>(0, 0, 0)).verdict};
      },
      1800);
}

void caps_have_the_balls_of_the_statement(Suite& t) {
  t.holds("a cap is valid if nothing is claimed, and at 1/2 nothing is", {.number_type = "rational", .cases = 300}, [] {
    const FallbackCase f(3);
    Fallback cap = f.cap;
    const Rational excess = *gen::excess();
    cap.axis.setZero();
    cap.squared_cosine = Rational(1, 2);
    RC_ASSERT(cap_is_valid(cap) == Verdict::holds && fallback_height(cap) == 0);
    const auto all = fallback_ball(cap, f.c.blend.x);
    RC_ASSERT(squared_norm(all.center) == 0 && all.squared_radius == squared_norm(f.c.blend.x));
    cap.squared_cosine += excess;
    RC_ASSERT(cap_is_valid(cap) == Verdict::fails);
    // Weight vertices that are all 0 are in every cap, even in one of a cosine that is none.
    for (auto& q : cap.rotations) q.setZero();
    cap.axis = *gen::nonzero_quaternion();
    cap.squared_cosine = 1;
    RC_ASSERT(cap_is_valid(cap) == Verdict::holds);
    cap.squared_cosine += excess;
    RC_ASSERT(cap_is_valid(cap) == Verdict::fails);
    cap.squared_cosine = Rational(1, 2) - Rational(excess / (1 + excess) / 2);
    RC_ASSERT(cap_is_valid(cap) == Verdict::holds && fallback_height(cap) == 0);
  });
  t.holds("the ball of a cap is about h R_c x and has the squared radius (1 - h^2) ||x||^2",
          {.number_type = "rational", .cases = 300}, [] {
            Fallback cap = NarrowCap().cap;
            cap.squared_cosine = *gen::unit_interval_rational();
            const RationalVec<3> x = *gen::rational_vector<3>(), zero(0, 0, 0);
            const Rational h = std::max<Rational>(2 * cap.squared_cosine - 1, Rational(0));
            RC_CLASSIFY(h > 0, "a cap");
            const RationalVec<3> center = oracle::times(oracle::affine_of(cap.axis, zero), x) * h;
            const auto ball = fallback_ball(cap, x);
            RC_ASSERT(fallback_height(cap) == h && ball.center == center && ball.squared_radius == (1 - h * h) * x.dot(x));
          });
}

void each_part_of_the_steps_is_checked(Suite& t) {
  t.holds("each part of the steps is checked by itself", {.number_type = "rational", .cases = 400}, [] {
    const NarrowCap n;
    Fallback cap = n.cap;
    if (*rc::gen::arbitrary<bool>()) cap.squared_cosine = Rational(1, 2);
    const Span u(n.weights);
    const RationalVec<3> x = *gen::nonzero_vector<3>(), offset = *gen::rational_vector<3>();
    const auto good = cap_fallback_encloses(cap, x, u, offset);
    RC_ASSERT(good.verdict == Verdict::holds);
    const auto rejected = [&](const Fallback& of, const FallbackSteps<Rational>& steps, Span w) {
      return is_fallback_steps(of, x, w, offset, steps) == Verdict::fails;
    };
    const Rational amount = *gen::excess();
    for (int i = 0; i < 3; ++i) {
      auto vertex = good, hull = good;
      vertex.vertex[i] += amount;
      hull.hull_point[i] += amount, hull.vertex[i] += amount;
      RC_ASSERT(rejected(cap, vertex, u) && rejected(cap, hull, u));
    }
    auto rests = good;  // This step of length 0 is short enough, but no rotation.
    rests.rotation_step.setZero(), rests.vertex = rests.hull_point + offset;
    if (squared_norm(good.rotation_step) > 0) RC_ASSERT(rejected(cap, rests, u));
    auto narrower = cap;  // All is right here, but for the length of the step.
    const Rational allowed = fallback_ball(cap, x).squared_radius;
    narrower.squared_cosine = 1;
    const auto steps = cap_fallback_encloses(narrower, x, u, offset);
    RC_ASSERT(steps.verdict == verdict_of(squared_norm(steps.rotation_step) == 0));
    RC_ASSERT(squared_norm(good.rotation_step) <= allowed);
    // The weights have another sum, with a hull point and a rotation that fit them.
    auto broken = n.weights;
    broken[0] += amount;
    const Rational sum = Rational(1) + amount;
    auto same = cap;
    for (auto& q : same.rotations) q = cap.axis;
    for (auto& r : same.center_images) r = cap.center_images[0];
    const RationalVec<3> turned = fallback_ball(same, x).center;
    FallbackSteps<Rational> scaled{
        Verdict::undecided, {}, RationalVec<3>((same.center_images[0] + turned) * sum), rotate_by(cap.axis, x) - turned};
    scaled.vertex = scaled.hull_point + scaled.rotation_step + offset;
    RC_ASSERT(rejected(same, scaled, Span(broken)));
  });
}

void narrow_caps_hold_every_vertex(Suite& t) {
  t.holds("a cap of less than all rotations holds every vertex, for weight vertices of any length",
          {.number_type = "rational", .cases = 300}, [] {
            const NarrowCap n;
            const Span u(n.weights);
            const RationalVec<3> x = *gen::rational_vector<3>(), offset = *gen::rational_vector<3>();
            RC_ASSERT(cap_fallback_hypotheses(n.cap, u) == Verdict::holds);
            const auto steps = cap_fallback_encloses(n.cap, x, u, offset);
            RC_ASSERT(steps.verdict == Verdict::holds);
            const RationalVec<3> image = steps.vertex - offset;
            RC_ASSERT(is_blended_image(SphericalBlend<Rational>{n.cap.rotations, n.cap.center_images, x}, u, image) ==
                      Verdict::holds);
          });
  reaches_share(t, "cases of several weight vertices, with a cap between the axis alone and all rotations", 0.7, [] {
    const NarrowCap n;
    return n.cap.squared_cosine > Rational(1, 2) && n.cap.squared_cosine < 1;
  });
}

void pinned_cases(Suite& t) {
  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const b4::Fallback& cap,
                                  const std::vector<b4::Q>& u) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      const Span weights(u);
      return cap_fallback_hypotheses(cap, weights) == Verdict::fails &&
             cap_fallback_encloses(cap, b4::x, weights, b4::no_offset).verdict == Verdict::fails;
    });
  };
  fails_without("kappa^2 bounds every weight vertex", "a cap without one of the weight vertices misses it", b4::too_narrow,
                b4::second);
  fails_without("no weight vertex is behind the axis", "half-way to a weight vertex behind the axis the blend leaves the cap",
                b4::behind, b4::halves);
  fails_without("the weights are convex", "beyond the weight vertices a blend leaves the cap", b4::fitting,
                b4::beyond_the_second);
}

PROPTEST(b4_cap_fallback) {
  vertices_are_in_the_hull_of_the_balls(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  caps_have_the_balls_of_the_statement(t);
  each_part_of_the_steps_is_checked(t);
  narrow_caps_hold_every_vertex(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b4_cap_fallback
