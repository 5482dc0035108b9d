// SPDX-License-Identifier: MIT
// A joint-set is a distinct set of joints that influence a vertex (paper 3, J(v)). Each vertex has its weights in its joint-set.
#pragma once

#include <span>
#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

class JointSets {
 public:
  explicit JointSets(const SkinnedMesh& mesh);

  int count() const { return static_cast<int>(joints_.size()); }
  // Returns the joints of one joint-set, in increasing order.
  std::span<const int> joints(int joint_set) const { return joints_[joint_set]; }
  // Returns the index of the joint-set that a vertex belongs to.
  int of_vertex(int vertex) const { return of_vertex_[vertex]; }
  // Returns the weights of a vertex, in the order of its joint-set's joints. All are positive, and their sum is exactly 1.
  std::span<const double> weights(int vertex) const {
    return {weights_.data() + first_weight_[vertex], joints_[of_vertex_[vertex]].size()};
  }

 private:
  std::vector<std::vector<int>> joints_;
  std::vector<int> of_vertex_;
  std::vector<std::size_t> first_weight_;
  std::vector<double> weights_;
};

}  // namespace refitlab
