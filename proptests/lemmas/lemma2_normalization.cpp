// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/lemma2_normalization.hpp"

#include "proptests/counterexamples/lemma2_normalization.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/hull.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/rotation.hpp"

namespace proptests::suite_lemma2_normalization {
namespace {

using namespace refitlab;

template <int D>
Vec<Rational, D> blend(const gen::ScaledHull<D>& hull) {
  return combine<Rational, D>(hull.weights, hull.vectors);
}

// Says whether the blend is 0 or one of the vectors, or there is but one.
template <int D>
bool is_degenerate(const gen::ScaledHull<D>& hull) {
  bool weight_vertex = false;
  for (const Rational& w : hull.weights) weight_vertex = weight_vertex || w == Rational(1);
  return weight_vertex || squared_norm(blend(hull)) == Rational(0);
}

const auto vanish_together = [](const auto& vectors, const auto& factors, const auto& weights) {
  return blends_vanish_together(vectors, factors, weights);
};
const auto keeps_rays = [](const auto& vectors, const auto& factors, const auto& weights) {
  return normalisation_keeps_rays_repaired(vectors, factors, weights);
};

// Draws three or four vectors, so that there is an element between the first and the last.
template <int D>
gen::ScaledHull<D> hull_of_several() {
  gen::ScaledHull<D> hull{*gen::sphere_points<D>(3, 4).as("units"), {}, {}};
  const std::size_t m = hull.vectors.size();
  hull.lengths = *rc::gen::container<std::vector<Rational>>(m, gen::positive_rational()).as("lengths");
  hull.weights = *gen::convex_weights(static_cast<int>(m)).as("weights");
  for (std::size_t i = 0; i < m; ++i) hull.vectors[i] *= hull.lengths[i];
  return hull;
}

void hypotheses_need_each_part(Suite& t) {
  needs_part_in<1, 4>(t, "one of the factors is negative, the others are positive", [](auto d) {
    const auto hull = hull_of_several<d>();
    auto factors = hull.lengths;
    RC_ASSERT(are_positive(factors) == Verdict::holds);
    const auto k = *rc::gen::inRange<std::size_t>(0, factors.size()).as("which");
    factors[k] = -factors[k];
    Rational scale(0);
    for (std::size_t i = 0; i < factors.size(); ++i) scale += hull.weights[i] * factors[i];
    RC_PRE(scale != Rational(0));
    RC_ASSERT(normalisation_keeps_rays_repaired(hull.vectors, factors, hull.weights) == Verdict::holds);
    const auto made = weights_on_same_ray(hull.weights, factors);
    const auto check = is_same_ray(hull.vectors, hull.weights, divided(hull.vectors, factors), made);
    RC_ASSERT(check == made.verdict);
    return Weakening{are_positive(factors), made.verdict};
  });
  t.holds("one factor that is 0, wherever it stands, is refused", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto hull = *gen::scaled_hull<d>().as("case");
      auto factors = hull.lengths;
      factors[*rc::gen::inRange<std::size_t>(0, factors.size()).as("which")] = 0;
      RC_ASSERT(are_positive(factors) == Verdict::fails);
      RC_ASSERT(are_lengths(hull.vectors, factors) == Verdict::fails);
      auto vectors = hull.vectors;
      for (std::size_t i = 0; i < factors.size(); ++i) vectors[i] *= factors[i] / hull.lengths[i];
      RC_ASSERT(are_lengths(vectors, factors) == Verdict::fails);
      RC_ASSERT(normalisation_keeps_rays_repaired(vectors, factors, hull.weights) == Verdict::holds);
      RC_ASSERT(normalisation_keeps_rotations_printed(vectors, factors, hull.weights) == Verdict::holds);
    });
  });
  needs_part_in<1, 4>(t, "one of the numbers is not the length of its vector: longer, shorter, or of the other sign", [](auto d) {
    const auto hull = hull_of_several<d>();
    auto lengths = hull.lengths;
    const auto k = *rc::gen::inRange<std::size_t>(0, lengths.size()).as("which");
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    const int kind = *rc::gen::inRange(0, 3).as("kind");
    lengths[k] = kind == 0 ? Rational(lengths[k] * factor) : kind == 1 ? Rational(lengths[k] / factor) : Rational(-lengths[k]);
    // The lengths are to make the divided vectors units.
    const auto units = divided(hull.vectors, lengths);
    return Weakening{are_lengths(hull.vectors, lengths), are_positive(lengths) & equal(squared_norm(units[k]), Rational(1))};
  });
  needs_part_in<1, 4>(t, "the weights are convex", [](auto d) {
    const auto hull = hull_of_several<d>();
    auto weights = hull.weights;
    const auto k = *rc::gen::inRange<std::size_t>(0, weights.size()).as("which"), next = (k + 1) % weights.size();
    const Rational amount = *gen::positive_rational().as("amount");
    const bool keeps_sum = *rc::gen::arbitrary<bool>().as("keeps the sum");
    if (keeps_sum) weights[next] += weights[k] + amount, weights[k] = -amount;
    if (!keeps_sum) weights[k] += amount;
    Rational scale(0), back(0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      scale += weights[i] * hull.lengths[i];
      back += weights[i] / hull.lengths[i];
    }
    RC_PRE(scale != Rational(0) && back != Rational(0));
    RC_ASSERT(normalisation_keeps_rays_repaired(hull.vectors, hull.lengths, weights) == Verdict::holds);
    RC_ASSERT(normalisation_keeps_rotations_printed(hull.vectors, hull.lengths, weights) == Verdict::holds);
    const auto made = weights_on_same_ray(weights, hull.lengths);
    // The sum of the weights need not be 1 for a ray; a negative weight leaves it.
    RC_ASSERT(made.verdict == verdict_of(!keeps_sum));
    return Weakening{is_convex<Rational>(weights), made.verdict};
  });
  t.holds("nothing is claimed of a blend that is 0 if the numbers are no lengths, or the weights not convex",
          {.number_type = "rational"}, [] {
            const auto q = *gen::nonzero_vector<4>().as("vector");
            const Rational squared = squared_norm(q), amount = *gen::positive_rational().as("amount");
            RC_PRE(amount * amount != squared);
            const VecList<Rational, 4> pair{q, -q};
            const std::vector<Rational> no_lengths{amount, amount}, halves{Rational(1, 2), Rational(1, 2)}, twos{2, 2};
            RC_ASSERT(normalisation_keeps_rotations_printed(pair, no_lengths, halves) == Verdict::holds);
            const auto unit = *gen::sphere_point<4>().as("unit");
            const VecList<Rational, 4> units{unit, -unit};
            RC_ASSERT(normalisation_keeps_rotations_printed(units, {1, 1}, halves) == Verdict::fails);
            RC_ASSERT(normalisation_keeps_rotations_printed(units, {1, 1}, twos) == Verdict::holds);
            RC_ASSERT(normalisation_keeps_rotations_repaired(units, {1, 1}, halves) == Verdict::holds);
          });
}

// Checks statements with intervals that cannot decide one part alone. In exact numbers a true statement could lose that part
// unseen.
void undecided_parts_are_not_lost(Suite& t) {
  t.example("what an interval cannot decide of one way between the hulls, it cannot decide of both", {}, [] {
    const auto verdict = [](const std::vector<Rational>& vectors, const std::vector<Rational>& factors,
                            const std::vector<Rational>& weights) {
      VecList<Interval, 1> list;
      for (const Rational& x : vectors) list.push_back(Vec<Interval, 1>(lift<Interval>(x)));
      return normalisation_keeps_rays_repaired(list, lift<Interval>(factors), lift<Interval>(weights));
    };
    const std::vector<Rational> quarters{Rational(1, 4), Rational(3, 4)}, several{Rational(1, 2), Rational(1, 4), Rational(1, 4)};
    return verdict({1, 1}, {1, 1}, quarters) == Verdict::holds &&
           verdict({3, 1}, {3, 1}, quarters) == Verdict::undecided &&                  // 1/3 on the way back
           verdict({1, 1, 1}, {2, Rational(1, 2), 1}, several) == Verdict::undecided;  // 11/8 on the way there
  });
  t.example("a blend that is certainly not 0 and one that may be do not vanish together for certain", {}, [] {
    const Interval half(0.5), wide(0.1, 10);
    const VecList<Interval, 1> vectors{Vec<Interval, 1>(Interval(2)), Vec<Interval, 1>(Interval(-1))};
    return blends_vanish_together<Interval, 1>(vectors, {wide, wide}, {half, half}) == Verdict::undecided;
  });
}

void weights_of_a_ray_need_each_part(Suite& t) {
  t.holds("the weights of a ray are good if and only if their sum and all of them have the right sign",
          {.number_type = "rational"}, [] {
            const auto weights = *rc::gen::container<std::vector<Rational>>(4, gen::rational()).as("weights");
            const auto factors = *rc::gen::container<std::vector<Rational>>(4, gen::positive_rational()).as("factors");
            Rational scale(0);
            bool none_negative = true, none_positive = true;
            for (std::size_t i = 0; i < 4; ++i) {
              scale += weights[i] * factors[i];
              none_negative = none_negative && weights[i] >= Rational(0);
              none_positive = none_positive && weights[i] <= Rational(0);
            }
            RC_PRE(scale != Rational(0));
            RC_CLASSIFY(none_negative || none_positive, "of one sign");
            const auto made = weights_on_same_ray(weights, factors);
            RC_ASSERT(made.scale == scale);
            RC_ASSERT(made.verdict == verdict_of(none_negative));
          });
  t.holds("one weight below 0 and a sum below 0 are each seen by themselves", {.number_type = "rational"}, [] {
    std::vector<Rational> weights = *gen::convex_weights(4).as("weights"), ones(4, Rational(1));
    RC_ASSERT(weights_on_same_ray(weights, ones).verdict == Verdict::holds);
    const auto k = *rc::gen::inRange<std::size_t>(0, 4).as("which");
    auto one_negative = weights;
    one_negative[(k + 1) % 4] += one_negative[k] + Rational(1);
    one_negative[k] = -1;  // The sum is kept.
    RC_ASSERT(weights_on_same_ray(one_negative, ones).verdict == Verdict::fails);
    for (auto& w : weights) w = -w;
    RC_ASSERT(weights_on_same_ray(weights, ones).verdict == Verdict::fails);
  });
  t.holds("the inverses of factors of any sign are inverse to them", {.number_type = "rational"}, [] {
    const auto factors = *rc::gen::container<std::vector<Rational>>(3, gen::rational()).as("factors");
    for (const Rational& f : factors) RC_PRE(f != Rational(0));
    for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(inverses(factors)[i] * factors[i] == Rational(1));
  });
}

void rays_and_rotations_need_each_part(Suite& t) {
  t.holds("a ray that is wrong in one part is rejected", {.number_type = "rational", .cases = 2000}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto hull = *gen::scaled_hull<d>().as("case");
      auto to = divided<Rational, d>(hull.vectors, hull.lengths);
      auto w = weights_on_same_ray(hull.weights, hull.lengths);
      const Rational amount = *gen::positive_rational().as("amount");
      const int part = *rc::gen::inRange(0, 5).as("part");
      RC_TAG(part);
      // The sign of the scale is wrong: the hull is the opposite one.
      if (part == 0) {
        for (auto& p : to) p = -p;
        w.scale = -w.scale;
      }
      // One coordinate of one of the vectors that take part is wrong.
      if (part == 1) {
        const auto k = *rc::gen::inRange<std::size_t>(0, to.size()).as("which");
        RC_PRE(w.weights[k] > Rational(0));
        to[k][*rc::gen::inRange(0, int(d)).as("coordinate")] += amount;
      }
      // A negative weight makes the same blend of two equal vectors.
      if (part == 2) {
        to.push_back(to[0]);
        w.weights.push_back(-amount);
        w.weights[0] += amount;
      }
      // There is a weight too many, or too few.
      if (part == 3) {
        if (*rc::gen::arbitrary<bool>().as("too many")) w.weights.push_back(Rational(0));
        else to.push_back(to[0]);
      }
      if (part == 4) {  // The scale is 0, where the blend is 0.
        RC_PRE(squared_norm(blend(hull)) == Rational(0));
        w.scale = 0;
      }
      RC_ASSERT(is_same_ray(hull.vectors, hull.weights, to, w) == Verdict::fails);
    });
  });
  t.holds("two quaternions are one rotation if neither is 0 and one is a multiple of the other", {.number_type = "rational"}, [] {
    const auto p = *gen::nonzero_vector<4>().as("p");
    const Rational factor = *gen::rational().as("factor");
    const gen::RationalVec<4> zero = gen::RationalVec<4>::Zero(), multiple = p * factor;
    RC_ASSERT(are_same_rotation(p, multiple) == verdict_of(factor != Rational(0)));
    RC_ASSERT(are_same_rotation(multiple, p) == verdict_of(factor != Rational(0)));
    RC_ASSERT(are_same_rotation(zero, p) == Verdict::fails && are_same_rotation(p, zero) == Verdict::fails);
    // Every pair of coordinates is looked at.
    const int i = *rc::gen::inRange(0, 4).as("one coordinate"), j = *rc::gen::inRange(0, 4).as("another");
    RC_PRE(i != j);
    gen::RationalVec<4> along = zero, aside = zero;
    along[i] = aside[i] = 1;
    aside[j] = *gen::positive_rational().as("amount");
    RC_ASSERT(are_same_rotation(along, aside) == Verdict::fails);
  });
}

void printed_statement_is_refuted(Suite& t) {
  using namespace lemma2;
  t.example("blends that are 0 refute the printed statement", {.form = "printed"}, [] {
    return normalisation_keeps_rotations_printed(antipodal, ones, halves) == Verdict::fails &&
           normalisation_keeps_rotations_printed(three_around, three_ones, cancelling) == Verdict::fails &&
           normalisation_keeps_rotations_repaired(antipodal, ones, halves) == Verdict::holds &&
           normalisation_keeps_rays_repaired(antipodal, ones, halves) == Verdict::holds &&
           normalisation_keeps_rays_repaired(three_around, three_ones, cancelling) == Verdict::holds;
  });

  t.refuted("every element of the hull is a rotation that the normalised hull has too",
            {.form = "printed", .number_type = "rational"}, [] {
              const auto hull = *gen::scaled_hull<4>().as("case");
              RC_ASSERT(normalisation_keeps_rotations_printed(hull.vectors, hull.lengths, hull.weights) == Verdict::holds);
            });
}

void repaired_statements_hold(Suite& t) {
  using namespace lemma2;
  t.holds("every element of the hull that is not 0 is a rotation that the normalised hull has too",
          {.form = "repaired", .number_type = "rational", .cases = 3000, .degenerate_at_least = 0.2, .degenerate_at_most = 0.85},
          [] {
            const auto hull = *gen::scaled_hull<4>().as("case");
            RC_CLASSIFY(is_degenerate<4>(hull), "degenerate");
            RC_ASSERT(are_lengths(hull.vectors, hull.lengths) == Verdict::holds);
            RC_ASSERT(normalisation_keeps_rotations_repaired(hull.vectors, hull.lengths, hull.weights) == Verdict::holds);
            if (squared_norm(blend(hull)) == Rational(0)) return;
            const auto u = weights_on_same_ray(hull.weights, hull.lengths).weights;
            RC_ASSERT(rotate_alike(blend(hull), combine<Rational, 4>(u, divided(hull.vectors, hull.lengths))));
          });
  t.holds("any positive factors keep the rays of the hull, and 0 if it is there, both ways",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.2, .degenerate_at_most = 0.85},
          [] {
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
  t.holds("the same for vectors of any length, with roots", {.form = "repaired", .number_type = "exact root", .cases = 60}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const VecList<Rational, d> list{*gen::nonzero_vector<d>().as("first"), *gen::nonzero_vector<d>().as("second")};
      const auto vectors = lift<ExactRoot>(list);
      const auto weights = lift<ExactRoot>(*gen::convex_weights(2).as("weights"));
      const auto lengths = lengths_by_roots(vectors);
      RC_ASSERT(are_lengths(vectors, lengths) == Verdict::holds);
      RC_ASSERT(normalisation_keeps_rays_repaired(vectors, lengths, weights) == Verdict::holds);
    });
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("intervals never contradict the exact verdict on the rays and on blends that are 0",
          {.number_type = "interval", .cases = 1500, .degenerate_at_least = 0.2, .degenerate_at_most = 0.85}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto hull = *gen::scaled_hull<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(hull), "degenerate");
              hull.vectors[0][0] += *gen::nudge().as("nudge of a vector");
              decide_by_all(vanish_together, hull.vectors, hull.lengths, hull.weights);
            });
          });
  t.holds("intervals seldom decide the equality of rays, exact numbers always do", {.number_type = "interval", .cases = 300}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto hull = *gen::scaled_hull<d>().as("case");
      RC_ASSERT(decide_by_all(keeps_rays, hull.vectors, hull.lengths, hull.weights) == Verdict::holds);
    });
  });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.85},
          [] {
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
}

void pinned_cases(Suite& t) {
  using namespace lemma2;
  t.example("a negative factor leads to another ray", {.form = "repaired", .hypothesis = "the factors are positive"}, [] {
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
  t.example("weights that are not convex have no convex counterpart", {.form = "repaired", .hypothesis = "w is in W_m"}, [] {
    const auto made = weights_on_same_ray(not_convex, ones);
    return is_convex<Q>(not_convex) == Verdict::fails && made.verdict == Verdict::fails &&
           is_same_ray(right_angle, not_convex, right_angle, made) == Verdict::fails;
  });
}

PROPTEST(lemma2_normalization) {
  undecided_parts_are_not_lost(t);
  hypotheses_need_each_part(t);
  weights_of_a_ray_need_each_part(t);
  rays_and_rotations_need_each_part(t);
  printed_statement_is_refuted(t);
  repaired_statements_hold(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_lemma2_normalization
