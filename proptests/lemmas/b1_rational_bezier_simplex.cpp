// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b1_rational_bezier_simplex.hpp"

#include "proptests/counterexamples/b1_rational_bezier_simplex.hpp"
#include "proptests/gen/blend_simplex.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_b1_rational_bezier_simplex {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Weights = std::vector<Rational>;
using Transforms = std::vector<RigidTransform<Rational>>;

Quaternion<Rational> dual_part(const RigidTransform<Rational>& c) {
  const auto& t = c.translation;
  return multiply(Quaternion<Rational>(0, t[0], t[1], t[2]), c.rotation) / Rational(2);
}

// Returns the blend whose weight vertices are those of the whole simplex of weights: the joints themselves.
SphericalBlend<Rational> spherical_of(const Transforms& joints, const RationalVec<3>& center, const RationalVec<3>& v) {
  SphericalBlend<Rational> blend{{}, {}, v - center};
  for (const auto& c : joints) blend.rotations.push_back(c.rotation), blend.center_images.push_back(apply(c, center));
  return blend;
}
DualQuaternionBlend<Rational> dual_of(const Transforms& joints, const RationalVec<3>& v) {
  DualQuaternionBlend<Rational> blend{{}, {}, v};
  for (const auto& c : joints) blend.rotations.push_back(c.rotation), blend.duals.push_back(dual_part(c));
  return blend;
}
LinearBlend<Rational> linear_of(const Transforms& joints, const RationalVec<3>& v) {
  LinearBlend<Rational> blend;
  for (const auto& c : joints) blend.images.push_back(apply(c, v));
  return blend;
}

// Returns the vertex by dual quaternion skinning as in Kavan et al. 2008, Algorithm 1: v + 2 d x (d x v + a v) + 2 (a e - b d + d
// x e) for the normalised blend (a, d) + eps (b, e).
RationalVec<3> dual_quaternion_skinning(const Transforms& joints, const Weights& w, const RationalVec<3>& v) {
  Quaternion<Rational> q(0, 0, 0, 0), e(0, 0, 0, 0);
  for (std::size_t i = 0; i < w.size(); ++i) q += joints[i].rotation * w[i], e += dual_part(joints[i]) * w[i];
  const RationalVec<3> d(q[1], q[2], q[3]), moved(e[1], e[2], e[3]);
  const RationalVec<3> inner = d.cross(v) + v * q[0];
  const RationalVec<3> turned = d.cross(inner);
  const RationalVec<3> shift = moved * q[0] - d * e[0] + d.cross(moved);
  const Rational scale = Rational(2) / squared_norm(q);
  return v + (turned + shift) * scale;
}

template <class Blend>
void assert_simplex(const Blend& blend, const Weights& u) {
  RC_ASSERT(bezier_simplex_hypotheses<Rational>(u) == Verdict::holds);
  const auto simplex = bezier_simplex(blend, std::span<const Rational>(u));
  RC_ASSERT(simplex.verdict == Verdict::holds);
  RC_ASSERT(is_bezier_simplex(blend, simplex.points) == Verdict::holds);
}

template <class Blend>
void assert_rejected(const Blend& blend) {
  auto points = control_points(blend);
  auto& p = points[*rc::gen::inRange<std::size_t>(0, points.size())];
  const Rational amount = *gen::positive_rational();
  if (*rc::gen::arbitrary<bool>()) p.numerator[*rc::gen::inRange(0, 3)] += amount;
  else p.weight -= amount;
  RC_ASSERT(is_bezier_simplex(blend, points) == Verdict::fails);
}

// Asserts that control points with any number of any of them changed, up or down, or with another multi-index, are no Bezier
// simplex of the blend. At weights that are all positive each control point counts, so there the verdict is false too.
template <class Blend>
void assert_each_field_checked(const Blend& blend, const Weights& u) {
  const auto good = control_points(blend);
  const Rational amount = *gen::excess() * (*rc::gen::arbitrary<bool>() ? 1 : -1);
  const bool all_count = std::all_of(u.begin(), u.end(), [](const Rational& x) { return x > 0; });
  const auto reject = [&](const std::vector<ControlPoint<Rational>>& points) {
    RC_ASSERT(is_bezier_simplex(blend, points) == Verdict::fails);
    if (all_count) RC_ASSERT((agrees_at<Blend, Rational>(blend, points, u) == Verdict::fails));
  };
  for (std::size_t k = 0; k < good.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      auto points = good;
      points[k].numerator[i] += amount;
      reject(points);
    }
    auto points = good;
    points[k].weight += amount;
    reject(points);
    if (good[k].weight == 0) continue;
    points = good;
    points.erase(points.begin() + static_cast<long>(k));
    reject(points);
    if (blend.weight_vertex_count() < 2) continue;
    points = good;
    points[k].index.back() = (points[k].index.back() + 1) % blend.weight_vertex_count();
    RC_ASSERT(is_bezier_simplex(blend, points) == Verdict::fails);
  }
}

void blends_are_bezier_simplices(Suite& t) {
  t.holds("W_kl, P_kl and Im(d q*) as they are computed are those of the products of quaternions that define them",
          {.number_type = "rational", .cases = 300}, [] {
            const auto a = *gen::rational_vector<4>(), b = *gen::rational_vector<4>();
            const auto x = *gen::rational_vector<3>();
            const RationalQuaternion pure(0, x[0], x[1], x[2]);
            const RationalQuaternion both = oracle::hamilton(oracle::hamilton(a, pure), conjugate(b)) +
                                            oracle::hamilton(oracle::hamilton(b, pure), conjugate(a));
            const MixedPair<Rational> mixed = mix_rotations<Rational>(a, b, x);
            RC_ASSERT(mixed.weight == dot(a, b));
            RC_ASSERT(mixed.numerator * Rational(2) == imaginary(both));
            RC_ASSERT(scaled_translation<Rational>(a, b) == imaginary(oracle::hamilton<Rational>(a, conjugate(b))));
          });
  const Options exact{.form = "beyond", .number_type = "rational", .cases = 400, .degenerate_at_least = 0.2};
  t.holds("spherical blending is a rational Bezier simplex of degree 3 in the weights", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    assert_simplex(c.blend, c.weights);
    assert_simplex(c.blend, *gen::affine_weights(static_cast<int>(c.weights.size())));
  });
  t.holds("dual quaternion blending is one of degree 2, linear blending one of degree 1", exact, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    RC_CLASSIFY(c.is_degenerate(), "degenerate");
    const auto duals = *rc::gen::container<std::vector<gen::RationalQuaternion>>(c.weights.size(), gen::nonzero_quaternion());
    assert_simplex(DualQuaternionBlend<Rational>{c.blend.rotations, duals, c.blend.x}, c.weights);
    assert_simplex(LinearBlend<Rational>{c.blend.center_images}, c.weights);
  });
  t.holds("over the joints of a skin the simplices are what the skinnings make of a vertex", exact, [] {
    const Transforms joints = *gen::rigid_transforms(1, 4);
    const auto v = *gen::rational_vector<3>(), center = *gen::rational_vector<3>();
    const Weights w = *gen::convex_weights(static_cast<int>(joints.size()));
    RC_CLASSIFY(joints.size() == 1 || v == center || joints[0].rotation == joints.back().rotation, "degenerate");
    const std::span<const Rational> u(w);
    RC_ASSERT(is_blended_image(linear_of(joints, v), u, oracle::linear(joints, w, v)) == Verdict::holds);
    const auto spherical = spherical_of(joints, center, v);
    if (blend_has_image(spherical, u) != Verdict::holds) return;
    RC_ASSERT(is_blended_image(spherical, u, oracle::spherical(joints, w, center, v)) == Verdict::holds);
    RC_ASSERT(is_blended_image(dual_of(joints, v), u, dual_quaternion_skinning(joints, w, v)) == Verdict::holds);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 3);
    auto wrong = c.weights;
    wrong[0] += *gen::rational();
    const auto statement = []<class S>(const std::vector<Quaternion<S>>& q, const std::vector<Vec<S, 3>>& r, const Vec<S, 3>& x,
                                       const std::vector<S>& u) {
      return bezier_simplex(SphericalBlend<S>{q, r, x}, std::span<const S>(u)).verdict;
    };
    for (const auto& u : {c.weights, wrong}) decide_by_all(statement, c.blend.rotations, c.blend.center_images, c.blend.x, u);
  });

  t.holds("a mutated control point is rejected", {.number_type = "rational", .cases = 400}, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    assert_rejected(c.blend);
    assert_rejected(DualQuaternionBlend<Rational>{c.blend.rotations, c.blend.rotations, c.blend.x});
    assert_rejected(LinearBlend<Rational>{c.blend.center_images});
  });
}

void indices_are_those_of_the_power_of_a_sum(Suite& t) {
  t.holds("multi-indices are all sorted lists, and their Bernstein polynomials the terms of the power of the sum",
          {.number_type = "rational", .cases = 60}, [] {
            const std::size_t m = 1 + gen::any_place(4);
            const int degree = *rc::gen::inRange(0, 5);
            const Weights u = *rc::gen::container<Weights>(m, gen::rational());
            // It counts through all ordered lists.
            std::map<std::vector<std::size_t>, Rational> terms;
            std::vector<std::size_t> digits(static_cast<std::size_t>(degree), 0);
            for (bool more = true; more;) {
              auto sorted = digits;
              std::sort(sorted.begin(), sorted.end());
              Rational product(1);
              for (const std::size_t k : digits) product *= u[k];
              terms[sorted] += product;
              more = false;
              for (auto& digit : digits) {
                if (++digit < m) {
                  more = true;
                  break;
                }
                digit = 0;
              }
            }
            std::size_t visited = 0;
            for_each_index(m, degree, [&](const std::vector<std::size_t>& index) {
              ++visited;
              RC_ASSERT(terms.count(index) == 1u);
              RC_ASSERT(bernstein<Rational>(index, u) == terms.at(index));
            });
            RC_ASSERT(visited == terms.size());
          });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(
      t, "weights of another sum are refused, and spherical blending tells them apart", {.parts = 6, .share = 0.5},
      [] {
        const auto c = *gen::blend_case(gen::Spread::any, 4);
        auto u = *gen::affine_weights(static_cast<int>(c.weights.size()));
        RC_ASSERT(bezier_simplex_hypotheses<Rational>(u) == Verdict::holds);
        const std::size_t k = gen::any_place(u.size());
        const Rational amount = *gen::excess();
        const bool more = *rc::gen::arbitrary<bool>();
        u[k] += more ? amount : Rational(-amount);
        return Weakening{gen::place(k, u.size()) + (more ? " is too much" : " is too little"),
                         bezier_simplex_hypotheses<Rational>(u), bezier_simplex(c.blend, std::span<const Rational>(u)).verdict};
      },
      600);
  t.holds("a blend that is 0 has no image, and any other has one", {.number_type = "rational", .cases = 300}, [] {
    auto c = *gen::blend_case(gen::Spread::any, 4);
    // One more weight vertex takes the others back: half of each is 0, or what is left over.
    const bool vanishes = *rc::gen::arbitrary<bool>();
    const RationalQuaternion left = *gen::nonzero_quaternion() * *gen::excess();
    for (auto& x : c.weights) x /= 2;
    c.weights.push_back(Rational(1, 2));
    RationalQuaternion sum(0, 0, 0, 0);
    for (std::size_t k = 0; k + 1 < c.weights.size(); ++k) sum += c.blend.rotations[k] * c.weights[k];
    c.blend.rotations.push_back(RationalQuaternion(sum * Rational(-2)) + (vanishes ? RationalQuaternion(0, 0, 0, 0) : left));
    c.blend.center_images.push_back(RationalVec<3>(0, 0, 0));
    const std::span<const Rational> u(c.weights);
    RC_ASSERT(blend_has_image(c.blend, u) == verdict_of(!vanishes));
    const DualQuaternionBlend<Rational> dual{c.blend.rotations, c.blend.rotations, c.blend.x};
    RC_ASSERT(blend_has_image(dual, u) == verdict_of(!vanishes));
  });
}

void each_part_of_a_witness_is_checked(Suite& t) {
  t.holds("an image that is wrong in one coordinate is rejected", {.number_type = "rational", .cases = 200}, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 4);
    const std::span<const Rational> u(c.weights);
    RC_PRE(blend_has_image(c.blend, u) == Verdict::holds);
    const auto only_right_one = [&](const auto& blend) {
      const auto at = blend.at(u);
      const RationalVec<3> image = at.numerator / at.denominator;
      RC_ASSERT(is_blended_image(blend, u, image) == Verdict::holds);
      for (int i = 0; i < 3; ++i) {
        RationalVec<3> wrong = image;
        wrong[i] += *gen::excess() * (*rc::gen::arbitrary<bool>() ? 1 : -1);
        RC_ASSERT(is_blended_image(blend, u, wrong) == Verdict::fails);
      }
    };
    only_right_one(c.blend);
    only_right_one(DualQuaternionBlend<Rational>{c.blend.rotations, c.blend.rotations, c.blend.x});
    only_right_one(LinearBlend<Rational>{c.blend.center_images});
  });
  t.holds("each field of each control point is checked", {.number_type = "rational", .cases = 60}, [] {
    const auto c = *gen::blend_case(gen::Spread::any, 3);
    assert_each_field_checked(c.blend, c.weights);
    assert_each_field_checked(DualQuaternionBlend<Rational>{c.blend.rotations, c.blend.rotations, c.blend.x}, c.weights);
    assert_each_field_checked(LinearBlend<Rational>{c.blend.center_images}, c.weights);
  });
}

void pinned_cases(Suite& t) {
  t.example("with weights that do not sum to 1 the parts are scaled apart",
            {.form = "beyond", .hypothesis = "the weights sum to 1"}, [] {
              return bezier_simplex_hypotheses<Rational>(b1::twice) == Verdict::fails &&
                     bezier_simplex(b1::moved, std::span<const Rational>(b1::twice)).verdict == Verdict::fails;
            });
  t.example("where the blend is 0 every point is an image", {.form = "beyond", .hypothesis = "the blend is not 0"}, [] {
    const std::span<const Rational> u(b1::halves);
    return blend_has_image(b1::cancelling, u) == Verdict::fails &&
           is_blended_image(b1::cancelling, u, b1::here) == Verdict::holds &&
           is_blended_image(b1::cancelling, u, b1::elsewhere) == Verdict::holds;
  });
}

PROPTEST(b1_rational_bezier_simplex) {
  blends_are_bezier_simplices(t);
  verdicts_and_witnesses_are_checked(t);
  indices_are_those_of_the_power_of_a_sum(t);
  hypotheses_need_each_part(t);
  each_part_of_a_witness_is_checked(t);
  reaches_share(t, "cases of several weight vertices that differ, with none at a right angle or 0", 0.25,
                [] { return !(*gen::blend_case(gen::Spread::any, 4)).is_degenerate(); });
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b1_rational_bezier_simplex
