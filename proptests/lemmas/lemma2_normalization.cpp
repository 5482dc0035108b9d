#include "lemmas/lemma2_normalization.hpp"

#include "proptests/counterexamples/lemma2_normalization.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/hull.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/rotation.hpp"

namespace proptests {
namespace {

using namespace refitlab;

template <int D>
Vec<Rational, D> blend(const gen::ScaledHull<D>& hull) {
  return combine<Rational, D>(hull.weights, hull.vectors);
}

// The blend is 0 or one of the vectors, or there is but one.
template <int D>
bool is_degenerate(const gen::ScaledHull<D>& hull) {
  bool corner = false;
  for (const Rational& w : hull.weights) corner = corner || w == Rational(1);
  return corner || squared_norm(blend(hull)) == Rational(0);
}

const auto vanish_together = [](const auto& vectors, const auto& factors, const auto& weights) {
  return blends_vanish_together(vectors, factors, weights);
};
const auto keeps_rays = [](const auto& vectors, const auto& factors, const auto& weights) {
  return normalisation_keeps_rays_repaired(vectors, factors, weights);
};

PROPTEST(lemma2_normalization) {
  using namespace lemma2;
  t.example("blends that are 0 refute the printed statement", {.form = "printed"}, [] {
    return normalisation_keeps_rotations_printed(antipodal, ones, halves) == Verdict::fails &&
           normalisation_keeps_rotations_printed(three_around, three_ones, cancelling) == Verdict::fails &&
           normalisation_keeps_rotations_repaired(antipodal, ones, halves) == Verdict::holds &&
           normalisation_keeps_rays_repaired(antipodal, ones, halves) == Verdict::holds &&
           normalisation_keeps_rays_repaired(three_around, three_ones, cancelling) == Verdict::holds;
  });

  t.refuted(
      "every element of the hull is a rotation that the normalised hull has too",
      {.form = "printed", .number_type = "rational"}, [] {
        const auto hull = *gen::scaled_hull<4>().as("case");
        RC_ASSERT(normalisation_keeps_rotations_printed(hull.vectors, hull.lengths, hull.weights) == Verdict::holds);
      });

  t.holds(
      "every element of the hull that is not 0 is a rotation that the normalised hull has too",
      {.form = "repaired", .number_type = "rational", .cases = 3000, .degenerate_at_least = 0.2}, [] {
        const auto hull = *gen::scaled_hull<4>().as("case");
        RC_CLASSIFY(is_degenerate<4>(hull), "degenerate");
        RC_ASSERT(are_lengths(hull.vectors, hull.lengths) == Verdict::holds);
        RC_ASSERT(normalisation_keeps_rotations_repaired(hull.vectors, hull.lengths, hull.weights) == Verdict::holds);
        if (squared_norm(blend(hull)) == Rational(0)) return;
        const auto u = weights_on_same_ray(hull.weights, hull.lengths).weights;
        RC_ASSERT(rotate_alike(blend(hull), combine<Rational, 4>(u, divided(hull.vectors, hull.lengths))));
      });
  t.holds(
      "any positive factors keep the rays of the hull, and 0 if it is there, both ways",
      {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.2}, [] {
        gen::for_some_dimension<1, 4>([](auto d) {
          const auto hull = *gen::scaled_hull<d>().as("case");
          const auto factors =
              *rc::gen::container<std::vector<Rational>>(hull.vectors.size(), gen::positive_rational()).as("factors");
          RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
          RC_ASSERT(normalisation_keeps_rays_repaired(hull.vectors, factors, hull.weights) == Verdict::holds);
          RC_ASSERT(blends_vanish_together(hull.vectors, factors, hull.weights) == Verdict::holds);
          // The way back undoes the way there.
          const auto there = weights_on_same_ray(hull.weights, factors);
          const auto back = weights_on_same_ray(there.weights, inverses(factors));
          RC_ASSERT(back.weights == hull.weights);
          RC_ASSERT(there.scale * back.scale == Rational(1));
        });
      });
  t.holds("the same for vectors of any length, with roots",
          {.form = "repaired", .number_type = "exact root", .cases = 60}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const VecList<Rational, d> list{*gen::nonzero_vector<d>().as("first"),
                                              *gen::nonzero_vector<d>().as("second")};
              const auto vectors = lift<ExactRoot>(list);
              const auto weights = lift<ExactRoot>(*gen::convex_weights(2).as("weights"));
              const auto lengths = lengths_by_roots(vectors);
              RC_ASSERT(are_lengths(vectors, lengths) == Verdict::holds);
              RC_ASSERT(normalisation_keeps_rays_repaired(vectors, lengths, weights) == Verdict::holds);
            });
          });

  t.holds("intervals never contradict the exact verdict on the rays and on blends that are 0",
          {.number_type = "interval", .cases = 1500, .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto hull = *gen::scaled_hull<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
              hull.vectors[0][0] += *gen::nudge().as("nudge of a vector");
              decide_by_all(vanish_together, hull.vectors, hull.lengths, hull.weights);
            });
          });
  t.holds("intervals seldom decide the equality of rays, exact numbers always do",
          {.number_type = "interval", .cases = 300}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto hull = *gen::scaled_hull<d>().as("case");
              RC_ASSERT(decide_by_all(keeps_rays, hull.vectors, hull.lengths, hull.weights) == Verdict::holds);
            });
          });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.1}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto hull = *gen::scaled_hull<d>().as("case");
      RC_PRE(squared_norm(blend(hull)) != Rational(0));
      RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
      const auto to = divided<Rational, d>(hull.vectors, hull.lengths);
      const auto good = weights_on_same_ray(hull.weights, hull.lengths);
      RC_ASSERT(is_same_ray(hull.vectors, hull.weights, to, good) == Verdict::holds);
      const Rational amount = *gen::positive_rational().as("amount");
      const std::size_t m = good.weights.size(), k = *rc::gen::inRange<std::size_t>(0, m).as("index");
      auto bad = good;
      switch (*rc::gen::inRange(0, 6).as("mutation")) {
        case 0: bad.scale += amount; break;
        case 1: bad.scale = -bad.scale; break;
        case 2: bad.weights[k] += amount; break;
        case 3: bad.weights.push_back(Rational(0)); break;
        case 4:  // the same point by weights that are not convex
          for (auto& u : bad.weights) u *= Rational(1) + amount;
          bad.scale /= Rational(1) + amount;
          break;
        default:  // the sum of the weights is kept
          RC_PRE(m > 1 && to[k] != to[(k + 1) % m]);
          bad.weights[k] += amount;
          bad.weights[(k + 1) % m] -= amount;
      }
      RC_ASSERT(is_same_ray(hull.vectors, hull.weights, to, bad) == Verdict::fails);
    });
  });

  t.example("a negative factor leads to another ray", {.form = "repaired", .hypothesis = "the factors are positive"},
            [] {
              const auto made = weights_on_same_ray(halves, one_negative);
              return are_positive(one_negative) == Verdict::fails && made.verdict == Verdict::fails &&
                     is_same_ray(right_angle, halves, divided(right_angle, one_negative), made) == Verdict::fails;
            });
  t.example("a zero vector has no direction", {.form = "repaired", .hypothesis = "the vectors are not 0"}, [] {
    bool none = are_lengths(with_zero, zero_and_one) == Verdict::fails;
    for (int k = 0; k <= 4; ++k) {
      const Weights u{Q(4 - k, 4), Q(k, 4)};
      none = none && is_same_ray(stand_in, only_first, with_zero, {Verdict::holds, u, Q(1)}) == Verdict::fails &&
             are_same_rotation(i, combine<Q, 4>(u, with_zero)) == Verdict::fails;
    }
    return Checked(none, 5);
  });
  t.example("weights that are not convex have no convex counterpart", {.form = "repaired", .hypothesis = "w is in W_m"},
            [] {
              const auto made = weights_on_same_ray(not_convex, ones);
              return is_convex<Q>(not_convex) == Verdict::fails && made.verdict == Verdict::fails &&
                     is_same_ray(right_angle, not_convex, right_angle, made) == Verdict::fails;
            });
}

}  // namespace
}  // namespace proptests
