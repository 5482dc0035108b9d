// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/triangles_filter.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

Filtered filter_triangles(const TrianglePoints& a, const TrianglePoints& b) {
  const DefaultFloatEnvironment environment;
  const PlaneSides<double> of_b(a, b);
  if (of_b.are_one()) return Filtered::apart;
  const PlaneSides<double> of_a(b, a);
  if (of_a.are_one()) return Filtered::apart;
  if (!of_a.are_certain() || !of_b.are_certain()) return Filtered::unknown;
  const auto gap = sign_of_gap(of_a, of_b, a, b);
  return gap.is_positive ? Filtered::apart : gap.is_negative ? Filtered::meet : Filtered::unknown;
}

}  // namespace refitlab
