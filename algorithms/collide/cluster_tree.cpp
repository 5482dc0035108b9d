#include "algorithms/collide/cluster_tree.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/packs/float_environment.hpp"

namespace refitlab {
namespace {

void check(const ClusterOptions& o) {
  if (o.most_triangles < 1 || o.most_triangles > most_cluster_triangles)
    throw std::invalid_argument("cluster options: most_triangles is " + std::to_string(o.most_triangles) +
                                ", not in 1 to " + std::to_string(most_cluster_triangles));
  if (o.most_children < 2)
    throw std::invalid_argument("cluster options: most_children is " + std::to_string(o.most_children) +
                                ", less than 2");
}

}  // namespace

ClusterTree::ClusterTree(const Character& character, const ClusterOptions& options)
    : character_(&character), options_(options), vertices_(character.model, character.sets, {}) {
  const DefaultFloatEnvironment environment;
  check(options);
  add_fan(0);
  pack_clusters();
}

// The node of most triangles that is no cluster is opened as long as there is room for its children. A root that is a
// cluster is a fan of itself.
int ClusterTree::add_fan(int node) {
  const SphereTree& tree = character_->tree;
  const auto is_cluster = [&](int n) {
    return tree.nodes[n].triangle_count <= options_.most_triangles || tree.nodes[n].child_count == 0;
  };
  std::vector<int> open{node};
  for (bool is_first = true;; is_first = false) {
    const auto most = std::max_element(open.begin(), open.end(), [&](int a, int b) {
      return std::pair(!is_cluster(a), tree.nodes[a].triangle_count) <
             std::pair(!is_cluster(b), tree.nodes[b].triangle_count);
    });
    const TreeNode& n = tree.nodes[*most];
    if (is_cluster(*most) || (!is_first && static_cast<int>(open.size()) - 1 + n.child_count > options_.most_children))
      break;
    const int first = n.first_child;
    *most = first;
    for (int c = first + 1; c < first + n.child_count; ++c) open.push_back(c);
  }
  // In the order of their triangles, so that neighbours in the fan are neighbours in space.
  std::sort(open.begin(), open.end(),
            [&](int a, int b) { return tree.nodes[a].first_triangle < tree.nodes[b].first_triangle; });

  const int fan = static_cast<int>(fans_.size());
  const std::vector<NodePiece> pieces = pieces_of_nodes(*character_, open);
  fans_.push_back({static_cast<int>(children_.size()), static_cast<int>(open.size()),
                   make_box_pieces(*character_, pieces), make_reach_packs(*character_, pieces)});
  children_.resize(children_.size() + open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    const FanChild child = is_cluster(open[i]) ? FanChild{add_cluster(open[i]), -1} : FanChild{-1, add_fan(open[i])};
    children_[fans_[fan].first_child + i] = child;
  }
  return fan;
}

int ClusterTree::add_cluster(int node) {
  const TreeNode& n = character_->tree.nodes[node];
  clusters_.push_back({0, static_cast<int>(groups_.size()), (n.triangle_count + group_size - 1) / group_size});
  groups_.resize(groups_.size() + clusters_.back().group_count);
  cluster_nodes_.push_back(node);
  return static_cast<int>(clusters_.size()) - 1;
}

void ClusterTree::pack_clusters() {
  const Model& model = character_->model;
  std::vector<std::vector<int>> vertices;
  for (const int node : cluster_nodes_)
    vertices.emplace_back(character_->vertices[node].begin(), character_->vertices[node].end());
  vertices_ = PackedVertices(model, character_->sets, vertices);
  std::vector<std::uint16_t> place_of(model.vertices.size());
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    Cluster& cluster = clusters_[c];
    const auto places = vertices_.vertices(static_cast<int>(c));
    cluster.corner_count = static_cast<int>(places.size());
    for (std::size_t p = 0; p < places.size(); ++p) place_of[places[p]] = static_cast<std::uint16_t>(p);

    const TreeNode& node = character_->tree.nodes[cluster_nodes_[c]];
    for (int t = 0; t < node.triangle_count; ++t) {
      TriangleGroup& group = groups_[cluster.first_group + t / group_size];
      const int triangle = character_->tree.triangle_order[node.first_triangle + t];
      group.count = t % group_size + 1;
      group.triangles[t % group_size] = triangle;
      for (int i = 0; i < 3; ++i) group.corners[t % group_size][i] = place_of[model.triangles[triangle][i]];
    }
  }
}

}  // namespace refitlab
