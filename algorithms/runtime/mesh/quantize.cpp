// SPDX-License-Identifier: MIT
#include "algorithms/runtime/mesh/quantize.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

std::vector<std::pair<int, double>> quantize_weights(const std::vector<std::pair<int, double>>& weights,
                                                     std::vector<std::pair<int, double>>* lost) {
  const DefaultFloatEnvironment environment;
  double largest = 0;
  for (const auto& [joint, weight] : weights) largest = std::max(largest, weight);
  const int exponent = std::ilogb(largest);
  std::map<int, double> by_joint;
  double sum = 0;
  for (const auto& [joint, weight] : weights) {  // scaled by a power of two: the sum of huge weights is not finite
    by_joint[joint] += std::ldexp(weight, -exponent);
    sum += std::ldexp(weight, -exponent);
  }

  struct Part {
    int joint;
    double share;
    std::int64_t units;
    double remainder;
  };
  std::vector<Part> parts;
  std::int64_t missing = std::int64_t{1} << weight_bits;
  for (const auto& [joint, weight] : by_joint) {
    const double share = weight / sum, exact = std::ldexp(share, weight_bits);
    const double units = std::floor(exact);
    parts.push_back({joint, share, static_cast<std::int64_t>(units), exact - units});
    missing -= parts.back().units;
  }
  // The rest that rounding down left goes to the largest remainders, a unit each. There are enough of them: a remainder is less
  // than a unit, and all of them sum to what is missing, up to rounding that is far below a unit for any count of joints.
  std::vector<std::size_t> order(parts.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return parts[a].remainder > parts[b].remainder; });
  for (std::int64_t i = 0; i < missing; ++i) ++parts[order[i]].units;

  std::vector<std::pair<int, double>> out;
  if (lost) lost->clear();
  for (const Part& p : parts) {
    if (p.units > 0) out.emplace_back(p.joint, std::ldexp(static_cast<double>(p.units), -weight_bits));
    else if (lost && p.share > 0) lost->emplace_back(p.joint, p.share);
  }
  return out;
}

}  // namespace refitlab
