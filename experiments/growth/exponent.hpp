// The exponent of a growth: the slope of the least-squares line through the logarithms.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace refitlab {

// e of the fit of x^e to y over points (x, y), all positive, of at least two different x.
inline double fitted_exponent(const std::vector<std::pair<double, double>>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& point : points) {
    const double a = std::log(point.first), b = std::log(point.second);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace refitlab
