#include "lemmas/b5_rotation_axis.hpp"

#include "proptests/counterexamples/b5_rotation_axis.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Span = std::span<const Rational>;

// Up to four corners that turn about one axis, a cap about the sum of them (or about one) where there is one, and
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

PROPTEST(b5_rotation_axis) {
  t.holds(
      "on a twist a point keeps its part along the axis, and its ball has the radius of the part across",
      {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
        const Twist w;
        RC_PRE(w.applies());
        RC_CLASSIFY(w.is_degenerate(), "degenerate");
        const auto found = twist_keeps_axis<Rational>(w.axis, w.cap, w.x, w.weights);
        RC_ASSERT(found.verdict == Verdict::holds);
        RC_ASSERT(is_twisted_point<Rational>(w.axis, w.cap, w.x, w.weights, found) == Verdict::holds);
        // Smaller than the paper's ball by ||p||^2 / ||x||^2, squared.
        const auto tight = twist_ball(w.cap, found.parts), loose = fallback_ball(w.cap, w.x);
        RC_ASSERT(tight.squared_radius * squared_norm(w.x) == loose.squared_radius * squared_norm(found.parts.across));
      });
  t.holds("so do the control points",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1}, [] {
            const Twist w;
            const auto p = w.about_axis(), q = w.about_axis();
            RC_CLASSIFY(w.is_degenerate() || p == q, "degenerate");
            RC_ASSERT(turns_about(w.axis, p) == Verdict::holds);
            RC_ASSERT(control_points_keep_axis(w.axis, p, q, w.x) == Verdict::holds);
            const RationalVec<3> on_axis = w.axis * *gen::rational();
            const RationalVec<3> control = mixed_rotation(p, q, on_axis), expected = on_axis * dot(p, q);
            RC_ASSERT(control == expected);
          });
  t.example("a point of the axis rests, and the paper's ball for it has the radius 24/25", {.form = "beyond"}, [] {
    const Span u(b5::halves);
    const auto found = twist_keeps_axis(b5::x_axis, b5::twist, b5::x_axis, u);
    return found.verdict == Verdict::holds && found.rotated == b5::x_axis &&
           twist_ball(b5::twist, found.parts).squared_radius == 0 &&
           fallback_ball(b5::twist, b5::x_axis).squared_radius == b5::Q(576, 625);
  });

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
    split.parts.along += bump, split.parts.across -= bump;  // consistent, but not along and across
    sum.parts.across += bump;
    image.rotated += bump;
    RC_ASSERT(rejected(split) && rejected(sum) && rejected(image));
  });

  t.example("with rotations about two axes no axis is kept",
            {.form = "beyond", .hypothesis = "all turn about one axis"}, [] {
              const Span u(b5::halves);
              return twist_hypotheses(b5::x_axis, b5::two_axes, u) == Verdict::fails &&
                     twist_keeps_axis(b5::x_axis, b5::two_axes, b5::x_axis, u).verdict == Verdict::fails;
            });
}

}  // namespace
}  // namespace proptests
