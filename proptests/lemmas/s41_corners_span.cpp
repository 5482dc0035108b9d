#include "lemmas/s41_corners_span.hpp"

#include "algorithms/weights/corners.hpp"
#include "proptests/counterexamples/s41_corners_span.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using Weights = std::vector<Rational>;

bool is_degenerate(const gen::BoundsWithCorners& b, const Weights& w) {
  bool at_corner = false, fixed = false;
  for (const auto& c : b.corners) at_corner = at_corner || c == w;
  for (std::size_t i = 0; i < w.size(); ++i) fixed = fixed || b.bounds.low[i] == b.bounds.high[i];
  return at_corner || fixed || b.corners.size() == 1;
}

PROPTEST(s41_corners_span) {
  t.holds("every admissible weight vector is a convex combination of the corners",
          {.form = "printed", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const auto b = *gen::any_bounds_of_vertices(5);
            const Weights w = *gen::admissible_weights(b.bounds);
            RC_CLASSIFY(is_degenerate(b, w), "degenerate");
            RC_ASSERT(corners_span_hypotheses(b.bounds, b.corners) == Verdict::holds);
            RC_ASSERT(admits<Rational>(b.bounds, w) == Verdict::holds);
            const auto span = corners_span(b.bounds, b.corners, w);
            RC_ASSERT(span.verdict == Verdict::holds);
            RC_ASSERT(is_corner_combination(b.corners, w, span.coefficients) == Verdict::holds);
            const auto used = std::count_if(span.coefficients.begin(), span.coefficients.end(),
                                            [](const Rational& u) { return u != Rational(0); });
            RC_ASSERT(used <= static_cast<long>(w.size()));
          });

  t.holds("every convex combination of the corners is admissible",
          {.form = "printed", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const auto b = *gen::any_bounds_of_vertices(5);
            const Weights u = *gen::convex_weights(static_cast<int>(b.corners.size()));
            const auto made = corners_combine(b.bounds, b.corners, u);
            RC_CLASSIFY(is_degenerate(b, made.weights), "degenerate");
            RC_ASSERT(made.verdict == Verdict::holds);
            RC_ASSERT(is_corner_combination(b.corners, made.weights, u) == Verdict::holds);
          });

  t.holds("W' has at most n C(n-1, floor((n-1)/2)) corners",
          {.form = "beyond", .number_type = "rational", .cases = 200, .degenerate_at_least = 0.2}, [] {
            const auto b = *gen::any_bounds_of_vertices(5);
            RC_CLASSIFY(is_degenerate(b, b.corners[0]), "degenerate");
            RC_ASSERT(corners_are_proper(b.bounds, b.corners) == Verdict::holds);
            RC_ASSERT(b.corners.size() <= most_corners(b.bounds.low.size()));
          });

  t.example("the greatest number of corners is reached: 1, 2, 6, 12, 30, 60 for 1 to 6 weights", {}, [] {
    const std::size_t expected[] = {1, 2, 6, 12, 30, 60};
    bool all = true;
    for (int n = 1; n <= 6; ++n) {
      // Bounds [0, h] with k h < 1 < (k + 1) h, k = floor((n - 1) / 2): k weights at h, one with the rest.
      const int k = (n - 1) / 2;
      const WeightBounds<Rational> bounds{Weights(n, 0), Weights(n, Rational(2, 2 * k + (n == 1 ? 2 : 1)))};
      const auto corners = *enumerate_corners(bounds, 1000);
      all = all && corners.size() == expected[n - 1] && most_corners(n) == expected[n - 1] &&
            corners_span_hypotheses(bounds, corners) == Verdict::holds;
    }
    return Checked(all, 6);
  });

  t.refuted("any bounds have corners", {.form = "printed", .number_type = "rational"},
            [] { RC_ASSERT(corners_exist_printed(*gen::arbitrary_bounds(4)) == Verdict::holds); });
  t.holds("bounds have corners if and only if sum l <= 1 <= sum h and no l_i > h_i",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.1}, [] {
            const auto bounds = *gen::arbitrary_bounds(4);
            const auto found = has_corner(bounds);
            RC_CLASSIFY(found.verdict == Verdict::holds, "has corners");
            Rational low(0), high(0);
            bool fixed = false;
            for (std::size_t i = 0; i < bounds.low.size(); ++i)
              low += bounds.low[i], high += bounds.high[i], fixed = fixed || bounds.low[i] == bounds.high[i];
            RC_CLASSIFY(fixed || low == Rational(1) || high == Rational(1), "degenerate");
            RC_ASSERT(corners_exist_repaired(bounds) == Verdict::holds);
            if (found.verdict == Verdict::holds) RC_ASSERT(admits<Rational>(bounds, found.corner) == Verdict::holds);
          });
  t.example("bounds that let no weights through refute the printed statement", {.form = "printed"}, [] {
    bool all = true;
    for (const auto& bounds : {s41::low_too_high, s41::high_too_low, s41::crossed})
      all = all && corners_exist_printed(bounds) == Verdict::fails && corners_exist_repaired(bounds) == Verdict::holds;
    return Checked(all, 3);
  });

  t.holds("no number type contradicts the exact verdict on a combination", {.number_type = "interval", .cases = 300},
          [] {
            const auto b = *gen::any_bounds_of_vertices(4);
            Weights w = *gen::admissible_weights(b.bounds);
            if (*rc::gen::arbitrary<bool>()) w[0] += Rational(1, 64);  // a statement that fails
            const auto coefficients = corners_span(b.bounds, b.corners, w).coefficients;
            decide_by_all([](const auto& l, const auto& c, const auto& x) { return corners_span(l, c, x).verdict; },
                          b.bounds, b.corners, w);
            decide_by_all([](const auto& c, const auto& x, const auto& u) { return is_corner_combination(c, x, u); },
                          b.corners, w, coefficients);
          });
  t.holds("no number type contradicts the exact verdict on bounds", {.number_type = "interval", .cases = 300}, [] {
    const auto bounds = *gen::arbitrary_bounds(4);
    decide_by_all([](const auto& l) { return corners_exist_printed(l); }, bounds);
    decide_by_all([](const auto& l) { return bounds_are_compatible(l); }, bounds);
  });

  t.holds("a mutated combination is rejected", {.number_type = "rational", .cases = 300}, [] {
    const auto b = *gen::any_bounds_of_vertices(4);
    const Weights w = *gen::admissible_weights(b.bounds);
    const auto good = corners_span(b.bounds, b.corners, w).coefficients;
    const auto k = *rc::gen::inRange<std::size_t>(0, good.size());
    auto changed = good, negative = good, longer = good;
    changed[k] += *gen::positive_rational();
    RC_ASSERT(is_corner_combination(b.corners, w, changed) == Verdict::fails);
    longer.push_back(0);
    RC_ASSERT(is_corner_combination(b.corners, w, longer) == Verdict::fails);
    if (good.size() > 1) {  // the same sum of coefficients, another point or a negative coefficient
      negative[k] -= 2;
      negative[(k + 1) % good.size()] += 2;
      RC_ASSERT(is_corner_combination(b.corners, w, negative) == Verdict::fails);
    }
  });

  const Options completeness{.form = "printed", .hypothesis = "the list has every corner"};
  t.example("without one of the corners an admissible vector is not spanned", completeness, [] {
    return corners_are_admissible(s41::segment, s41::one_end) == Verdict::holds &&
           corners_are_complete(s41::segment, s41::one_end) == Verdict::fails &&
           corners_span(s41::segment, s41::one_end, s41::middle).verdict == Verdict::fails &&
           separates(s41::towards_the_other_end, s41::middle, s41::one_end) == Verdict::holds;
  });
  const Options admissible_vector{.form = "printed", .hypothesis = "the weights are admissible"};
  t.example("weights outside their bounds are not spanned", admissible_vector, [] {
    return corners_span_hypotheses(s41::segment, s41::both_ends) == Verdict::holds &&
           admits<Rational>(s41::segment, s41::beyond_the_segment) == Verdict::fails &&
           corners_span(s41::segment, s41::both_ends, s41::beyond_the_segment).verdict == Verdict::fails &&
           separates(s41::along_the_segment, s41::beyond_the_segment, s41::both_ends) == Verdict::holds &&
           // 2 and -1 make it of the corners, but are not convex.
           is_corner_combination(s41::both_ends, s41::beyond_the_segment, s41::beyond_the_segment) == Verdict::fails;
  });
  const Options admissible_list{.form = "printed", .hypothesis = "the listed corners are admissible"};
  t.example("a listed point outside the bounds makes inadmissible combinations", admissible_list, [] {
    return corners_are_complete(s41::segment, s41::too_far) == Verdict::holds &&
           corners_are_admissible(s41::segment, s41::too_far) == Verdict::fails &&
           corners_combine(s41::segment, s41::too_far, s41::only_the_first).verdict == Verdict::fails;
  });
  const Options distinct{.form = "beyond", .hypothesis = "no corner is listed twice"};
  t.example("a list with a repeated corner is longer than the bound", distinct, [] {
    return corners_are_proper(s41::segment, s41::repeated) == Verdict::fails && s41::repeated.size() > most_corners(2);
  });
}

}  // namespace
}  // namespace proptests
