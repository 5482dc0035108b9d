#include "lemmas/b3_subdivision.hpp"

#include <cmath>
#include <cstdio>

#include "proptests/counterexamples/b3_subdivision.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using Span = std::span<const Rational>;
using Blend = SphericalBlend<Rational>;

Half any_edge(const Blend& blend) {
  const auto m = blend.corner_count();
  const auto k = *rc::gen::inRange<std::size_t>(0, m), step = *rc::gen::inRange<std::size_t>(1, m);
  return {k, (k + step) % m};
}

std::vector<std::size_t> any_index(std::size_t m) {
  auto index = *rc::gen::container<std::vector<std::size_t>>(3, rc::gen::inRange<std::size_t>(0, m));
  std::sort(index.begin(), index.end());
  return index;
}

// The least sizes there are, with rational bounds.
SimplexSizes<Rational> sizes_of(const Blend& blend) {
  Rational s(0), t(0), b(0);
  for (std::size_t k = 0; k < blend.corner_count(); ++k) {
    b = std::max<Rational>(b, squared_norm(blend.rotations[k]));
    for (std::size_t l = 0; l < k; ++l) {
      s = std::max<Rational>(s, squared_distance(blend.rotations[k], blend.rotations[l]));
      t = std::max<Rational>(t, squared_distance(blend.center_images[k], blend.center_images[l]));
    }
  }
  return {upper_root(s), upper_root(t), upper_root(b), upper_root(squared_norm(blend.x))};
}

// The largest distance of a control point to the surface at the mean of its corners.
double largest_distance(const SphericalBlend<double>& blend) {
  double largest = 0;
  for (const auto& p : control_points(blend)) {
    const auto u = middle_weights<double>(p.index, blend.corner_count());
    const auto at = blend.at(u);
    largest = std::max(largest, (p.numerator / p.weight - at.numerator / at.denominator).norm());
  }
  return largest;
}

PROPTEST(b3_subdivision) {
  const Options exact{.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2};
  t.holds("both halves together hold every blend of the whole, and no other", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    RC_PRE(c.blend.corner_count() > 1);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const Half half = any_edge(c.blend);
    const Span u(c.weights);
    RC_ASSERT(halving_hypotheses(c.blend, half, u) == Verdict::holds);
    const auto found = halves_cover(c.blend, half.kept, half.replaced, u);
    RC_ASSERT(found.verdict == Verdict::holds);
    RC_ASSERT(is_half_point(c.blend, u, found) == Verdict::holds);
    const auto back = half_in_whole(c.blend, half, u);
    RC_ASSERT(back.verdict == Verdict::holds);
    RC_ASSERT(is_convex<Rational>(back.coefficients) == Verdict::holds);
    RC_ASSERT(is_same_blend<Rational>(c.blend, back.coefficients, half_of(c.blend, half), u) == Verdict::holds);
  });
  Options rarer = exact;
  rarer.degenerate_at_least = 0.08;
  t.holds("the control hull of a half encloses its part, and is inside the hull of the whole", rarer, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    RC_PRE(c.blend.corner_count() > 1);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const Half edge = any_edge(c.blend);
    const auto found = halves_cover<Rational>(c.blend, edge.kept, edge.replaced, c.weights);
    const Blend half = half_of(c.blend, found.half);
    RC_ASSERT(pairs_are_positive(half.rotations) == Verdict::holds);
    const auto in_half = image_in_control_hull(half, Span(found.coefficients));
    RC_ASSERT(in_half.verdict == Verdict::holds);
    RC_ASSERT(is_blended_image(c.blend, Span(c.weights), in_half.image) == Verdict::holds);
    const auto inside = half_control_point_in_hull(c.blend, found.half, any_index(half.corner_count()));
    RC_ASSERT(inside.verdict == Verdict::holds);
    RC_ASSERT((is_hull_point<Rational, 3>(positions(control_points(c.blend)), inside.image, inside.coefficients) ==
               Verdict::holds));
  });
  t.holds("a control point is as near to the surface as the square of the sizes", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    const auto index = any_index(c.blend.corner_count());
    RC_PRE(blend_has_image(c.blend, Span(middle_weights<Rational>(index, c.blend.corner_count()))) == Verdict::holds);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const auto sizes = sizes_of(c.blend);
    RC_ASSERT(sizes_bound(c.blend, sizes) == Verdict::holds);
    const auto near = control_point_is_near(c.blend, index, sizes);
    RC_ASSERT(near.verdict == Verdict::holds);
    RC_ASSERT(is_control_point_distance(c.blend, index, sizes, near) == Verdict::holds);
    const SimplexSizes<Rational> half{sizes.rotation_spread / 2, sizes.center_spread / 2, sizes.rotation_length,
                                      sizes.arm};
    RC_ASSERT(distance_bound(half) * 4 <= distance_bound(sizes));
  });
  t.holds("halving the longest edge leaves new edges of at most sqrt(3)/2 of it", rarer, [] {
    const auto q = *gen::unit_quaternions(3, 3);
    auto a = q[0], b = q[1], c = q[2];
    if (squared_distance(a, b) < squared_distance(a, c)) std::swap(b, c);
    if (squared_distance(a, b) < squared_distance(b, c)) std::swap(a, c);
    RC_CLASSIFY(a == b || a == c || b == c, "degenerate");
    RC_ASSERT(new_edge_is_shorter(a, b, c) == Verdict::holds);
    const RationalQuaternion middle = (a + b) / Rational(2);
    RC_ASSERT(4 * squared_distance(middle, c) <= 3 * squared_distance(a, b));
  });
  t.holds("a dot product is positive if and only if the middle is longer than half the edge", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 2);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    RC_ASSERT(positive_if_middle_is_long(c.blend.rotations.front(), c.blend.rotations.back()) == Verdict::holds);
  });
  t.holds("one halving makes both parts positive for unit quaternions that do not cancel",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.1}, [] {
            const auto q = *gen::unit_quaternions(2, 2);
            RC_PRE(equal_lengths_hypotheses(q[0], q[1]) == Verdict::holds);
            RC_CLASSIFY(dot(q[0], q[1]) == 0 || q[0] == q[1], "degenerate");
            RC_CLASSIFY(dot(q[0], q[1]) < 0, "negative before");
            const auto found = halving_makes_positive(q[0], q[1]);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_positive_halves(q[0], q[1], found) == Verdict::holds);
          });
  t.example(
      "measured: each halving of all edges takes the control points four times nearer", {.number_type = "double"}, [] {
        SphericalBlend<double> blend{{{1, 0, 0, 0}, {0.6, 0.8, 0, 0}}, {{0, 0, 0}, {0.3, -0.2, 0.1}}, {0.4, 1, 0.2}};
        std::string text = "distances";
        double last = 0, worst = 4;
        for (int halvings = 0; halvings <= 6; ++halvings) {
          const double distance = largest_distance(blend);
          char number[32];
          std::snprintf(number, sizeof number, " %.2e", distance);
          text += number;
          if (halvings > 1) worst = std::min(worst, last / distance);
          last = distance;
          blend =
              SphericalBlend<double>{{blend.rotations[0], (blend.rotations[0] + blend.rotations[1]) / 2},
                                     {blend.center_images[0], (blend.center_images[0] + blend.center_images[1]) / 2},
                                     blend.x};
        }
        return Checked(worst > 3, 7, text);
      });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 150}, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 3);
    RC_PRE(c.blend.corner_count() > 1);
    const Half half = any_edge(c.blend);
    const auto index = any_index(c.blend.corner_count());
    const auto sizes = sizes_of(c.blend);
    const std::vector<Rational> all{sizes.rotation_spread, sizes.center_spread, sizes.rotation_length, sizes.arm};
    decide_by_all(
        [&]<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Vec<S, 3>& x,
                     const std::vector<S>& u) {
          return halves_cover<S>({q, r, x}, half.kept, half.replaced, u).verdict;
        },
        c.blend.rotations, c.blend.center_images, c.blend.x, c.weights);
    if (blend_has_image(c.blend, Span(middle_weights<Rational>(index, c.blend.corner_count()))) == Verdict::holds)
      decide_by_all(
          [&]<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Vec<S, 3>& x,
                       const std::vector<S>& s) {
            return control_point_is_near<S>({q, r, x}, index, {s[0], s[1], s[2], s[3]}).verdict;
          },
          c.blend.rotations, c.blend.center_images, c.blend.x, all);
    decide_by_all(
        []<class S>(const Quaternion<S>& p, const Quaternion<S>& q) { return halving_makes_positive<S>(p, q).verdict; },
        c.blend.rotations[0], c.blend.rotations[1]);
  });

  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 300}, [] {
    const auto c = *gen::blend_case(gen::Spread::positive, 4);
    RC_PRE(c.blend.corner_count() > 1);
    const Half edge = any_edge(c.blend);
    const Rational amount = *gen::positive_rational();
    auto half = halves_cover<Rational>(c.blend, edge.kept, edge.replaced, c.weights);
    half.coefficients[*rc::gen::inRange<std::size_t>(0, half.coefficients.size())] += amount;
    RC_ASSERT(is_half_point<Rational>(c.blend, c.weights, half) == Verdict::fails);
    // The same quaternions, with the images of another rotation center.
    auto other_center = c.blend;
    for (auto& r : other_center.center_images) r[*rc::gen::inRange(0, 3)] += amount;
    RC_ASSERT(is_same_blend<Rational>(c.blend, c.weights, c.blend, c.weights) == Verdict::holds);
    RC_ASSERT(is_same_blend<Rational>(c.blend, c.weights, other_center, c.weights) == Verdict::fails);

    const auto index = any_index(c.blend.corner_count());
    const auto sizes = sizes_of(c.blend);
    const auto good = control_point_is_near(c.blend, index, sizes);
    auto moved = good, elsewhere = good;
    moved.scaled_gap[*rc::gen::inRange(0, 3)] += amount;
    elsewhere.weights[0] -= amount;
    RC_ASSERT(is_control_point_distance(c.blend, index, sizes, moved) == Verdict::fails);
    RC_ASSERT(is_control_point_distance(c.blend, index, sizes, elsewhere) == Verdict::fails);

    auto q = *gen::unit_quaternions(2, 2);
    RC_PRE(equal_lengths_hypotheses(q[0], q[1]) == Verdict::holds);
    auto longer = halving_makes_positive(q[0], q[1]), other = longer;
    longer.squared_length += amount;
    other.middle[*rc::gen::inRange(0, 4)] -= amount;
    RC_ASSERT(is_positive_halves(q[0], q[1], longer) == Verdict::fails);
    RC_ASSERT(is_positive_halves(q[0], q[1], other) == Verdict::fails);
  });

  t.example("a blend beyond the corners is in no half", {.form = "beyond", .hypothesis = "the weights are convex"}, [] {
    const Span u(b3::beyond_the_first);
    return halving_hypotheses(b3::edge, {0, 1}, u) == Verdict::fails &&
           halves_cover(b3::edge, 0, 1, u).verdict == Verdict::fails;
  });
  t.example("an edge has two ends", {.form = "beyond", .hypothesis = "k and l are different"}, [] {
    const Span u(b3::halves);
    return halving_hypotheses(b3::edge, {0, 0}, u) == Verdict::fails &&
           halves_cover(b3::edge, 0, 0, u).verdict == Verdict::fails;
  });
  t.example("with sizes that are too small the control points are farther off",
            {.form = "beyond", .hypothesis = "s and t bound the edges"}, [] {
              return sizes_bound(b3::edge, b3::no_size) == Verdict::fails &&
                     control_point_is_near(b3::edge, b3::first_twice, b3::no_size).verdict == Verdict::fails;
            });
  t.example("halving another edge than the longest may make a longer one",
            {.form = "beyond", .hypothesis = "the edge is the longest"}, [] {
              const b3::Rotation middle = (b3::a + b3::close_to_a) / b3::Q(2);
              return 4 * squared_distance(middle, b3::far_from_a) > 3 * squared_distance(b3::a, b3::close_to_a);
            });
  t.example("of a short and a long quaternion the middle may stay behind one",
            {.form = "beyond", .hypothesis = "both have one length"}, [] {
              return equal_lengths_hypotheses(b3::small, b3::large) == Verdict::fails &&
                     halving_makes_positive(b3::small, b3::large).verdict == Verdict::fails;
            });
  t.example("where the blend vanishes no halving helps", {.form = "beyond", .hypothesis = "the blend is not 0"}, [] {
    return equal_lengths_hypotheses(b3::one, b3::minus_one) == Verdict::fails &&
           halving_makes_positive(b3::one, b3::minus_one).verdict == Verdict::fails;
  });
}

}  // namespace
}  // namespace proptests
