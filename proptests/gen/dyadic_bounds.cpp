// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/dyadic_bounds.hpp"

#include <numeric>

namespace proptests::gen {
namespace {

constexpr int one = 1 << 24;

DyadicBounds make(const std::vector<int>& a, const std::vector<int>& b, int kind) {
  DyadicBounds out;
  const int n = static_cast<int>(a.size());
  // The bounds are around shares of about 1/n, so that the sum of 1 is within reach.
  for (int i = 0; i < n; ++i) {
    const int x = a[i] % (2 * (one / n)), y = b[i] % (one + 1);
    out.low.push_back(std::min(x, y));
    out.high.push_back(std::max(x, y));
  }
  if (kind == 0) out.low.assign(n, 0), out.high.assign(n, one);
  if (kind == 1 || kind == 2) out.low[n - 1] = out.high[n - 1];
  // At their highest they sum to 1.
  if (kind == 3) {
    const auto sum = std::accumulate(out.high.begin(), out.high.end() - 1, std::int64_t{0});
    if (sum <= one) out.high[n - 1] = static_cast<int>(one - sum), out.low[n - 1] = std::min(out.low[n - 1], out.high[n - 1]);
  }
  // At their lowest they sum to 1.
  if (kind == 4) {
    const auto sum = std::accumulate(out.low.begin(), out.low.end() - 1, std::int64_t{0});
    if (sum <= one) out.low[n - 1] = static_cast<int>(one - sum), out.high[n - 1] = std::max(out.low[n - 1], out.high[n - 1]);
  }
  return out;
}

}  // namespace

bool DyadicBounds::is_degenerate() const {
  std::int64_t low_sum = 0, high_sum = 0;
  bool fixed = false;
  for (std::size_t i = 0; i < low.size(); ++i) {
    low_sum += low[i], high_sum += high[i];
    fixed = fixed || low[i] == high[i];
  }
  return fixed || low_sum >= one || high_sum <= one;
}

rc::Gen<DyadicBounds> dyadic_bounds(int most) {
  // Cases are of full size from the first on: inRange alone stays near its low end at small sizes.
  return rc::gen::resize(rc::kNominalSize, rc::gen::mapcat(rc::gen::inRange(1, most + 1), [](int n) {
                           const auto units = rc::gen::container<std::vector<int>>(
                               n, rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {8, rc::gen::inRange(0, one + 1)}}));
                           return rc::gen::apply(make, units, units, rc::gen::inRange(0, 12));
                         }));
}

void showValue(const DyadicBounds& bounds, std::ostream& out) {
  out << "bounds in units of 2^-24 from ";
  rc::show(bounds.low, out);
  out << " to ";
  rc::show(bounds.high, out);
}

}  // namespace proptests::gen
