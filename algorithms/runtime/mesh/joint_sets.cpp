// SPDX-License-Identifier: MIT
#include "algorithms/runtime/mesh/joint_sets.hpp"

#include <map>

namespace refitlab {

JointSets::JointSets(const SkinnedMesh& mesh) {
  std::map<std::vector<int>, int> index;
  for (const auto& influences : mesh.influences) {
    std::vector<int> joints;
    first_weight_.push_back(weights_.size());
    for (const Influence& i : influences) {
      joints.push_back(i.joint);
      weights_.push_back(i.weight);
    }
    const auto [entry, is_new] = index.try_emplace(joints, count());
    if (is_new) joints_.push_back(joints);
    of_vertex_.push_back(entry->second);
  }
}

}  // namespace refitlab
