// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/weight_hull.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

#include "algorithms/bake/weight_vertices.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/rational.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/convex_combination.hpp"
#include "proptests/oracles/weight_vertices.hpp"

namespace proptests::suite_weight_hull {
namespace {

using namespace refitlab;
using Rows = std::vector<std::vector<double>>;

constexpr int one = 1 << 24;

// Returns shares of 2^24 that sum to it.
std::vector<int> shares(int n) {
  const auto parts = *rc::gen::container<std::vector<int>>(
      n, rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {3, gen::small_positive_integer()}}));
  int sum = 1, rest = one;
  for (const int p : parts) sum += p;
  std::vector<int> out;
  for (int i = 0; i + 1 < n; ++i)
    out.push_back(static_cast<int>(std::int64_t{one} * parts[i] / sum / 64 * 64)), rest -= out.back();
  out.push_back(rest);
  return out;
}

enum class Kind { general, repeated, on_a_line, in_a_plane, one_row };

struct Weights {
  int n;
  Kind kind;
  Rows rows;
  std::vector<std::span<const double>> spans() const { return {rows.begin(), rows.end()}; }
};

Weights draw(int most) {
  Weights out{*gen::between(1, most + 1), static_cast<Kind>(*gen::between(0, 5)), {}};
  const int count = out.kind == Kind::one_row ? 1 : *gen::between(2, 13);
  std::vector<std::vector<int>> units;
  for (int r = 0; r < count; ++r) units.push_back(shares(out.n));
  for (int r = 2; r < count; ++r)
    for (int i = 0; i < out.n; ++i) {
      if (out.kind == Kind::repeated && r % 2 == 0) units[r][i] = units[0][i];
      // The differences are multiples of 64, so that the points of the segment in steps of 1/8 are exact.
      if (out.kind == Kind::on_a_line) units[r][i] = units[0][i] + (units[1][i] - units[0][i]) / 8 * (r % 9);
    }
  if (out.kind == Kind::in_a_plane && out.n > 2)  // one weight is the same in all rows
    for (auto& u : units) u[1] += u[0], u[0] = 0;
  for (const auto& u : units) {
    out.rows.emplace_back();
    for (const int x : u) out.rows.back().push_back(static_cast<double>(x) / one);
  }
  return out;
}

std::vector<oracle::Row> exact(const Rows& rows) {
  std::vector<oracle::Row> out;
  for (const auto& r : rows) out.emplace_back(r.begin(), r.end());
  return out;
}

Rows box_weight_vertices(const Rows& rows) {
  const auto bounds = oracle::bounds_around(exact(rows));
  WeightBounds<double> box;
  for (const auto& x : bounds.low) box.low.push_back(CGAL::to_double(x));
  for (const auto& x : bounds.high) box.high.push_back(CGAL::to_double(x));
  return weight_vertices_or_simplex(box);
}

// Says whether the weight vertices cover w, by trying simplices, or by descending along the box where the weight vertices are the
// box's.
bool covers(const Rows& weight_vertices, const Rows& rows, const oracle::Row& w) {
  const auto list = exact(weight_vertices);
  if (w.size() <= 4 || std::find(list.begin(), list.end(), w) != list.end())
    return oracle::as_convex_combination(list, w).has_value();
  for (const auto& [weight_vertex, coefficient] :
       oracle::as_combination_of_weight_vertices(oracle::bounds_around(exact(rows)), w))
    if (std::find(list.begin(), list.end(), weight_vertex) == list.end()) return false;
  return true;
}

}  // namespace

PROPTEST(weight_hull) {
  const Options options{.number_type = "rational", .cases = 500, .degenerate_at_least = 0.5};
  t.holds("every row is a convex combination of the weight vertices, exactly, and the weight vertices are convex weights",
          options, [] {
            const Weights w = draw(6);
            RC_CLASSIFY(w.kind != Kind::general || w.n == 1, "degenerate");
            const Rows weight_vertices = weight_polytope(w.spans());
            for (const auto& row : exact(w.rows)) RC_ASSERT(covers(weight_vertices, w.rows, row));
            for (const auto& c : exact(weight_vertices)) RC_ASSERT(is_convex<Rational>(c) == Verdict::holds);
          });
  t.holds(
      "there are never more weight vertices than those of the box, nor than distinct rows, of which they are for up to four "
      "weights",
      options, [] {
        const Weights w = draw(6);
        RC_CLASSIFY(w.kind != Kind::general || w.n == 1, "degenerate");
        const Rows weight_vertices = weight_polytope(w.spans()), box = box_weight_vertices(w.rows);
        const std::set<std::vector<double>> distinct(w.rows.begin(), w.rows.end());
        RC_ASSERT(weight_vertices.size() <= box.size());
        RC_ASSERT(weight_vertices.size() <= distinct.size());
        for (const auto& c : extreme_rows(w.spans())) RC_ASSERT(distinct.count(c) == 1u);
      });
  t.holds("of up to three weights, and of four that span space, no extreme row is a combination of the others", options, [] {
    const Weights w = draw(4);
    RC_CLASSIFY(w.kind != Kind::general || w.n == 1, "degenerate");
    RC_PRE(w.n < 4 || w.kind == Kind::general);
    const auto rows = exact(extreme_rows(w.spans()));
    RC_PRE(w.n < 4 || rows.size() > 4);
    RC_ASSERT(!rows.empty());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto others = rows;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      RC_ASSERT(others.empty() || !oracle::as_convex_combination(others, rows[i]));
    }
  });
  t.holds("the extreme rows come in one order, whatever that of the rows, and those of four weights in ascending order", options,
          [] {
            Weights w = draw(6);
            RC_CLASSIFY(w.kind != Kind::general || w.n == 1, "degenerate");
            const Rows found = extreme_rows(w.spans());
            RC_ASSERT(w.n != 4 || std::is_sorted(found.begin(), found.end()));
            std::rotate(w.rows.begin(), w.rows.begin() + 1, w.rows.end());
            RC_ASSERT(extreme_rows(w.spans()) == found);
          });
  t.holds(
      "the weight vertices are the extreme rows unless the box has fewer: of as many, the extreme rows, which are tighter",
      {.number_type = "double", .cases = 2000, .degenerate_at_least = 0.5, .tags_at_least = {{"as many", 0.1}, {"box", 0.01}}},
      [] {
        const Weights w = draw(6);
        RC_CLASSIFY(w.kind != Kind::general || w.n == 1, "degenerate");
        const Rows extreme = extreme_rows(w.spans()), box = box_weight_vertices(w.rows);
        RC_CLASSIFY(extreme.size() == box.size(), "as many");
        RC_CLASSIFY(box.size() < extreme.size(), "box");
        RC_ASSERT(weight_polytope(w.spans()) == (extreme.size() <= box.size() ? extreme : box));
      });
  t.example("of as many weight vertices as the box has, the rows are kept: a triangle across a box of three weight vertices", {},
            [] {
              const Rows rows{{0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}, {0.375, 0.25, 0.375}};
              const std::vector<std::span<const double>> spans(rows.begin(), rows.end());
              const Rows weight_vertices = weight_polytope(spans), box = box_weight_vertices(rows);
              return weight_vertices.size() == 3 && box.size() >= 3 &&
                     std::set(weight_vertices.begin(), weight_vertices.end()) == std::set(rows.begin(), rows.end());
            });
  t.example("a triangle inside its box keeps its three weight vertices; a full box of rows keeps the fewer ones", {}, [] {
    const Rows triangle{{0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}, {0.25, 0.25, 0.5}, {0.375, 0.375, 0.25}};
    const Rows segment{{0.25, 0.75}, {0.5, 0.5}, {0.75, 0.25}};
    const std::vector<std::span<const double>> a(triangle.begin(), triangle.end()), b(segment.begin(), segment.end());
    return weight_polytope(a).size() == 3 && weight_polytope(b).size() == 2;
  });
}

}  // namespace proptests::suite_weight_hull
