// SPDX-License-Identifier: MIT
#include "algorithms/methods/refit/deformed.hpp"

#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

Ball3<double> smallest_of(std::span<const int> vertices, std::span<const Point3> deformed, std::vector<Point3>& scratch) {
  scratch.clear();
  for (const int v : vertices) scratch.push_back(deformed[v]);
  return as_ball(smallest_ball<double, 3>(scratch));
}

}  // namespace

std::vector<Ball3<double>> optimal_balls(const SphereTree& tree, const NodeVertices& vertices, std::span<const Point3> deformed) {
  const DefaultFloatEnvironment environment;
  std::vector<Ball3<double>> out;
  std::vector<Point3> scratch;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    out.push_back(smallest_of(vertices[static_cast<int>(n)], deformed, scratch));
  return out;
}

std::vector<Ball3<double>> refit_bottom_up(const SphereTree& tree, std::span<const Point3> deformed) {
  const DefaultFloatEnvironment environment;
  std::vector<Ball3<double>> out(tree.nodes.size());
  std::vector<Point3> scratch;
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {  // children come after their parent
    const TreeNode& node = tree.nodes[n];
    if (node.child_count == 0)
      out[n] = smallest_of({tree.leaf_vertices.data() + node.first_vertex, static_cast<std::size_t>(node.vertex_count)}, deformed,
                           scratch);
    else out[n] = few_balls_enclosing({out.data() + node.first_child, static_cast<std::size_t>(node.child_count)});
  }
  return out;
}

}  // namespace refitlab
