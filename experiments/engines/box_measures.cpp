// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/box_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refitlab {

double area_of_box(const Box<double>& box) {
  const Vec<double, 3> e = box.edges();
  return 2 * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
}

BoxMeasures::BoxMeasures(const std::vector<std::string>& methods, std::size_t reference) : reference_(reference) {
  for (const std::string& method : methods) sums_.push_back({method});
}

void BoxMeasures::add(const Box<double>& truth, const std::vector<Box<double>>& boxes, double error,
                      const std::function<Verdict(std::size_t)>& decide) {
  for (std::size_t m = 0; m < sums_.size(); ++m) {
    BoxMeasure& sum = sums_[m];
    const double volume = volume_of_box(boxes[m]), ratio = volume / volume_of_box(truth), by = beyond_box(truth, boxes[m]);
    ++sum.poses;
    if (!std::isfinite(volume)) {
      ++sum.unbounded;
      continue;
    }
    if (volume_of_box(truth) > 0) {
      sum.volume += ratio;
      sum.area += area_of_box(boxes[m]) / area_of_box(truth);
      sum.radius += boxes[m].edges().norm() / truth.edges().norm();
      sum.to_reference += volume / volume_of_box(boxes[reference_]);
    } else {
      ++sum.flat;
    }
    const Verdict missed = by > error ? Verdict::holds : by < -error ? Verdict::fails : !decide(m);
    sum.undecided += missed == Verdict::undecided;
    sum.misses += missed == Verdict::holds;
    const double share = by / std::max(truth.edges().maxCoeff(), std::numeric_limits<double>::min());
    if (missed == Verdict::holds) sum.missed_by = std::max(sum.missed_by, share);
  }
}

std::vector<BoxMeasure> BoxMeasures::measures() const {
  std::vector<BoxMeasure> out = sums_;
  for (BoxMeasure& m : out)
    for (double* mean : {&m.volume, &m.area, &m.radius, &m.to_reference})
      *mean /= static_cast<double>(std::max(1L, m.with_ratios()));
  return out;
}

}  // namespace refitlab
