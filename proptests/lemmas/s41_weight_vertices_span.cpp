// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s41_weight_vertices_span.hpp"

#include "algorithms/bake/weight_vertices.hpp"
#include "proptests/counterexamples/s41_weight_vertices_span.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_s41_weight_vertices_span {
namespace {

using namespace refitlab;
using Weights = std::vector<Rational>;

bool is_degenerate(const gen::WeightPolytope& b) {
  bool fixed = false;
  for (std::size_t i = 0; i < b.bounds.low.size(); ++i) fixed = fixed || b.bounds.low[i] == b.bounds.high[i];
  return fixed || b.vertices.size() == 1;
}
bool is_degenerate(const gen::WeightPolytope& b, const Weights& w) {
  return is_degenerate(b) || std::find(b.vertices.begin(), b.vertices.end(), w) != b.vertices.end();
}

// Draws bounds of three or four weights with at least three weight vertices, so that there is one between the first and the last.
gen::WeightPolytope several_weight_vertices() {
  const int n = *rc::gen::element(3, 4).as("weights");
  const Weights w = *gen::convex_weights(n).as("between the bounds");
  gen::WeightPolytope b{{w, w}, {}};
  for (auto& low : b.bounds.low) low -= *gen::positive_rational().as("below");
  for (auto& high : b.bounds.high) high += *gen::positive_rational().as("above");
  b.vertices = *enumerate_weight_vertices(b.bounds, 1000);
  return b;
}

std::size_t place_in(std::size_t size) { return *rc::gen::inRange<std::size_t>(0, size).as("place"); }

// Returns all of the weight on one of so many.
Weights only(std::size_t k, std::size_t size) {
  Weights u(size, Rational(0));
  u[k] = 1;
  return u;
}

void hypotheses_need_each_part(Suite& t) {
  needs_part(t, "one of the weight vertices is not listed", [] {
    const auto b = several_weight_vertices();
    auto weight_vertices = b.vertices;
    const auto k = place_in(weight_vertices.size());
    const Weights missing = weight_vertices[k];
    weight_vertices.erase(weight_vertices.begin() + static_cast<std::ptrdiff_t>(k));
    RC_ASSERT(weight_vertices_are_admissible(b.bounds, weight_vertices) == Verdict::holds);
    RC_ASSERT(weight_vertices_are_complete(b.bounds, weight_vertices) == Verdict::fails);
    return Weakening{weight_vertices_span_hypotheses(b.bounds, weight_vertices),
                     weight_vertices_span(b.bounds, weight_vertices, missing).verdict};
  });
  needs_part(t, "one of the listed points is not admissible: a bound or the sum is violated by one coordinate", [] {
    const auto b = several_weight_vertices();
    auto weight_vertices = b.vertices;
    const auto k = place_in(weight_vertices.size());
    Weights outside = weight_vertices[k];
    const std::size_t n = outside.size(), i = place_in(n);
    const Rational amount = *gen::positive_rational().as("amount");
    const int kind = *rc::gen::inRange(0, 3).as("kind");
    const Rational way =
        kind == 0 ? Rational(b.bounds.high[i] - outside[i] + amount) : Rational(b.bounds.low[i] - outside[i] - amount);
    outside[i] += way;
    if (kind < 2) outside[(i + 1) % n] -= way;  // Otherwise the sum changes.
    weight_vertices.insert(weight_vertices.begin() + static_cast<std::ptrdiff_t>(k), outside);
    RC_ASSERT(weight_vertices_are_admissible(b.bounds, weight_vertices) == Verdict::fails);
    RC_ASSERT(weight_vertices_are_complete(b.bounds, weight_vertices) == Verdict::holds);
    RC_ASSERT(weight_vertices_are_proper(b.bounds, weight_vertices) == Verdict::fails);
    return Weakening{weight_vertices_span_hypotheses(b.bounds, weight_vertices),
                     weight_vertices_combine(b.bounds, weight_vertices, only(k, weight_vertices.size())).verdict};
  });
  needs_part(t, "one of the weights is beyond one of its bounds", [] {
    const auto b = several_weight_vertices();
    Weights w = *gen::admissible_weights(b.bounds).as("weights");
    const std::size_t n = w.size(), i = place_in(n);
    const Rational amount = *gen::positive_rational().as("amount");
    const bool high = *rc::gen::arbitrary<bool>().as("the high one");
    const Rational way = high ? Rational(b.bounds.high[i] - w[i] + amount) : Rational(b.bounds.low[i] - w[i] - amount);
    w[i] += way;
    w[(i + 1) % n] -= way;
    return Weakening{admits<Rational>(b.bounds, w), weight_vertices_span(b.bounds, b.vertices, w).verdict};
  });
}

void bounds_and_lists_need_each_part(Suite& t) {
  t.holds("bounds of which one pair is crossed are not compatible, and have no weight vertex", {.number_type = "rational"}, [] {
    // Three pairs of bounds are at 1/3, and one pair is crossed about its place, so that both sums are still on their sides of 1.
    const Rational third(1, 3), amount = *gen::positive_rational().as("amount"), room = Rational(2) * amount;
    const std::size_t i = place_in(3);
    WeightBounds<Rational> bounds{Weights(3, third), Weights(3, third)};
    RC_ASSERT(bounds_are_compatible(bounds) == Verdict::holds && has_weight_vertex(bounds).verdict == Verdict::holds);
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.low[k] += k == i ? amount : Rational(-room);
      bounds.high[k] += k == i ? Rational(-amount) : room;
    }
    RC_ASSERT(bounds_are_compatible(bounds) == Verdict::fails && has_weight_vertex(bounds).verdict == Verdict::fails);
    RC_ASSERT(weight_vertices_exist_repaired(bounds) == Verdict::holds);
  });
  t.holds("bounds are compatible up to sums of exactly 1 and no further", {.number_type = "rational"}, [] {
    const Weights w = *gen::convex_weights(*rc::gen::inRange(1, 5).as("weights"));
    const Rational amount = *gen::positive_rational().as("amount");
    const std::size_t i = place_in(w.size());
    WeightBounds<Rational> from{w, w}, to{w, w};
    for (auto& h : from.high) h += Rational(1);
    for (auto& l : to.low) l -= Rational(1);
    for (const auto& bounds : {from, to}) {
      RC_ASSERT(bounds_are_compatible(bounds) == Verdict::holds);
      RC_ASSERT(has_weight_vertex(bounds).weight_vertex == w);
    }
    from.low[i] += amount, from.high[i] += amount;
    to.low[i] -= amount, to.high[i] -= amount;
    for (const auto& bounds : {from, to}) {
      RC_ASSERT(bounds_are_compatible(bounds) == Verdict::fails);
      RC_ASSERT(has_weight_vertex(bounds).verdict == Verdict::fails);
    }
  });
  t.holds("a weight vertex whose only loose coordinate is any of them is looked for", {.number_type = "rational"}, [] {
    const Weights w = *gen::convex_weights(*rc::gen::inRange(1, 5).as("weights"));
    const std::size_t i = place_in(w.size());
    WeightBounds<Rational> bounds{w, w};
    bounds.low[i] -= *gen::positive_rational().as("below");
    bounds.high[i] += *gen::positive_rational().as("above");
    RC_ASSERT(has_weight_vertex(bounds).weight_vertex == w);
    RC_ASSERT(weight_vertices_are_complete(bounds, {}) == Verdict::fails);
    RC_ASSERT(weight_vertices_are_complete(bounds, {w}) == Verdict::holds);
    RC_ASSERT(weight_vertices_are_proper(bounds, {w}) == Verdict::holds);
    long candidates = 0;
    for_each_weight_vertex_candidate(bounds, [&](const Weights&) { ++candidates; });
    RC_ASSERT(candidates == static_cast<long>(w.size()) << (w.size() - 1));
  });
  t.holds("a list with two equal weight vertices, wherever they stand, or with a point between two weight vertices is not proper",
          {.number_type = "rational"}, [] {
            const auto b = several_weight_vertices();
            auto twice = b.vertices, between = b.vertices;
            const auto k = place_in(twice.size()), place = place_in(twice.size() + 1);
            twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(place), b.vertices[k]);
            RC_ASSERT(weight_vertices_are_proper(b.bounds, twice) == Verdict::fails);
            Weights middle(b.bounds.low.size(), Rational(0));  // It is the mean of all weight vertices.
            for (const auto& c : b.vertices)
              for (std::size_t i = 0; i < c.size(); ++i) middle[i] += c[i] / Rational(static_cast<int>(b.vertices.size()));
            between.insert(between.begin() + static_cast<std::ptrdiff_t>(place), middle);
            RC_ASSERT(weight_vertices_are_admissible(b.bounds, between) == Verdict::holds);
            RC_ASSERT(weight_vertices_are_proper(b.bounds, between) == Verdict::fails);
          });
  t.example("a proper list has no candidate that the bounds do not admit", {}, [] {
    const WeightBounds<Rational> half{{0, 0}, {Rational(1, 2), Rational(3, 4)}};
    // (1, 0) has the second weight at its bound, and the first one beyond.
    return weight_vertices_are_proper(half, {{Rational(1, 2), Rational(1, 2)}}) == Verdict::holds &&
           weight_vertices_are_proper(half, {{1, 0}}) == Verdict::fails;
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("weights are the same if there are as many and every one is equal", {.number_type = "rational"}, [] {
    const Weights w = *gen::convex_weights(*rc::gen::inRange(1, 5).as("weights"));
    RC_ASSERT(same_weights(w, w) == Verdict::holds);
    auto longer = w, other = w;
    longer.push_back(Rational(0));
    RC_ASSERT(same_weights(w, longer) == Verdict::fails && same_weights(longer, w) == Verdict::fails);
    other[place_in(w.size())] += *gen::positive_rational().as("amount");
    RC_ASSERT(same_weights(w, other) == Verdict::fails && same_weights(other, w) == Verdict::fails);
  });
  t.holds("a combination that is wrong in one coordinate, or has a coefficient too few, is rejected", {.number_type = "rational"},
          [] {
            const auto b = several_weight_vertices();
            const Weights u = *gen::convex_weights(static_cast<int>(b.vertices.size()));
            Weights w = weight_vertices_combine(b.bounds, b.vertices, u).weights;
            RC_ASSERT(is_weight_vertex_combination(b.vertices, w, u) == Verdict::holds);
            auto more = b.vertices;  // One weight vertex has no coefficient.
            more.push_back(b.vertices[0]);
            RC_ASSERT(is_weight_vertex_combination(more, w, u) == Verdict::fails);
            const Rational amount = *gen::positive_rational().as("amount");
            w[place_in(w.size())] += *rc::gen::element(amount, Rational(-amount)).as("change");
            RC_ASSERT(is_weight_vertex_combination(b.vertices, w, u) == Verdict::fails);
          });
  t.holds("coefficients of which one is negative make the right point and are rejected", {.number_type = "rational"}, [] {
    auto b = several_weight_vertices();
    Weights u = *gen::convex_weights(static_cast<int>(b.vertices.size()));
    const Weights w = weight_vertices_combine(b.bounds, b.vertices, u).weights;
    const auto k = place_in(u.size());
    b.vertices.push_back(b.vertices[k]);
    u.push_back(u[k] + *gen::positive_rational().as("amount"));
    u[k] -= u.back();
    RC_ASSERT(u[k] < Rational(0));
    RC_ASSERT(is_weight_vertex_combination(b.vertices, w, u) == Verdict::fails);
  });
  t.holds("a normal separates a point from others only if it is strictly beyond each of them", {.number_type = "rational"}, [] {
    const auto points =
        *rc::gen::container<WeightVertices<Rational>>(3, rc::gen::container<Weights>(3, gen::rational())).as("points");
    const Weights normal = *rc::gen::container<Weights>(3, gen::rational()).as("normal");
    Weights w = *rc::gen::container<Weights>(3, gen::rational()).as("point");
    if (*rc::gen::inRange(0, 3).as("one of the points") == 0) w = points[place_in(3)];
    bool beyond = true;
    for (const auto& p : points) {
      Rational gap(0);
      for (std::size_t i = 0; i < 3; ++i) gap += normal[i] * (w[i] - p[i]);
      beyond = beyond && gap > Rational(0);
    }
    RC_CLASSIFY(beyond, "separated");
    RC_ASSERT(separates(normal, w, points) == verdict_of(beyond));
  });
}

void weight_vertices_span_the_admissible_weights(Suite& t) {
  t.holds(
      "every admissible weight vector is a convex combination of the weight vertices",
      {.form = "printed", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
        const auto b = *gen::any_bounds_of_vertices(5);
        const Weights w = *gen::admissible_weights(b.bounds);
        RC_CLASSIFY(is_degenerate(b, w), "degenerate");
        RC_ASSERT(weight_vertices_span_hypotheses(b.bounds, b.vertices) == Verdict::holds);
        RC_ASSERT(admits<Rational>(b.bounds, w) == Verdict::holds);
        const auto span = weight_vertices_span(b.bounds, b.vertices, w);
        RC_ASSERT(span.verdict == Verdict::holds);
        RC_ASSERT(is_weight_vertex_combination(b.vertices, w, span.coefficients) == Verdict::holds);
        const auto used =
            std::count_if(span.coefficients.begin(), span.coefficients.end(), [](const Rational& u) { return u != Rational(0); });
        RC_ASSERT(used <= static_cast<long>(w.size()));
      });

  t.holds("every convex combination of the weight vertices is admissible",
          {.form = "printed", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9},
          [] {
            const auto b = *gen::any_bounds_of_vertices(5);
            const Weights u = *gen::convex_weights(static_cast<int>(b.vertices.size()));
            const auto made = weight_vertices_combine(b.bounds, b.vertices, u);
            RC_CLASSIFY(is_degenerate(b, made.weights), "degenerate");
            RC_ASSERT(made.verdict == Verdict::holds);
            RC_ASSERT(is_weight_vertex_combination(b.vertices, made.weights, u) == Verdict::holds);
          });

  t.holds("W' has at most n C(n-1, floor((n-1)/2)) weight vertices",
          {.form = "beyond", .number_type = "rational", .cases = 200, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto b = *gen::any_bounds_of_vertices(5);
            RC_CLASSIFY(is_degenerate(b), "degenerate");
            RC_ASSERT(weight_vertices_are_proper(b.bounds, b.vertices) == Verdict::holds);
            RC_ASSERT(b.vertices.size() <= most_weight_vertices(b.bounds.low.size()));
          });

  t.example("the greatest number of weight vertices is reached: 1, 2, 6, 12, 30, 60 for 1 to 6 weights", {}, [] {
    const std::size_t expected[] = {1, 2, 6, 12, 30, 60};
    bool all = true;
    for (int n = 1; n <= 6; ++n) {
      // With the bounds [0, h], k h < 1 < (k + 1) h and k = floor((n - 1) / 2), k weights are at h, and one has the rest.
      const int k = (n - 1) / 2;
      const WeightBounds<Rational> bounds{Weights(n, 0), Weights(n, Rational(2, 2 * k + (n == 1 ? 2 : 1)))};
      const auto weight_vertices = *enumerate_weight_vertices(bounds, 1000);
      all = all && weight_vertices.size() == expected[n - 1] && most_weight_vertices(n) == expected[n - 1] &&
            weight_vertices_span_hypotheses(bounds, weight_vertices) == Verdict::holds;
    }
    return Checked(all, 6);
  });
}

void bounds_have_weight_vertices_if_compatible(Suite& t) {
  t.refuted("any bounds have weight vertices", {.form = "implied", .number_type = "rational"},
            [] { RC_ASSERT(weight_vertices_exist_printed(*gen::arbitrary_bounds(4)) == Verdict::holds); });
  t.holds("bounds have weight vertices if and only if sum l <= 1 <= sum h and no l_i > h_i",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.1, .degenerate_at_most = 0.9}, [] {
            const auto bounds = *gen::arbitrary_bounds(4);
            const auto found = has_weight_vertex(bounds);
            RC_CLASSIFY(found.verdict == Verdict::holds, "has weight vertices");
            Rational low(0), high(0);
            bool fixed = false;
            for (std::size_t i = 0; i < bounds.low.size(); ++i)
              low += bounds.low[i], high += bounds.high[i], fixed = fixed || bounds.low[i] == bounds.high[i];
            RC_CLASSIFY(fixed || low == Rational(1) || high == Rational(1), "degenerate");
            RC_ASSERT(weight_vertices_exist_repaired(bounds) == Verdict::holds);
            if (found.verdict == Verdict::holds) RC_ASSERT(admits<Rational>(bounds, found.weight_vertex) == Verdict::holds);
          });
  t.example("bounds that let no weights through refute the printed statement", {.form = "printed"}, [] {
    bool all = true;
    for (const auto& bounds : {s41::low_too_high, s41::high_too_low, s41::crossed})
      all = all && weight_vertices_exist_printed(bounds) == Verdict::fails &&
            weight_vertices_exist_repaired(bounds) == Verdict::holds;
    return Checked(all, 3);
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict on a combination", {.number_type = "interval", .cases = 300}, [] {
    const auto b = *gen::any_bounds_of_vertices(4);
    Weights w = *gen::admissible_weights(b.bounds);
    // This statement fails.
    if (*rc::gen::arbitrary<bool>()) w[0] += Rational(1, 64);
    const auto coefficients = weight_vertices_span(b.bounds, b.vertices, w).coefficients;
    decide_by_all([](const auto& l, const auto& c, const auto& x) { return weight_vertices_span(l, c, x).verdict; }, b.bounds,
                  b.vertices, w);
    decide_by_all([](const auto& c, const auto& x, const auto& u) { return is_weight_vertex_combination(c, x, u); }, b.vertices,
                  w, coefficients);
  });
  t.holds("no number type contradicts the exact verdict on bounds", {.number_type = "interval", .cases = 300}, [] {
    const auto bounds = *gen::arbitrary_bounds(4);
    decide_by_all([](const auto& l) { return weight_vertices_exist_printed(l); }, bounds);
    decide_by_all([](const auto& l) { return bounds_are_compatible(l); }, bounds);
  });

  t.holds("a mutated combination is rejected", {.number_type = "rational", .cases = 300}, [] {
    const auto b = *gen::any_bounds_of_vertices(4);
    const Weights w = *gen::admissible_weights(b.bounds);
    const auto good = weight_vertices_span(b.bounds, b.vertices, w).coefficients;
    const auto k = *rc::gen::inRange<std::size_t>(0, good.size());
    auto changed = good, negative = good, longer = good;
    changed[k] += *gen::positive_rational();
    RC_ASSERT(is_weight_vertex_combination(b.vertices, w, changed) == Verdict::fails);
    longer.push_back(0);
    RC_ASSERT(is_weight_vertex_combination(b.vertices, w, longer) == Verdict::fails);
    // The sum of coefficients is the same, with another point or a negative coefficient.
    if (good.size() > 1) {
      negative[k] -= 2;
      negative[(k + 1) % good.size()] += 2;
      RC_ASSERT(is_weight_vertex_combination(b.vertices, w, negative) == Verdict::fails);
    }
  });
}

void pinned_cases(Suite& t) {
  t.example("without one of the weight vertices an admissible vector is not spanned",
            {.form = "printed", .hypothesis = "the list has every weight vertex"}, [] {
              return weight_vertices_are_admissible(s41::segment, s41::one_end) == Verdict::holds &&
                     weight_vertices_are_complete(s41::segment, s41::one_end) == Verdict::fails &&
                     weight_vertices_span(s41::segment, s41::one_end, s41::middle).verdict == Verdict::fails &&
                     separates(s41::towards_the_other_end, s41::middle, s41::one_end) == Verdict::holds;
            });
  t.example("weights outside their bounds are not spanned", {.form = "printed", .hypothesis = "the weights are admissible"}, [] {
    return weight_vertices_span_hypotheses(s41::segment, s41::both_ends) == Verdict::holds &&
           admits<Rational>(s41::segment, s41::beyond_the_segment) == Verdict::fails &&
           weight_vertices_span(s41::segment, s41::both_ends, s41::beyond_the_segment).verdict == Verdict::fails &&
           separates(s41::along_the_segment, s41::beyond_the_segment, s41::both_ends) == Verdict::holds &&
           // 2 and -1 make it of the weight vertices, but are not convex.
           is_weight_vertex_combination(s41::both_ends, s41::beyond_the_segment, s41::beyond_the_segment) == Verdict::fails;
  });
  t.example("a listed point outside the bounds makes inadmissible combinations",
            {.form = "printed", .hypothesis = "the listed weight vertices are admissible"}, [] {
              return weight_vertices_are_complete(s41::segment, s41::too_far) == Verdict::holds &&
                     weight_vertices_are_admissible(s41::segment, s41::too_far) == Verdict::fails &&
                     weight_vertices_combine(s41::segment, s41::too_far, s41::only_the_first).verdict == Verdict::fails;
            });
  t.example("a list with a repeated weight vertex is longer than the bound",
            {.form = "beyond", .hypothesis = "no weight vertex is listed twice"}, [] {
              return weight_vertices_are_proper(s41::segment, s41::repeated) == Verdict::fails &&
                     s41::repeated.size() > most_weight_vertices(2);
            });
}

PROPTEST(s41_weight_vertices_span) {
  hypotheses_need_each_part(t);
  bounds_and_lists_need_each_part(t);
  checks_need_each_part(t);
  weight_vertices_span_the_admissible_weights(t);
  bounds_have_weight_vertices_if_compatible(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s41_weight_vertices_span
