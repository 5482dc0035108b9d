// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_tree.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/runtime/collide/motion_piece_merger.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/packs/look_up.hpp"

namespace refitlab {
namespace {

void check(const ClusterOptions& o) {
  if (o.most_triangles < 1 || o.most_triangles > most_cluster_triangles)
    throw std::invalid_argument("cluster options: most_triangles is " + std::to_string(o.most_triangles) + ", not in 1 to " +
                                std::to_string(most_cluster_triangles));
  if (o.most_children < 2)
    throw std::invalid_argument("cluster options: most_children is " + std::to_string(o.most_children) + ", less than 2");
}

// Returns the joint-sets in the order of the clusters, so that those of neighbours are near each other.
std::vector<int> by_clusters(const ClusterTree& tree) {
  const int count = tree.character().sets.count();
  std::vector<int> out;
  std::vector<bool> is_listed(count, false);
  const auto list = [&](int set) {
    if (!is_listed[set]) is_listed[set] = true, out.push_back(set);
  };
  for (int c = 0; c < static_cast<int>(tree.clusters().size()); ++c)
    for (const FloatRun& run : tree.floats().runs(c)) list(run.joint_set);
  for (int set = 0; set < count; ++set) list(set);  // those that no triangle has
  return out;
}

}  // namespace

ClusterTree::ClusterTree(const Character& character, const ClusterOptions& options)
    : character_(&character),
      options_(options),
      vertices_(character.mesh, character.sets, {}),
      floats_(character.mesh, character.sets, vertices_) {
  const DefaultFloatEnvironment environment;
  check(options);
  MotionPieceMerger merger(character);
  add_wide_node(part_of_node(0), merger);
  pack_clusters();
}

ClusterTree::Part ClusterTree::part_of_node(int node) const {
  const TreeNode& n = character_->tree.nodes[node];
  return {node, n.first_triangle, n.triangle_count};
}

std::vector<ClusterTree::Part> ClusterTree::children_of(const Part& part) const {
  std::vector<Part> out;
  const TreeNode& n = character_->tree.nodes[part.node];
  for (int c = n.first_child; c < n.first_child + n.child_count; ++c) out.push_back(part_of_node(c));
  if (!out.empty()) return out;
  const int half = part.triangle_count / 2;
  return {{part.node, part.first_triangle, half}, {part.node, part.first_triangle + half, part.triangle_count - half}};
}

// Returns the distinct vertices of a part in increasing order.
std::vector<int> ClusterTree::vertices_of(const Part& part) const {
  if (is_whole(part)) {
    const auto vertices = character_->vertices[part.node];
    return {vertices.begin(), vertices.end()};
  }
  return distinct_vertices(character_->mesh,
                           std::span(character_->tree.triangle_order).subspan(part.first_triangle, part.triangle_count));
}

// The part with the most triangles is opened as long as it is too large for a cluster and there is room for its children. A root
// that is a cluster is a wide node of itself.
int ClusterTree::add_wide_node(const Part& part, MotionPieceMerger& merger) {
  const auto is_cluster = [&](const Part& p) { return p.triangle_count <= options_.most_triangles; };
  std::vector<Part> open{part};
  for (bool is_first = true;; is_first = false) {
    const auto most = std::max_element(open.begin(), open.end(),
                                       [](const Part& a, const Part& b) { return a.triangle_count < b.triangle_count; });
    if (is_cluster(*most)) break;
    const std::vector<Part> below = children_of(*most);
    if (!is_first && open.size() - 1 + below.size() > static_cast<std::size_t>(options_.most_children)) break;
    *most = below[0];
    open.insert(open.end(), below.begin() + 1, below.end());
  }
  // The parts are sorted in the order of their triangles, so that neighbours in the wide node are neighbours in space.
  std::sort(open.begin(), open.end(), [](const Part& a, const Part& b) { return a.first_triangle < b.first_triangle; });

  const int wide_node = static_cast<int>(wide_nodes_.size());
  std::vector<std::vector<int>> vertices;
  for (const Part& p : open) vertices.push_back(vertices_of(p));
  const std::vector<SimplexPiece> pieces = pieces_of_vertices(*character_, vertices);
  wide_nodes_.push_back({static_cast<int>(children_.size()), static_cast<int>(open.size()), make_box_pieces(*character_, pieces),
                         make_motion_bound_packs(*character_, merger.pieces(vertices)), pieces});
  children_.resize(children_.size() + open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    const WideNodeChild child = is_cluster(open[i]) ? WideNodeChild{add_cluster(open[i]), -1, open[i].node}
                                                    : WideNodeChild{-1, add_wide_node(open[i], merger), open[i].node};
    children_[wide_nodes_[wide_node].first_child + i] = child;
    (child.cluster >= 0 ? clusters_[child.cluster].place : wide_nodes_[child.wide_node].place) = {wide_node, static_cast<int>(i)};
  }
  return wide_node;
}

int ClusterTree::add_cluster(const Part& part) {
  const int first_triangle = clusters_.empty() ? 0 : clusters_.back().first_triangle + clusters_.back().triangle_count;
  clusters_.push_back({0, 0, first_triangle, part.triangle_count, {}});
  cluster_parts_.push_back(part);
  return static_cast<int>(clusters_.size()) - 1;
}

void ClusterTree::pack_clusters() {
  const SkinnedMesh& mesh = character_->mesh;
  std::vector<std::vector<int>> groups;
  for (const Part& part : cluster_parts_) groups.push_back(vertices_of(part));
  vertices_ = PackedVertices(mesh, character_->sets, groups, Lanes<float>::count);
  floats_ = FloatVertices(mesh, character_->sets, vertices_);
  std::vector<std::uint16_t> position_of(mesh.vertices.size());
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    Cluster& cluster = clusters_[c];
    const auto vertices = vertices_.vertices(static_cast<int>(c));
    const auto places = floats_.places(static_cast<int>(c));
    cluster.padded_vertex_count = static_cast<int>(vertices.size());
    cluster.first_vertex = c == 0 ? 0 : clusters_[c - 1].first_vertex + clusters_[c - 1].padded_vertex_count;
    most_room_ = std::max(most_room_, floats_.room(static_cast<int>(c)));
    most_triangles_ = std::max(most_triangles_, cluster.triangle_count);
    for (std::size_t p = 0; p < places.size(); ++p) position_of[vertices[places[p]]] = static_cast<std::uint16_t>(p);

    const Part& part = cluster_parts_[c];
    for (int t = 0; t < part.triangle_count; ++t) {
      const int triangle = character_->tree.triangle_order[part.first_triangle + t];
      triangles_.push_back(triangle);
      for (int i = 0; i < 3; ++i) triangle_vertices_[i].push_back(position_of[mesh.triangles[triangle][i]]);
    }
  }
  for (auto& positions : triangle_vertices_) positions.resize(positions.size() + short_look_up_size(1));
}

const WayOfSkinning& ClusterTree::way_of(Skinning skinning) const {
  auto& way = ways_->all[static_cast<std::size_t>(skinning)];
  std::call_once(ways_->are_made[static_cast<std::size_t>(skinning)], [&] {
    const Character& c = *character_;
    way.reset(
        new WayOfSkinning{MotionBound(c.mesh, c.sets, skinning), PalettePacks(c.mesh, c.sets, skinning, by_clusters(*this))});
  });
  return *way;
}

}  // namespace refitlab
