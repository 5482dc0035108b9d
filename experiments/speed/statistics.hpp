// SPDX-License-Identifier: GPL-3.0-or-later
// Medians of what was measured several times.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace refitlab {

// values is not empty; of an even number the larger of the two in the middle.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The median over the repetitions of the ratio in the same repetition; times and base are of one length, not 0.
inline double median_ratio(const std::vector<double>& times, const std::vector<double>& base) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(times[i] / base[i]);
  return median(ratios);
}

}  // namespace refitlab
