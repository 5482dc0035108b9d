// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/sphere_tree.hpp"

#include <algorithm>

namespace refitlab {

std::vector<int> distinct_vertices(const SkinnedMesh& mesh, std::span<const int> triangles) {
  std::vector<int> out;
  for (const int t : triangles) out.insert(out.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

NodeVertices::NodeVertices(const SphereTree& tree, const SkinnedMesh& mesh) {
  for (const TreeNode& n : tree.nodes) {
    first_.push_back(vertices_.size());
    const auto own =
        distinct_vertices(mesh, {tree.triangle_order.data() + n.first_triangle, static_cast<std::size_t>(n.triangle_count)});
    vertices_.insert(vertices_.end(), own.begin(), own.end());
  }
  first_.push_back(vertices_.size());
}

}  // namespace refitlab
