// SPDX-License-Identifier: GPL-3.0-or-later
// These are medians of repeated measurements.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace refitlab {

// Returns the median of values, which is not empty. For an even number of values it is the larger of the two in the middle.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Returns the median over the repetitions of the ratio in the same repetition. times and base have the same length, which is not
// 0.
inline double median_ratio(const std::vector<double>& times, const std::vector<double>& base) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(times[i] / base[i]);
  return median(ratios);
}

}  // namespace refitlab
