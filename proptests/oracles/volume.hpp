// SPDX-License-Identifier: GPL-3.0-or-later
// Says which points a volume in double has, with its numbers taken as they stand.
#pragma once

#include <cmath>

#include "algorithms/methods/refit/volume_variants.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::oracle {

// Returns the same volume in rationals: the numbers of double stay as they are.
template <int k>
refitlab::KDop<refitlab::Rational, k> as_exact(const refitlab::KDop<double, k>& dop) {
  refitlab::KDop<refitlab::Rational, k> out;
  for (std::size_t i = 0; i < dop.low.size(); ++i) out.low[i] = dop.low[i], out.high[i] = dop.high[i];
  return out;
}
inline refitlab::Obb<refitlab::Rational> as_exact(const refitlab::Obb<double>& box) {
  using refitlab::convert, refitlab::Rational;
  refitlab::Obb<Rational> out{{}, convert<Rational>(box.low), convert<Rational>(box.high)};
  for (int i = 0; i < 3; ++i) out.axes[i] = convert<Rational>(box.axes[i]);
  return out;
}

// Says whether all of space is meant: each slab is from minus infinity to infinity.
inline bool is_all_of_space(const refitlab::Volume& volume) {
  return std::visit(
      [](const auto& v) {
        bool all = true;
        for (int i = 0; i < static_cast<int>(v.low.size()); ++i) all = all && v.low[i] == -HUGE_VAL && v.high[i] == HUGE_VAL;
        return all;
      },
      volume);
}

// Says whether the point is in the volume. One that is not finite has a point only if it is all of space.
inline bool has(const refitlab::Volume& volume, const refitlab::Vec<refitlab::Rational, 3>& point) {
  if (is_all_of_space(volume)) return true;
  return std::visit(
      [&](const auto& v) {
        for (int i = 0; i < static_cast<int>(v.low.size()); ++i)
          if (!std::isfinite(v.low[i]) || !std::isfinite(v.high[i])) return false;
        return as_exact(v).contains(point) == refitlab::Verdict::holds;
      },
      volume);
}

}  // namespace proptests::oracle
