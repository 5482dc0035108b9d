// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/model_of_nodes.hpp"

namespace proptests::gen {

refitlab::Model model_of_nodes(const std::string& name, const std::vector<refitlab::SceneNode>& nodes) {
  refitlab::Model model;
  model.name = model.skeleton.file = name;
  model.skeleton.nodes = nodes;
  for (int n = 0; n < static_cast<int>(nodes.size()); ++n) {
    const refitlab::SceneNode& node = nodes[static_cast<std::size_t>(n)];
    model.skeleton.joints.push_back({node.name, n, node.parent, Eigen::Matrix4d::Identity()});
    model.joints.push_back({node.name, node.parent, refitlab::Point3::Zero()});
  }
  return model;
}

}  // namespace proptests::gen
