#include "algorithms/collide/cluster_tree.hpp"

#include <algorithm>
#include <stdexcept>

namespace refitlab {
namespace {

void check(const ClusterOptions& o) {
  // Corners are stored in 16 bits, three a triangle at most.
  if (o.most_triangles < 1 || o.most_triangles > 65536 / 3)
    throw std::invalid_argument("cluster options: most_triangles is " + std::to_string(o.most_triangles) + ", not in 1 to 21845");
  if (o.most_children < 2)
    throw std::invalid_argument("cluster options: most_children is " + std::to_string(o.most_children) + ", less than 2");
}

}  // namespace

ClusterTree::ClusterTree(const Character& character, const ClusterOptions& options)
    : character_(&character), options_(options) {
  check(options);
  add_fan(0);
}

// The node of most triangles that is no cluster is opened as long as there is room for its children. A root that is a cluster
// is a fan of itself.
int ClusterTree::add_fan(int node) {
  const SphereTree& tree = character_->tree;
  const auto is_cluster = [&](int n) {
    return tree.nodes[n].triangle_count <= options_.most_triangles || tree.nodes[n].child_count == 0;
  };
  std::vector<int> open{node};
  for (bool is_first = true;; is_first = false) {
    const auto most = std::max_element(open.begin(), open.end(), [&](int a, int b) {
      return std::pair(!is_cluster(a), tree.nodes[a].triangle_count) < std::pair(!is_cluster(b), tree.nodes[b].triangle_count);
    });
    const TreeNode& n = tree.nodes[*most];
    if (is_cluster(*most) || (!is_first && static_cast<int>(open.size()) - 1 + n.child_count > options_.most_children)) break;
    const int first = n.first_child;
    *most = first;
    for (int c = first + 1; c < first + n.child_count; ++c) open.push_back(c);
  }
  // In the order of their triangles, so that neighbours in the fan are neighbours in space.
  std::sort(open.begin(), open.end(), [&](int a, int b) { return tree.nodes[a].first_triangle < tree.nodes[b].first_triangle; });

  const int fan = static_cast<int>(fans_.size());
  fans_.push_back({static_cast<int>(children_.size()), static_cast<int>(open.size()),
                   make_box_pieces(*character_, open)});
  children_.resize(children_.size() + open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    const FanChild child = is_cluster(open[i]) ? FanChild{add_cluster(open[i]), -1} : FanChild{-1, add_fan(open[i])};
    children_[fans_[fan].first_child + i] = child;
  }
  return fan;
}

int ClusterTree::add_cluster(int node) {
  const Model& model = character_->model;
  const JointSets& sets = character_->sets;
  const TreeNode& n = character_->tree.nodes[node];
  std::vector<int> vertices(character_->vertices[node].begin(), character_->vertices[node].end());
  std::stable_sort(vertices.begin(), vertices.end(), [&](int a, int b) { return sets.of_vertex(a) < sets.of_vertex(b); });
  const auto position = [&](int vertex) {
    const auto at = std::find(vertices.begin(), vertices.end(), vertex);
    return static_cast<std::uint16_t>(at - vertices.begin());
  };

  Cluster cluster{static_cast<int>(vertices_.size()), static_cast<int>(vertices.size()), static_cast<int>(groups_.size()), 0};
  for (int first = 0; first < n.triangle_count; first += group_size) {
    TriangleGroup group{std::min(group_size, n.triangle_count - first), {}, {}};
    for (int i = 0; i < group.count; ++i) {
      group.triangles[i] = character_->tree.triangle_order[n.first_triangle + first + i];
      for (int c = 0; c < 3; ++c) group.corners[i][c] = position(model.triangles[group.triangles[i]][c]);
    }
    groups_.push_back(group);
    ++cluster.group_count;
  }
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  clusters_.push_back(cluster);
  return static_cast<int>(clusters_.size()) - 1;
}

}  // namespace refitlab
