// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/joint_anchors.hpp"

#include <algorithm>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/collide/pose_change_kernel.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/packs/look_up.hpp"

namespace refitlab {

JointAnchors make_joint_anchors(const std::vector<std::vector<Point3>>& points) {
  const DefaultFloatEnvironment environment;
  JointAnchors out;
  out.joint_count = static_cast<int>(points.size());
  out.stride = look_up_size(out.joint_count);
  out.numbers.resize(rows_of_anchors * out.stride / Lanes<float>::count);
  float* const rows = out.numbers.data()->lane.data();
  std::fill_n(rows + 3 * out.stride, out.stride, -1.F);
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (points[j].empty()) continue;
    Point3 anchor = smallest_ball<double, 3>(points[j]).center;
    for (int i = 0; i < 3; ++i) {
      float& number = rows[static_cast<std::size_t>(i) * out.stride + j];
      anchor[i] = number = static_cast<float>(anchor[i]);
    }
    double radius = 0;
    for (const Point3& p : points[j]) {
      radius = std::max(radius, (p - anchor).norm() * (1 + 1e-12));
      out.farthest = std::max({out.farthest, p.norm(), anchor.norm()});
    }
    rows[3 * static_cast<std::size_t>(out.stride) + j] = float_above(radius);
  }
  return out;
}

}  // namespace refitlab
