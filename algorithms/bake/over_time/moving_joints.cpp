// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/moving_joints.hpp"

#include <numeric>

namespace refitlab {

void check_finite(const MovingJoints& joints, const PosedJoints& posed, const std::string& moment) {
  const Model& model = joints.model();
  for (std::size_t j = 0; j < posed.matrices.size(); ++j)
    if (!posed.matrices[j].allFinite())
      throw ModelError(model.name, joints.name() + ", joint '" + model.joints[j].name + "', time " + moment,
                       "the skin matrix is not finite");
  for (const Eigen::VectorXd& weights : posed.weights)
    if (!weights.allFinite())
      throw ModelError(model.name, joints.name() + ", time " + moment, "a weight of a morph target is not finite");
}

std::vector<ParameterMoment> corners_of(const ParameterBox& box) {
  std::vector<ParameterMoment> corners(std::size_t(1) << box.ranges.size(), {{}, box.signs});
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (std::size_t i = 0; i < box.ranges.size(); ++i) {
      const ParameterRange& range = box.ranges[i];
      if ((c >> i & 1) != 0) corners[c].coordinates.push_back({range.end, side_of_end(range.start, range.end)});
      else corners[c].coordinates.push_back({range.start, Side::after});
    }
  return corners;
}

std::vector<int> indices_below(std::size_t count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace refitlab
