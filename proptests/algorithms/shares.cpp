// SPDX-License-Identifier: GPL-3.0-or-later
// Tests shares: every mixture of weight vertices has shares that make it, and nothing else has.
#include "algorithms/certificate/shares.hpp"

#include <random>

#include "algorithms/bake/weight_hull.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_shares {
namespace {

using namespace refitlab;
using Row = std::vector<double>;

constexpr int grains = 1 << 24;

// Returns n weights, multiples of 2^-24 of sum 1, some of which are 0 now and then.
Row random_weights(std::mt19937& random, std::size_t n) {
  std::vector<int> cuts{0, grains};
  const int step = std::array{1, grains / 4}[std::uniform_int_distribution<int>(0, 1)(random)];
  for (std::size_t i = 1; i < n; ++i) cuts.push_back(std::uniform_int_distribution<int>(0, grains / step)(random) * step);
  std::sort(cuts.begin(), cuts.end());
  Row out;
  for (std::size_t i = 0; i < n; ++i) out.push_back(double(cuts[i + 1] - cuts[i]) / grains);
  std::shuffle(out.begin(), out.end(), random);
  return out;
}

std::vector<std::span<const double>> spans(const std::vector<Row>& rows) { return {rows.begin(), rows.end()}; }

// Says whether the shares are above 0, without a common divisor, at most as many as there are weights, and make the weights
// exactly.
bool make(const Shares& s, const std::vector<Row>& weight_vertices, const Row& weights) {
  if (s.places.empty() || s.places.size() != s.shares.size() || s.places.size() > weights.size()) return false;
  Rational sum(0);
  CGAL::Gmpz divisor(0);
  for (const Rational& share : s.shares) {
    if (share <= 0 || share.denominator() != 1) return false;
    sum += share;
    mpz_gcd(divisor.mpz(), divisor.mpz(), share.numerator().mpz());
  }
  if (divisor != 1) return false;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    Rational mixed(0);
    for (std::size_t k = 0; k < s.places.size(); ++k) mixed += s.shares[k] * Rational(weight_vertices.at(s.places[k])[i]);
    if (mixed != sum * Rational(weights[i])) return false;
  }
  return true;
}

void check_hulls() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const std::size_t n = *rc::gen::inRange<std::size_t>(1, 8), m = *rc::gen::inRange<std::size_t>(1, 20);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < m; ++k) rows.push_back(random_weights(random, n));
  const std::vector<Row> weight_vertices = weight_polytope(spans(rows));
  RC_CLASSIFY(weight_vertices.size() < n, "degenerate");
  for (const Row& w : rows) {
    const auto found = find_shares(spans(weight_vertices), w);
    RC_ASSERT(found && make(*found, weight_vertices, w));
  }
  // Without this row, one that is beyond all others in some direction is outside.
  std::vector<Row> others = rows;
  const Row direction = random_weights(random, n);
  const auto along = [&](const Row& w) {
    Rational out(0);
    for (std::size_t i = 0; i < n; ++i) out += Rational(w[i]) * Rational(direction[i]);
    return out;
  };
  const auto farthest =
      std::max_element(others.begin(), others.end(), [&](const Row& a, const Row& b) { return along(a) < along(b); });
  const Row removed = *farthest;
  std::erase_if(others, [&](const Row& w) { return along(w) == along(removed); });
  if (!others.empty()) RC_ASSERT(!find_shares(spans(others), removed));
}

}  // namespace

PROPTEST(shares) {
  t.holds("weights have shares of the weight vertices that hold them, exactly, and none of weight vertices that do not",
          {.number_type = "double against rational", .cases = 200}, check_hulls);
  t.example("a weight vertex is itself; a mixture of two has their shares in whole numbers", {}, [] {
    const std::vector<Row> weight_vertices{{1, 0}, {0.25, 0.75}};
    const auto weight_vertex = find_shares(spans(weight_vertices), weight_vertices[1]),
               mixed = find_shares(spans(weight_vertices), Row{0.5, 0.5});
    return weight_vertex->places == std::vector<std::size_t>{1} && weight_vertex->shares == std::vector<Rational>{1} &&
           mixed->places == std::vector<std::size_t>{0, 1} && mixed->shares == std::vector<Rational>{1, 2};
  });
  t.example("weights one grain beyond an edge have none", {}, [] {
    const std::vector<Row> weight_vertices{{0.5, 0.5, 0}, {0.5, 0, 0.5}};
    const double grain = 0x1p-24;
    return find_shares(spans(weight_vertices), Row{0.5, 0.25, 0.25}) &&
           !find_shares(spans(weight_vertices), Row{0.5 - grain, 0.25 + grain, 0.25}) &&
           !find_shares(spans(weight_vertices), Row{0.5, 0.5 + grain, -grain});
  });
}

}  // namespace proptests::suite_shares
