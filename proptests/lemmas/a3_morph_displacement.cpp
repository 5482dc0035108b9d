// SPDX-License-Identifier: GPL-3.0-or-later
// Tests vertices displaced by morph targets.
#include "lemmas/a3_morph_displacement.hpp"

#include "lemmas/c6_interval_hull.hpp"
#include "proptests/counterexamples/a3_morph_displacement.hpp"
#include "proptests/gen/curves.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_a3_morph_displacement {
namespace {

using namespace refitlab;
using gen::RationalVec;

struct Morph {
  Ball3<Rational> reference;
  std::vector<Ball3<Rational>> balls;
  MorphedVertex<Rational> vertex;
  std::vector<Rational> weights, lengths;
  std::vector<Slab<Rational>> ranges;
  Morph() {
    const auto within = [](const Ball3<Rational>& ball) {
      return RationalVec<3>(ball.center +
                            gen::unit_direction() * Rational(*rc::gen::arbitrary<bool>()
                                                                 ? ball.radius
                                                                 : Rational(ball.radius * *gen::unit_interval_rational())));
    };
    reference = {*gen::rational_vector<3>(), abs(*gen::rational())}, vertex.reference = within(reference);
    for (std::size_t k = gen::any_place(4); k > 0; --k) {
      balls.push_back({*gen::rational_vector<3>(), abs(*gen::rational())}), vertex.displacements.push_back(within(balls.back()));
      lengths.push_back(upper_root(squared_norm(balls.back().center)));
      const Rational a = *gen::rational(), b = *gen::rational();
      ranges.push_back({std::min(a, b), std::max(a, b)});
      weights.push_back(ranges.back().low + (ranges.back().high - ranges.back().low) * *gen::unit_interval_rational());
    }
  }
  bool is_degenerate() const {
    bool still = true;
    for (std::size_t k = 0; k < weights.size(); ++k)
      still = still && (weights[k] == 0 || (balls[k].radius == 0 && lengths[k] == 0));
    return still;
  }
};

void displaced_vertices_are_in_their_bounds(Suite& t) {
  t.holds("a displaced vertex is in the displaced ball, and in that of all weights of the ranges",
          {.form = "beyond", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.5}, [] {
            const Morph c;
            RC_ASSERT((morph_hypotheses<Rational>(c.vertex, c.reference, c.balls) &
                       are_in_ranges<Rational>(c.weights, c.ranges)) == Verdict::holds);
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            const auto found = stays_in_displaced_ball<Rational>(c.vertex, c.reference, c.balls, c.weights);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_displaced<Rational>(c.vertex, c.reference, c.balls, c.weights, found.beside) == Verdict::holds);
            RC_ASSERT(stays_in_ball_of_ranges<Rational>(c.vertex, c.reference, c.balls, c.ranges, c.lengths, c.weights) ==
                      Verdict::holds);
            // A range of one weight is (i).
            std::vector<Slab<Rational>> single;
            for (const auto& m : c.weights) single.push_back({m, m});
            const auto given = displaced_ball<Rational>(c.reference, c.balls, c.weights),
                       one = displaced_ball<Rational>(c.reference, c.balls, single, c.lengths);
            RC_ASSERT(given.center == one.center && given.radius == one.radius);
          });
  t.holds("displacements all one way reach the rim, and so do the ends of a range",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            Morph c;
            const RationalVec<3> way = gen::unit_direction();
            c.vertex.reference = c.reference.center + way * c.reference.radius;
            for (std::size_t k = 0; k < c.weights.size(); ++k) {
              const Rational length = abs(*gen::rational());
              c.balls[k].center = way * length, c.lengths[k] = length;
              c.ranges[k].low = -abs(c.ranges[k].high), c.ranges[k].high = abs(c.ranges[k].high), c.weights[k] = c.ranges[k].high;
              c.vertex.displacements[k] = way * Rational(length + c.balls[k].radius);
            }
            for (const auto& ball : {displaced_ball<Rational>(c.reference, c.balls, c.weights),
                                     displaced_ball<Rational>(c.reference, c.balls, c.ranges, c.lengths)})
              RC_ASSERT(squared_distance(displaced<Rational>(c.vertex, c.weights), ball.center) == ball.radius * ball.radius);
          });
  t.holds("in a direction, products of intervals hold it, and no smaller ones do",
          {.form = "beyond", .number_type = "rational", .cases = 400}, [] {
            const Morph c;
            const RationalVec<3> n = *gen::rational_vector<3>();
            const Rational wide = abs(*gen::rational());
            std::vector<Slab<Rational>> slabs;
            for (const auto& d : c.vertex.displacements) slabs.push_back({n.dot(d) - wide, n.dot(d) + wide});
            const Rational at = n.dot(c.vertex.reference);
            const auto slab = displaced_slab<Rational>({at, at}, slabs, c.ranges);
            RC_ASSERT(in_slab(slab, n, displaced<Rational>(c.vertex, c.weights)) == Verdict::holds);
            Rational low = at, high = at;
            for (std::size_t k = 0; k < slabs.size(); ++k) {
              std::vector<Rational> products;
              for (const auto& m : {c.ranges[k].low, c.ranges[k].high})
                for (const auto& d : {slabs[k].low, slabs[k].high}) products.push_back(m * d);
              low += *std::min_element(products.begin(), products.end()),
                  high += *std::max_element(products.begin(), products.end());
            }
            RC_ASSERT(slab.low == low && slab.high == high);
          });
  t.holds("a vertex moves as its weights do", {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
    const Morph c;
    std::vector<Motion<Rational>> motions;
    std::vector<Rational> lengths;
    Moment<Rational, 3> moment{c.vertex.reference, RationalVec<3>::Zero(), RationalVec<3>::Zero()};
    for (const auto& d : c.vertex.displacements) {
      motions.push_back(gen::any_motion()), lengths.push_back(upper_root(squared_norm(d)));
      const auto m = gen::moment_within<1>(motions.back());
      moment = moment + Moment<Rational, 3>{d * m.value[0], d * m.velocity[0], d * m.acceleration[0]};
    }
    RC_ASSERT(moves_within(moment, displaced_motion<Rational>(upper_root(squared_norm(c.vertex.reference)), lengths, motions)) ==
              Verdict::holds);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const Morph c;
    decide_by_all(
        []<class S>(const Vec<S, 3>& vertex, const std::vector<Vec<S, 3>>& displacements, const Ball<S, 3>& reference,
                    const std::vector<Ball<S, 3>>& balls, const std::vector<S>& weights) {
          return stays_in_displaced_ball<S>({vertex, displacements}, reference, balls, weights).verdict;
        },
        c.vertex.reference, c.vertex.displacements,
        Ball3<Rational>{c.reference.center, c.reference.radius * *rc::gen::element(Rational(1), Rational(1, 2))}, c.balls,
        c.weights);
  });
  t.holds("mutated witnesses are rejected", {.number_type = "rational", .cases = 400}, [] {
    const Morph c;
    auto beside = stays_in_displaced_ball<Rational>(c.vertex, c.reference, c.balls, c.weights).beside;
    const std::size_t k = gen::any_place(beside.size() + 1);
    if (k == beside.size()) beside.pop_back();
    else beside[k][static_cast<int>(gen::any_place(3))] += *gen::excess();
    RC_ASSERT(is_displaced<Rational>(c.vertex, c.reference, c.balls, c.weights, beside) == Verdict::fails);
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(t, "a displaced ball needs each part of the hypotheses", {.parts = 2, .share = 0.2}, [] {
    Morph c;
    const RationalVec<3> way = gen::unit_direction();
    c.vertex.reference = c.reference.center + way * c.reference.radius;
    for (std::size_t k = 0; k < c.weights.size(); ++k)
      c.weights[k] = Rational(1), c.ranges[k] = {Rational(1), Rational(1)},
      c.vertex.displacements[k] = c.balls[k].center + way * c.balls[k].radius;
    std::string part = "the reference";
    const std::size_t k = gen::any_place(c.weights.size() + 1);
    if (k == c.weights.size()) c.vertex.reference += way * *gen::excess();
    else part = "a displacement", c.vertex.displacements[k] += way * *gen::excess();
    return Weakening{part, morph_hypotheses<Rational>(c.vertex, c.reference, c.balls),
                     stays_in_displaced_ball<Rational>(c.vertex, c.reference, c.balls, c.weights).verdict &
                         stays_in_ball_of_ranges<Rational>(c.vertex, c.reference, c.balls, c.ranges, c.lengths, c.weights)};
  });
  needs_each_part(t, "weights need their ranges", {.parts = 2, .share = 0.2}, [] {
    const Ball3<Rational> none{RationalVec<3>::Zero(), Rational(0)};
    const Rational low = *gen::rational(), high = low + abs(*gen::rational());
    const bool below = *rc::gen::arbitrary<bool>();
    const Rational m = below ? Rational(low - *gen::excess()) : Rational(high + *gen::excess());
    const std::vector<Ball3<Rational>> balls{{gen::unit_direction(), Rational(0)}};
    const std::vector<Rational> weights{m}, lengths{Rational(1)};
    const std::vector<Slab<Rational>> ranges{{low, high}};
    return Weakening{
        below ? "a weight is less" : "a weight is more", are_in_ranges<Rational>(weights, ranges),
        stays_in_ball_of_ranges<Rational>({RationalVec<3>::Zero(), {balls[0].center}}, none, balls, ranges, lengths, weights)};
  });
}

void pinned_cases(Suite& t) {
  t.example("a smile leaves the ball of the face", {.form = "beyond"}, [] {
    using namespace a3;
    return stays_in_reference<Q>(corner, face, one) == Verdict::fails &&
           stays_in_displaced_ball<Q>(corner, face, smiles, one).verdict == Verdict::holds &&
           stays_in_ball_of_ranges<Q>(corner, face, smiles, up_to_one, length, one) == Verdict::holds;
  });
  t.example("a vertex outside of the face's ball, or a displacement outside of its own, leaves the displaced one",
            {.form = "beyond", .hypothesis = "v_0 and d_k are in their balls"}, [] {
              using namespace a3;
              return morph_hypotheses<Q>(outside, face, smiles) == Verdict::fails &&
                     stays_in_displaced_ball<Q>(outside, face, smiles, one).verdict == Verdict::fails &&
                     morph_hypotheses<Q>(wide, face, smiles) == Verdict::fails &&
                     stays_in_displaced_ball<Q>(wide, face, smiles, one).verdict == Verdict::fails;
            });
  t.example("a weight beyond its range leaves the ball of the range", {.form = "beyond", .hypothesis = "m_k is in [l_k, h_k]"},
            [] {
              using namespace a3;
              return are_in_ranges<Q>(two, up_to_one) == Verdict::fails &&
                     stays_in_ball_of_ranges<Q>(corner, face, smiles, up_to_one, length, two) == Verdict::fails;
            });
}

PROPTEST(a3_morph_displacement) {
  displaced_vertices_are_in_their_bounds(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_a3_morph_displacement
