#include "lemmas/b4_cap_fallback.hpp"

#include "lemmas/b2_control_hull_encloses.hpp"
#include "lemmas/s44_sum_of_bounds.hpp"
#include "proptests/counterexamples/b4_cap_fallback.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Span = std::span<const Rational>;
using Fallback = CapFallback<Rational>;

// The best cap about the sum of the corners, about one of them or about any axis; where there is none, all rotations.
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

PROPTEST(b4_cap_fallback) {
  t.holds("the hull of the cap's balls holds every vertex, whatever the signs of the dot products",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
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
          {.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2}, [] {
            const FallbackCase f(4);
            RC_PRE(f.applies());
            RC_CLASSIFY(f.c.is_degenerate() || f.radius == 0, "degenerate");
            const auto steps = cap_fallback_encloses(f.cap, f.c.blend.x, f.u(), f.offset);
            const auto turned = fallback_ball(f.cap, f.c.blend.x);
            const PartBounds<Rational> bounds{
                f.cap.center_images, {turned.center, upper_root(turned.squared_radius)}, f.radius};
            const RationalVec<3> center = *gen::rational_vector<3>();
            Rational farthest(0);
            for (const auto& r : f.cap.center_images)
              farthest = std::max<Rational>(farthest, squared_distance<Rational, 3>(r + turned.center, center));
            const Ball3<Rational> ball{center, upper_root(farthest) + bounds.spherical.radius};
            RC_ASSERT(encloses_equal_balls(ball, bounds) == Verdict::holds);
            RC_ASSERT(encloses(inflate(ball, f.radius), steps.vertex) == Verdict::holds);
          });
  t.holds("where all dot products are at least 0 the cap about the sum of the corners is there",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.15}, [] {
            const auto c = *gen::blend_case(*rc::gen::element(gen::Spread::any, gen::Spread::positive), 4);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(positive_pairs_are_ahead(c.blend.rotations) == Verdict::holds);
          });
  t.example("the cap reaches corners that the control hull does not: dot products below 0, ahead of a common axis",
            {.form = "beyond"}, [] {
              return less(dot(b4::wide_pair[0], b4::wide_pair[1]), b4::Q(0)) == Verdict::holds &&
                     are_ahead<b4::Q>(b4::wide_pair, b4::identity) == Verdict::holds;
            });
  t.example("a control point of degree 2 leaves the cap's ball beyond a right angle between the rotations, not before",
            {.form = "beyond"}, [] {
              const auto inside = [](const std::vector<b4::Rotation>& q) {
                const b4::Fallback cap{q, b4::at_origin, b4::identity, squared_cap_cosine<b4::Q>(q, b4::identity)};
                const b4::Point control = mixed_rotation(q[0], q[1], b4::x) / dot(q[0], q[1]);
                return encloses(fallback_ball(cap, b4::x), control);
              };
              return inside(b4::below_a_right_angle) == Verdict::holds &&
                     inside(b4::beyond_a_right_angle) == Verdict::fails;
            });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const FallbackCase f(3);
    RC_PRE(squared_norm(combine<Rational, 4>(f.u(), f.cap.rotations)) > 0);
    auto wrong = f.cap;  // a cap that may be too narrow
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
    hull.hull_point += bump, hull.vertex += bump;     // consistent, but off the hull point of u
    step.rotation_step += bump, step.vertex += bump;  // consistent, but no rotation of x by the blend
    RC_ASSERT(rejected(vertex) && rejected(hull) && rejected(step));
  });

  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence, const b4::Fallback& cap,
                                  const std::vector<b4::Q>& u) {
    t.example(sentence, {.form = "beyond", .hypothesis = hypothesis}, [&] {
      const Span weights(u);
      return cap_fallback_hypotheses(cap, weights) == Verdict::fails &&
             cap_fallback_encloses(cap, b4::x, weights, b4::no_offset).verdict == Verdict::fails;
    });
  };
  fails_without("kappa^2 bounds every corner", "a cap without one of the corners misses it", b4::too_narrow,
                b4::second);
  fails_without("no corner is behind the axis", "half-way to a corner behind the axis the blend leaves the cap",
                b4::behind, b4::halves);
  fails_without("the weights are convex", "beyond the corners a blend leaves the cap", b4::fitting,
                b4::beyond_the_second);
}

}  // namespace
}  // namespace proptests
