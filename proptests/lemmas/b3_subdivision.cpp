// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b3_subdivision.hpp"

#include <cstdio>

#include "proptests/counterexamples/b3_subdivision.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_b3_subdivision {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using Span = std::span<const Rational>;
using Blend = SphericalBlend<Rational>;

// Draws a blend of at least two weight vertices.
gen::BlendCase with_an_edge(gen::Spread spread, int most) {
  auto c = *gen::blend_case(spread, most);
  RC_PRE(c.blend.weight_vertex_count() > 1);
  return c;
}

Half any_edge(const Blend& blend) {
  const auto m = blend.weight_vertex_count();
  const auto k = *rc::gen::inRange<std::size_t>(0, m), step = *rc::gen::inRange<std::size_t>(1, m);
  return {k, (k + step) % m};
}

std::vector<std::size_t> any_index(std::size_t m) {
  auto index = *rc::gen::container<std::vector<std::size_t>>(3, rc::gen::inRange<std::size_t>(0, m));
  std::sort(index.begin(), index.end());
  return index;
}

// Returns the least sizes there are, with rational bounds.
SimplexSizes<Rational> sizes_of(const Blend& blend) {
  Rational s(0), t(0), b(0);
  for (std::size_t k = 0; k < blend.weight_vertex_count(); ++k) {
    b = std::max<Rational>(b, squared_norm(blend.rotations[k]));
    for (std::size_t l = 0; l < k; ++l) {
      s = std::max<Rational>(s, squared_distance(blend.rotations[k], blend.rotations[l]));
      t = std::max<Rational>(t, squared_distance(blend.center_images[k], blend.center_images[l]));
    }
  }
  return {upper_root(s), upper_root(t), upper_root(b), upper_root(squared_norm(blend.x))};
}

// Returns the largest distance of a control point to the surface at the mean of its weight vertices.
double largest_distance(const SphericalBlend<double>& blend) {
  double largest = 0;
  for (const auto& p : control_points(blend)) {
    const auto u = middle_weights<double>(p.index, blend.weight_vertex_count());
    const auto at = blend.at(u);
    largest = std::max(largest, (p.numerator / p.weight - at.numerator / at.denominator).norm());
  }
  return largest;
}

const Options exact{.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2};
const Options rarely_degenerate{.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.08};

void halves_cover_the_whole(Suite& t) {
  t.holds("both halves together hold every blend of the whole, and no other", exact, [] {
    const auto c = with_an_edge(gen::Spread::any, 4);
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
  t.holds("the control hull of a half encloses its part, and is inside the hull of the whole", rarely_degenerate, [] {
    const auto c = with_an_edge(gen::Spread::positive, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const Half edge = any_edge(c.blend);
    const auto found = halves_cover<Rational>(c.blend, edge.kept, edge.replaced, c.weights);
    const Blend half = half_of(c.blend, found.half);
    RC_ASSERT(pairs_are_positive(half.rotations) == Verdict::holds);
    const auto in_half = image_in_control_hull(half, Span(found.coefficients));
    RC_ASSERT(in_half.verdict == Verdict::holds);
    RC_ASSERT(is_blended_image(c.blend, Span(c.weights), in_half.image) == Verdict::holds);
    const auto inside = half_control_point_in_hull(c.blend, found.half, any_index(half.weight_vertex_count()));
    RC_ASSERT(inside.verdict == Verdict::holds);
    RC_ASSERT(
        (is_hull_point<Rational, 3>(positions(control_points(c.blend)), inside.image, inside.coefficients) == Verdict::holds));
  });
}

void halving_brings_nearer_and_makes_positive(Suite& t) {
  t.holds("a control point is as near to the surface as the square of the sizes", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    const auto index = any_index(c.blend.weight_vertex_count());
    RC_PRE(blend_has_image(c.blend, Span(middle_weights<Rational>(index, c.blend.weight_vertex_count()))) == Verdict::holds);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const auto sizes = sizes_of(c.blend);
    RC_ASSERT(sizes_bound(c.blend, sizes) == Verdict::holds);
    const auto near = control_point_is_near(c.blend, index, sizes);
    RC_ASSERT(near.verdict == Verdict::holds);
    RC_ASSERT(is_control_point_distance(c.blend, index, sizes, near) == Verdict::holds);
    const SimplexSizes<Rational> half{sizes.rotation_spread / 2, sizes.center_spread / 2, sizes.rotation_length, sizes.arm};
    RC_ASSERT(distance_bound(half) * 4 <= distance_bound(sizes));
  });
  t.holds("halving the longest edge leaves new edges of at most sqrt(3)/2 of it", rarely_degenerate, [] {
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
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.06}, [] {
            const auto q = *gen::unit_quaternions(2, 2);
            RC_PRE(equal_lengths_hypotheses(q[0], q[1]) == Verdict::holds);
            RC_CLASSIFY(dot(q[0], q[1]) == 0 || q[0] == q[1], "degenerate");
            RC_CLASSIFY(dot(q[0], q[1]) < 0, "negative before");
            const auto found = halving_makes_positive(q[0], q[1]);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_positive_halves(q[0], q[1], found) == Verdict::holds);
          });
  t.example("measured: each halving of all edges takes the control points four times nearer", {.number_type = "double"}, [] {
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
      blend = SphericalBlend<double>{{blend.rotations[0], (blend.rotations[0] + blend.rotations[1]) / 2},
                                     {blend.center_images[0], (blend.center_images[0] + blend.center_images[1]) / 2},
                                     blend.x};
    }
    return Checked(worst > 3, 7, text);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 150}, [] {
    const auto c = with_an_edge(gen::Spread::any, 3);
    const Half half = any_edge(c.blend);
    const auto index = any_index(c.blend.weight_vertex_count());
    const auto sizes = sizes_of(c.blend);
    const std::vector<Rational> all{sizes.rotation_spread, sizes.center_spread, sizes.rotation_length, sizes.arm};
    decide_by_all(
        [&]<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Vec<S, 3>& x,
                     const std::vector<S>& u) {
          return halves_cover<S>({q, r, x}, half.kept, half.replaced, u).verdict;
        },
        c.blend.rotations, c.blend.center_images, c.blend.x, c.weights);
    if (blend_has_image(c.blend, Span(middle_weights<Rational>(index, c.blend.weight_vertex_count()))) == Verdict::holds)
      decide_by_all(
          [&]<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Vec<S, 3>& x,
                       const std::vector<S>& s) {
            return control_point_is_near<S>({q, r, x}, index, {s[0], s[1], s[2], s[3]}).verdict;
          },
          c.blend.rotations, c.blend.center_images, c.blend.x, all);
    decide_by_all([]<class S>(const Quaternion<S>& p, const Quaternion<S>& q) { return halving_makes_positive<S>(p, q).verdict; },
                  c.blend.rotations[0], c.blend.rotations[1]);
  });

  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 300}, [] {
    const auto c = with_an_edge(gen::Spread::positive, 4);
    const Half edge = any_edge(c.blend);
    const Rational amount = *gen::positive_rational();
    auto half = halves_cover<Rational>(c.blend, edge.kept, edge.replaced, c.weights);
    half.coefficients[*rc::gen::inRange<std::size_t>(0, half.coefficients.size())] += amount;
    RC_ASSERT(is_half_point<Rational>(c.blend, c.weights, half) == Verdict::fails);
    // This has the same quaternions, with the images of another rotation center.
    auto other_center = c.blend;
    for (auto& r : other_center.center_images) r[*rc::gen::inRange(0, 3)] += amount;
    RC_ASSERT(is_same_blend<Rational>(c.blend, c.weights, c.blend, c.weights) == Verdict::holds);
    RC_ASSERT(is_same_blend<Rational>(c.blend, c.weights, other_center, c.weights) == Verdict::fails);

    const auto index = any_index(c.blend.weight_vertex_count());
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
}

void halves_need_each_part(Suite& t) {
  t.holds("what is no half of an edge is refused", {.number_type = "rational", .cases = 300}, [] {
    const auto c = with_an_edge(gen::Spread::any, 4);
    const std::size_t m = c.blend.weight_vertex_count();
    const Half half = any_edge(c.blend);
    const auto refused = [&](const Half& h, const std::vector<Rational>& u) {
      return halving_hypotheses(c.blend, h, Span(u)) == Verdict::fails;
    };
    RC_ASSERT(refused({m, half.replaced}, c.weights) && refused({half.kept, m}, c.weights) &&
              refused({half.kept, half.kept}, c.weights));
    auto longer = c.weights, shorter = *gen::convex_weights(static_cast<int>(m) - 1);
    longer.push_back(Rational(0));
    RC_ASSERT(refused(half, longer) && refused(half, shorter));
    const auto broken = gen::broken_weights(c.weights).weights;
    RC_ASSERT(refused(half, broken));
    RC_ASSERT(is_same_blend<Rational>(c.blend, longer, c.blend, c.weights) == Verdict::fails);
    RC_ASSERT(is_same_blend<Rational>(c.blend, c.weights, c.blend, shorter) == Verdict::fails);
  });
  needs_each_part(
      t, "weights that are not convex are in no half", {.parts = 5, .share = 0.3},
      [] {
        const auto c = with_an_edge(gen::Spread::any, 4);
        const Half half = any_edge(c.blend);
        const auto broken = gen::broken_weights(c.weights);
        return Weakening{broken.part, halving_hypotheses(c.blend, half, Span(broken.weights)),
                         halves_cover<Rational>(c.blend, half.kept, half.replaced, broken.weights).verdict};
      },
      400);
  t.holds("a half has the middle in place of one end, and the rest as it was", {.number_type = "rational", .cases = 200}, [] {
    const auto c = with_an_edge(gen::Spread::any, 4);
    const Half edge = any_edge(c.blend);
    const Blend half = half_of(c.blend, edge);
    RC_ASSERT(half.x == c.blend.x && half.weight_vertex_count() == c.blend.weight_vertex_count());
    for (std::size_t i = 0; i < half.weight_vertex_count(); ++i) {
      const std::size_t other = i == edge.replaced ? edge.kept : i;
      RC_ASSERT(half.rotations[i] * Rational(2) == c.blend.rotations[i] + c.blend.rotations[other]);
      RC_ASSERT(half.center_images[i] * Rational(2) == c.blend.center_images[i] + c.blend.center_images[other]);
    }
    // The weights are mapped in both directions, each by itself.
    const auto back = half_in_whole<Rational>(c.blend, edge, c.weights);
    for (std::size_t i = 0; i < half.weight_vertex_count(); ++i) {
      const Rational share = c.weights[edge.replaced] / 2;
      RC_ASSERT(back.coefficients[i] == (i == edge.kept       ? Rational(c.weights[i] + share)
                                         : i == edge.replaced ? share
                                                              : c.weights[i]));
    }
  });
}

void blends_and_hull_points_are_compared_part_by_part(Suite& t) {
  t.holds("blends that differ in one coordinate are not the same", {.number_type = "rational", .cases = 200}, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    const Rational amount = *gen::excess();
    const auto differs = [&](const Blend& other) {
      return is_same_blend<Rational>(c.blend, c.weights, other, c.weights) == Verdict::fails &&
             is_same_blend<Rational>(other, c.weights, c.blend, c.weights) == Verdict::fails;
    };
    for (int i = 0; i < 4; ++i) {
      auto turned = c.blend, moved = c.blend, arm = c.blend;
      for (auto& q : turned.rotations) q[i] += amount;
      RC_ASSERT(differs(turned));
      if (i == 3) continue;
      for (auto& r : moved.center_images) r[i] += amount;
      arm.x[i] += amount;
      RC_ASSERT(differs(moved) && differs(arm));
    }
  });
  t.holds("weights of weight vertices that count for nothing must be convex too", {.number_type = "rational", .cases = 200}, [] {
    auto c = with_an_edge(gen::Spread::any, 3);
    const Half edge = any_edge(c.blend);
    for (int i = 0; i < 2; ++i) {
      c.blend.rotations.push_back(RationalQuaternion(0, 0, 0, 0)), c.blend.center_images.push_back(gen::RationalVec<3>(0, 0, 0));
      c.weights.push_back(Rational(0));
    }
    const auto good = halves_cover<Rational>(c.blend, edge.kept, edge.replaced, c.weights);
    const Rational amount = *gen::excess();
    auto sum = good, sign = good;
    sum.coefficients.back() += amount;
    sign.coefficients.back() += amount, sign.coefficients[sign.coefficients.size() - 2] -= amount;
    RC_ASSERT(good.verdict == Verdict::holds);
    RC_ASSERT(is_half_point<Rational>(c.blend, c.weights, sum) == Verdict::fails);
    RC_ASSERT(is_half_point<Rational>(c.blend, c.weights, sign) == Verdict::fails);
    RC_ASSERT(half_in_whole<Rational>(c.blend, edge, sum.coefficients).verdict == Verdict::fails);
    RC_ASSERT(half_in_whole<Rational>(c.blend, edge, sign.coefficients).verdict == Verdict::fails);
  });
  t.holds("whether a half's control point is in the hull is what the check of a hull point says",
          {.number_type = "rational", .cases = 400}, [] {
            const auto c = with_an_edge(gen::Spread::any, 3);
            const Half edge = any_edge(c.blend);
            const auto index = any_index(c.blend.weight_vertex_count());
            const auto whole = control_points(c.blend);
            for (const auto& p : whole) RC_PRE(p.weight != 0);
            RC_PRE(half_of(c.blend, edge).control_point(index).weight != 0);
            const auto found = half_control_point_in_hull(c.blend, edge, index);
            bool convex = true;
            Rational sum(0);
            gen::RationalVec<3> combined(0, 0, 0);
            for (std::size_t i = 0; i < whole.size(); ++i) {
              convex = convex && found.coefficients[i] >= 0;
              sum += found.coefficients[i];
              combined += whole[i].numerator * Rational(found.coefficients[i] / whole[i].weight);
            }
            RC_CLASSIFY(!convex, "a coefficient is negative");
            RC_ASSERT(sum == Rational(1) && combined == found.image);
            RC_ASSERT(found.verdict == verdict_of(convex));
          });
}

void sizes_need_each_part(Suite& t) {
  needs_each_part(
      t, "each size of each weight vertex and each edge is looked at, and each sign", {.parts = 14, .share = 0.02},
      [] {
        auto c = *gen::blend_case(gen::Spread::any, 3);
        // All weight vertices are equal but one, or one pair about the third, and the sizes fit the others and the rest.
        auto& q = c.blend.rotations;
        auto& r = c.blend.center_images;
        q.assign(3, *gen::nonzero_quaternion()), r.assign(3, r[0]);
        const std::size_t k = gen::any_place(3);
        const RationalQuaternion step = *gen::nonzero_quaternion();
        const gen::RationalVec<3> move = *gen::nonzero_vector<3>();
        const std::size_t kind = gen::any_place(8);
        q[k] += step;
        if (kind != 0) r[k] += move;
        // Then nothing but the centers makes a gap.
        if (kind == 1) c.blend.x.setZero();
        const std::size_t l = (k + 1) % 3;
        const std::string pair = gen::place(std::min(k, l), 3) + " and " + gen::place(std::max(k, l), 3);
        if (kind == 0) q[l] -= step;
        if (kind == 1) r[l] -= move;
        auto sizes = sizes_of(c.blend);
        const Rational less = Rational(999, 1000);
        std::string part;
        if (kind == 0) sizes.rotation_spread = upper_root(squared_norm(step)), part = pair + " of the rotations";
        if (kind == 1) sizes.center_spread = upper_root(squared_norm(move)), part = pair + " of the centers";
        if (kind == 2) {
          RationalQuaternion longest = q[0];
          for (const auto& p : q) longest = squared_norm(p) > squared_norm(longest) ? p : longest;
          q.assign(3, RationalQuaternion(longest / Rational(2)));
          q[k] = longest, sizes = sizes_of(c.blend), sizes.rotation_length *= less, part = "the length of " + gen::place(k, 3);
        }
        if (kind == 3) {
          if (squared_norm(c.blend.x) == 0) c.blend.x[0] = 1;
          sizes = sizes_of(c.blend), sizes.arm *= less, part = "the arm";
        }
        if (kind == 4) sizes.rotation_spread *= -1, part = "the sign of the rotations' spread";
        if (kind == 5) sizes.center_spread *= -1, part = "the sign of the centers' spread";
        if (kind == 6) sizes.rotation_length *= -1, part = "the sign of the length";
        if (kind == 7) {
          if (squared_norm(c.blend.x) == 0) c.blend.x[0] = 1;
          sizes = sizes_of(c.blend), sizes.arm *= -1, part = "the sign of the arm";
        }
        // The theorem is not sharp: what falls short of it is shown with a hundredth of the size.
        auto smaller = sizes;
        if (kind == 0) smaller.rotation_spread /= 100;
        if (kind == 1) smaller.center_spread /= 100;
        const auto index = any_index(3);
        RC_PRE(blend_has_image(c.blend, Span(middle_weights<Rational>(index, 3))) == Verdict::holds);
        // Where a length or an arm is negative, or a single one is too large, the other terms may compensate for it.
        const bool is_needed = kind < 2;
        return Weakening{part, sizes_bound(c.blend, sizes),
                         is_needed ? std::optional(control_point_is_near(c.blend, index, smaller).verdict) : std::nullopt};
      },
      1500);
  t.holds("the sizes are bounds up to their edge, and the bound of the distance is its formula",
          {.number_type = "rational", .cases = 200}, [] {
            // Along one axis all lengths are rational.
            const Rational a = *gen::rational(), b = *gen::rational(), p = *gen::rational(), q = *gen::rational(),
                           x = *gen::rational();
            const Blend blend{{{a, 0, 0, 0}, {b, 0, 0, 0}}, {{0, p, 0}, {0, q, 0}}, {0, 0, x}};
            const auto absolute = [](const Rational& y) { return y < 0 ? Rational(-y) : y; };
            const SimplexSizes<Rational> sizes{absolute(a - b), absolute(p - q), std::max<Rational>(absolute(a), absolute(b)),
                                               absolute(x)};
            RC_ASSERT(sizes_bound(blend, sizes) == Verdict::holds);
            const auto& [s, t, length, arm] = sizes;
            RC_ASSERT(distance_bound(sizes) * 15 == 5 * arm * s * s + 5 * length * s * t + 3 * s * s * t);
            const auto index = any_index(4);
            const auto u = middle_weights<Rational>(index, 4);
            for (std::size_t k = 0; k < 4; ++k)
              RC_ASSERT(u.at(k) * 3 == Rational(static_cast<int>(std::count(index.begin(), index.end(), k))));
          });
}

void control_points_are_near_in_each_part(Suite& t) {
  t.holds("each part of what is said of a control point is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    auto c = with_an_edge(gen::Spread::positive, 3);
    const std::size_t m = c.blend.weight_vertex_count();
    const auto index = any_index(m);
    const auto sizes = sizes_of(c.blend);
    const Rational amount = *gen::excess();
    const auto witness_at = [&](const std::vector<Rational>& u) {
      const auto point = c.blend.control_point(index);
      const auto at = c.blend.at(u);
      RC_PRE(at.denominator != 0);
      return ControlPointDistance<Rational>{Verdict::undecided, u,
                                            point.numerator - at.numerator * Rational(point.weight / at.denominator)};
    };
    // These sizes are so large that the bounds hold of anything.
    const SimplexSizes<Rational> loose{Rational(1000000000), Rational(1000000000), Rational(1000000000), Rational(1000000000)};
    auto good = witness_at(middle_weights<Rational>(index, m));
    RC_ASSERT(is_control_point_distance(c.blend, index, loose, good) == Verdict::holds);
    for (int i = 0; i < 3; ++i) {
      auto wrong = good;
      wrong.scaled_gap[i] += amount;
      RC_ASSERT(is_control_point_distance(c.blend, index, loose, wrong) == Verdict::fails);
    }
    const auto broken = gen::broken_weights(good.weights).weights;
    RC_PRE(blend_has_image(c.blend, Span(broken)) == Verdict::holds);
    RC_ASSERT(is_control_point_distance(c.blend, index, loose, witness_at(broken)) == Verdict::fails);
    // The gap alone is too long: the weight's part knows only the rotations' spread.
    auto tight = sizes;
    tight.center_spread = 0, tight.arm = 0;
    if (squared_norm(good.scaled_gap) > 0) RC_ASSERT(is_control_point_distance(c.blend, index, tight, good) == Verdict::fails);
    // There is no gap at all, and only the weight is too small for a spread of 0.
    c.blend.x.setZero();
    for (auto& r : c.blend.center_images) r.setZero();
    auto point = sizes_of(c.blend);
    point.rotation_spread = 0;
    const auto at = c.blend.at(good.weights);
    const auto verdict = is_control_point_distance(c.blend, index, point, witness_at(good.weights));
    RC_ASSERT(verdict == verdict_of(at.denominator <= c.blend.control_point(index).weight));
  });
}

void new_edges_and_middles_need_each_part(Suite& t) {
  t.holds("of a new edge only what is said of the longest is said", {.number_type = "rational", .cases = 600}, [] {
    auto q = *gen::unit_quaternions(3, 3);
    for (auto& p : q) p *= *rc::gen::element(Rational(1), Rational(1, 10), Rational(3));
    const RationalQuaternion ab = q[0] - q[1], ac = q[0] - q[2], bc = q[1] - q[2], m = (ac + bc) / Rational(2);
    const bool first = ac.dot(ac) <= ab.dot(ab), second = bc.dot(bc) <= ab.dot(ab), shorter = 4 * m.dot(m) <= 3 * ab.dot(ab);
    RC_CLASSIFY(first && !second && !shorter, "only b c is longer, and the new edge too long");
    RC_CLASSIFY(!first && second && !shorter, "only a c is longer, and the new edge too long");
    RC_ASSERT(new_edge_is_shorter(q[0], q[1], q[2]) == verdict_of(!(first && second) || shorter));
  });
  needs_each_part(
      t, "the middle is in front of both ends only if they have one length and do not cancel", {.parts = 3, .share = 0.08},
      [] {
        const auto q = *gen::unit_quaternions(2, 2);
        RationalQuaternion p = q[0], r = q[1];
        const std::size_t kind = gen::any_place(3);
        const Rational factor = *rc::gen::element(Rational(5), Rational(2), Rational(1001, 1000));
        if (kind == 0) p *= factor;
        else if (kind == 1) r *= factor;
        else r = -p;
        if (kind < 2) RC_PRE(p != RationalQuaternion(-r));
        const Weakening asked{kind == 0   ? "the first is longer"
                              : kind == 1 ? "the second is longer"
                                          : "they cancel",
                              equal_lengths_hypotheses(p, r), halving_makes_positive(p, r).verdict};
        const bool has_room = kind < 2 && factor == Rational(1001, 1000);
        return has_room ? Weakening{asked.part, asked.hypothesis, {}} : asked;
      },
      900);
  t.holds("the verdict of the halves is that of both ends, and each part of the witness is checked",
          {.number_type = "rational", .cases = 600}, [] {
            const auto q = *gen::unit_quaternions(2, 2);
            const RationalQuaternion p = q[0] * *gen::positive_rational(), r = q[1] * *gen::positive_rational(),
                                     middle = (p + r) / Rational(2);
            const Rational at_p = p.dot(middle), at_r = r.dot(middle), length = middle.dot(middle);
            RC_CLASSIFY(at_p <= 0 && at_r > 0, "only the first is behind");
            RC_CLASSIFY(at_r <= 0 && at_p > 0, "only the second is behind");
            const auto found = halving_makes_positive(p, r);
            RC_ASSERT(found.verdict == verdict_of(at_p > 0 && at_r > 0));
            RC_ASSERT(found.middle == middle && found.squared_length == length);
            for (const Rational& claimed : {at_p, at_r, length}) {
              const bool right = claimed > 0 && claimed == at_p && claimed == at_r;
              RC_ASSERT(is_positive_halves(p, r, {Verdict::holds, middle, claimed}) == verdict_of(right));
            }
          });
  t.holds("a middle that is wrong across both ends is rejected, and one of length 0", {.number_type = "rational", .cases = 50},
          [] {
            // Two are in a coordinate plane, and what is changed is perpendicular to both.
            const bool low = *rc::gen::arbitrary<bool>();
            const auto in_plane = [&](const Rational& a, const Rational& b) {
              return low ? RationalQuaternion(a, b, 0, 0) : RationalQuaternion(0, 0, a, b);
            };
            const auto p = in_plane(1, 0), r = in_plane(Rational(3, 5), Rational(4, 5));
            const auto good = halving_makes_positive(p, r);
            RC_ASSERT(is_positive_halves(p, r, good) == Verdict::holds);
            for (int i = low ? 2 : 0; i < (low ? 4 : 2); ++i) {
              auto wrong = good;
              wrong.middle[i] += *gen::excess();
              RC_ASSERT(is_positive_halves(p, r, wrong) == Verdict::fails);
            }
            const RationalQuaternion opposite = -p;
            RC_ASSERT(is_positive_halves(p, opposite, halving_makes_positive(p, opposite)) == Verdict::fails);
          });
}

void pinned_cases(Suite& t) {
  t.example("the widest edge has two ends, where a weight vertex is 0, too", {}, [] {
    const RationalQuaternion zero(0, 0, 0, 0), a(1, 0, 0, 0), b(Rational(3, 5), Rational(4, 5), 0, 0);
    bool ok = true;
    for (const std::vector<RationalQuaternion>& q : {std::vector{zero, a}, {a, zero}, {zero, a, b}, {a, b, zero}, {zero, zero}}) {
      const auto edge = widest_edge<Rational>(q.size(), [&](std::size_t k, std::size_t l) { return dot(q[k], q[l]); });
      ok = ok && edge.first < q.size() && edge.second < edge.first;
    }
    return Checked(ok, 5);
  });
  t.example("a blend beyond the weight vertices is in no half", {.form = "beyond", .hypothesis = "the weights are convex"}, [] {
    const Span u(b3::beyond_the_first);
    return halving_hypotheses(b3::edge, {0, 1}, u) == Verdict::fails && halves_cover(b3::edge, 0, 1, u).verdict == Verdict::fails;
  });
  t.example("an edge has two ends", {.form = "beyond", .hypothesis = "k and l are different"}, [] {
    const Span u(b3::halves);
    return halving_hypotheses(b3::edge, {0, 0}, u) == Verdict::fails && halves_cover(b3::edge, 0, 0, u).verdict == Verdict::fails;
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

PROPTEST(b3_subdivision) {
  halves_cover_the_whole(t);
  halving_brings_nearer_and_makes_positive(t);
  verdicts_and_witnesses_are_checked(t);
  halves_need_each_part(t);
  blends_and_hull_points_are_compared_part_by_part(t);
  sizes_need_each_part(t);
  control_points_are_near_in_each_part(t);
  new_edges_and_middles_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b3_subdivision
