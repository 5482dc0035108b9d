// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/weight_vertices.hpp"

#include <ctime>

#include "proptests/gen/dyadic_bounds.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/weight_vertices.hpp"

namespace proptests::suite_weight_vertices {
namespace {

using namespace refitlab;
using oracle::ExactWeights;

constexpr std::size_t no_limit = 1000000;

template <class S>
std::vector<ExactWeights> exact(const std::vector<std::vector<S>>& rows) {
  std::vector<ExactWeights> out;
  for (const auto& row : rows) out.emplace_back(row.begin(), row.end());
  return out;
}

// Asserts that the weight vertices are those of the oracle, each once.
void assert_complete(const std::vector<ExactWeights>& rows, const std::set<ExactWeights>& expected) {
  RC_ASSERT(rows.size() == expected.size());
  RC_ASSERT(std::set<ExactWeights>(rows.begin(), rows.end()) == expected);
}

std::size_t choose(std::size_t n, std::size_t k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }
std::size_t most_weight_vertices(std::size_t n) { return n * choose(n - 1, (n - 1) / 2); }

// Returns bounds of every weight from 0 to 1 / (the number that are high at a weight vertex, and a half): the box that the plane
// cuts in the middle.
WeightBounds<Rational> middle_cut(int n) {
  return {ExactWeights(n, Rational(0)), ExactWeights(n, Rational(1) / (Rational((n - 1) / 2) + Rational(1, 2)))};
}

void weight_vertices_are_all_there_are(Suite& t) {
  t.holds("the weight vertices are those that trying all patterns finds, each once",
          {.number_type = "rational", .cases = 600, .degenerate_at_least = 0.3}, [] {
            const bool any = *rc::gen::arbitrary<bool>();
            const auto bounds = any ? *gen::arbitrary_bounds(6) : gen::RationalBounds((*gen::any_bounds_of_vertices(6)).bounds);
            const auto expected = oracle::weight_vertices(bounds);
            RC_CLASSIFY(expected.size() < 2, "degenerate");
            RC_CLASSIFY(expected.empty(), "empty");
            assert_complete(*enumerate_weight_vertices(bounds, no_limit), expected);
          });
  t.holds("in doubles that are multiples of 2^-24 the weight vertices are exact",
          {.number_type = "double", .cases = 1000, .degenerate_at_least = 0.3}, [] {
            const auto bounds = *gen::dyadic_bounds(6);
            RC_CLASSIFY(bounds.is_degenerate(), "degenerate");
            const auto expected = oracle::weight_vertices(bounds.as<Rational>());
            RC_CLASSIFY(expected.empty(), "empty");
            assert_complete(exact(*enumerate_weight_vertices(bounds.as<double>(), no_limit)), expected);
          });
  t.holds("every weight vertex is admissible, and so is no point of a box turned inside out",
          {.number_type = "double", .cases = 1000, .degenerate_at_least = 0.3}, [] {
            auto bounds = *gen::dyadic_bounds(7);
            RC_CLASSIFY(bounds.is_degenerate(), "degenerate");
            const auto box = bounds.as<double>();
            const auto weight_vertices = *enumerate_weight_vertices(box, no_limit);
            for (const auto& c : weight_vertices) RC_ASSERT(admits<double>(box, c) == Verdict::holds);
            std::swap(bounds.low[0], bounds.high[0]);
            if (bounds.high[0] < bounds.low[0]) RC_ASSERT(enumerate_weight_vertices(bounds.as<double>(), no_limit)->empty());
          });
  t.holds("admissible weights are a convex combination of the weight vertices, by coefficients that add up exactly",
          {.number_type = "rational", .cases = 400, .degenerate_at_least = 0.15}, [] {
            const auto vertices = *gen::any_bounds_of_vertices(5);
            const auto& bounds = vertices.bounds;
            const ExactWeights w = *gen::admissible_weights(bounds);
            const auto rows = *enumerate_weight_vertices(bounds, no_limit);
            const std::set<ExactWeights> weight_vertices(rows.begin(), rows.end());
            RC_CLASSIFY(weight_vertices.count(w) > 0, "degenerate");
            Rational sum(0);
            ExactWeights blend(w.size(), Rational(0));
            for (const auto& [weight_vertex, coefficient] : oracle::as_combination_of_weight_vertices(bounds, w)) {
              RC_ASSERT(weight_vertices.count(weight_vertex) == 1u);
              RC_ASSERT(coefficient > Rational(0));
              sum += coefficient;
              for (std::size_t i = 0; i < w.size(); ++i) blend[i] += coefficient * weight_vertex[i];
            }
            RC_ASSERT(sum == Rational(1));
            RC_ASSERT(blend == w);
          });
}

void how_many_weight_vertices_and_their_simplex(Suite& t) {
  t.holds("the simplex of the low bounds holds all weight vertices",
          {.number_type = "rational", .cases = 600, .degenerate_at_least = 0.3}, [] {
            const auto dyadic = *gen::dyadic_bounds(6);
            RC_CLASSIFY(dyadic.is_degenerate(), "degenerate");
            const auto bounds = dyadic.as<Rational>();
            const auto simplex = low_bound_simplex(bounds);
            RC_ASSERT(exact(low_bound_simplex(dyadic.as<double>())) == simplex);
            Rational slack(1);
            for (const auto& low : bounds.low) slack -= low;
            const auto weight_vertices = *enumerate_weight_vertices(bounds, no_limit);
            for (const auto& weight_vertex : weight_vertices) {
              // The weight vertex is the sum of (weight_vertex_i - low_i) / slack times row i. Those shares are not negative and
              // sum to 1.
              ExactWeights blend(weight_vertex.size(), Rational(0));
              if (slack == Rational(0)) {
                RC_ASSERT(weight_vertex == simplex[0]);
                continue;
              }
              for (std::size_t row = 0; row < simplex.size(); ++row) {
                const Rational share = (weight_vertex[row] - bounds.low[row]) / slack;
                RC_ASSERT(share >= Rational(0));
                for (std::size_t i = 0; i < blend.size(); ++i) blend[i] += share * simplex[row][i];
              }
              RC_ASSERT(blend == weight_vertex);
            }
          });
  t.holds("a limit of exactly as many weight vertices gives them, one less gives nothing",
          {.number_type = "double", .cases = 500, .degenerate_at_least = 0.3}, [] {
            const auto bounds = *gen::dyadic_bounds(6);
            RC_CLASSIFY(bounds.is_degenerate(), "degenerate");
            const auto box = bounds.as<double>();
            const auto all = *enumerate_weight_vertices(box, no_limit);
            RC_ASSERT(enumerate_weight_vertices(box, all.size()) == std::optional(all));
            if (!all.empty()) RC_ASSERT(!enumerate_weight_vertices(box, all.size() - 1));
          });
  t.holds(
      "there are never more than n C(n-1, floor((n-1)/2)) weight vertices",
      {.number_type = "double", .cases = 1000, .degenerate_at_least = 0.3}, [] {
        const auto bounds = *gen::dyadic_bounds(8);
        RC_CLASSIFY(bounds.is_degenerate(), "degenerate");
        RC_ASSERT(enumerate_weight_vertices(bounds.as<double>(), no_limit)->size() <= most_weight_vertices(bounds.low.size()));
      });
}

void bounds_on_numbers_and_times(Suite& t) {
  t.example("that many weight vertices are reached for 1 to 9 weights: 1, 2, 6, 12, 30, 60, 140, 280, 630", {}, [] {
    const std::size_t known[] = {1, 2, 6, 12, 30, 60, 140, 280, 630};
    bool all = true;
    for (int n = 1; n <= 9; ++n)
      all = all && enumerate_weight_vertices(middle_cut(n), no_limit)->size() == known[n - 1] &&
            most_weight_vertices(n) == known[n - 1];
    return Checked(all, 9);
  });
  t.example("up to 7 weights all weight vertices are kept, from 8 on the simplex may replace them", {}, [] {
    const auto seven = middle_cut(7), eight = middle_cut(8);
    return weight_vertices_or_simplex(seven).size() == 140 && weight_vertices_or_simplex(eight) == low_bound_simplex(eight) &&
           low_bound_simplex(eight).size() == 8;
  });
  t.example("64 weights take well under a second, whatever their bounds", {}, [] {
    const std::clock_t start = std::clock();
    constexpr int n = 64, share = (1 << 24) / n;
    long boxes = 0, too_many = 0;
    for (int shape = 0; shape < 4; ++shape)
      for (int width = 4; width <= share; width *= 2) {
        gen::DyadicBounds box{std::vector<int>(n, share), std::vector<int>(n, share)};
        // Sums of subsets of these are hard to hit.
        for (int i = 0; i < n; ++i) {
          box.low[i] -= i * 7919 % width;
          box.high[i] += (i * 104729 + 13 * shape) % width;
        }
        const int first = shape / 2 * (n - 1);
        // There is hardly any room for the first or last weight.
        if (shape % 2 == 1) box.low[first] = box.high[first] - 1;
        const auto rows = enumerate_weight_vertices(box.as<double>(), weight_vertex_limit);
        too_many += !rows;
        if (rows && rows->empty()) return Checked(false, boxes, "no weight vertices");
        if (weight_vertices_or_simplex(box.as<double>()).size() > weight_vertex_limit)
          return Checked(false, boxes, "too many weight vertices");
        ++boxes;
      }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return Checked(seconds < 1 && too_many > 50, boxes, std::to_string(too_many) + " boxes fall back");
  });
}

}  // namespace

PROPTEST(weight_vertices) {
  weight_vertices_are_all_there_are(t);
  how_many_weight_vertices_and_their_simplex(t);
  bounds_on_numbers_and_times(t);
}

}  // namespace proptests::suite_weight_vertices
