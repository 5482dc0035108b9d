// SPDX-License-Identifier: MIT
// ClusterTree is a character as the fast queries see it. It has wide nodes of bounded nodes on top, and clusters of triangles
// below.
//
// Once a node is small, bounding it costs more than skinning the few vertices under it. So bounds end at clusters of some
// hundred triangles. If a query reaches a cluster, the cluster's content is skinned and put into boxes. Above, nodes are
// bounded many at a time: a wide node is the set of descendants that one node is opened into, all refitted together.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "algorithms/runtime/batch/float_vertices.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"
#include "algorithms/runtime/collide/motion_bound.hpp"

namespace refitlab {

// With this limit, places fit 16 bits even if each vertex is alone in its joint-set, and so in sixteen lanes.
inline constexpr int most_cluster_triangles = (1 << 16) / (3 * Lanes<float>::count);

struct ClusterOptions {
  int most_triangles = 256;  // triangles of a cluster; from 1 to most_cluster_triangles
  int most_children = 48;  // of a wide node, at least 2; but a node of the sphere tree that has more makes a wide node of its own
};

// A ChildPlace is that of a cluster or a wide node: it is a child of another wide node.
struct ChildPlace {
  int wide_node, child;  // which one, and which of its children; or -1
};

struct Cluster {
  int padded_vertex_count;  // the places of its group of vertices()
  int first_vertex;         // how many places the clusters before it have
  int first_triangle, triangle_count;
  ChildPlace place;
};

// A ClusterPair has a cluster of each of two bodies' trees.
struct ClusterPair {
  int first, second;
  bool operator==(const ClusterPair&) const = default;
};

// A child of a wide node is a cluster, or it is opened into a wide node of its own.
struct WideNodeChild {
  int cluster, wide_node;  // one of them is -1
  int node;                // of the sphere tree, which has all of its vertices
};

struct WideNode {
  int first_child, child_count;                     // all children in one list
  BoxPieces pieces;                                 // the pieces that bound the children, by position in the wide node
  std::vector<MotionBoundPiecePack> motion_bounds;  // the motion bounds of the children; empty where they do not apply
  std::vector<SimplexPiece> simplex_pieces;         // the same pieces one by one, for affine joints
  ChildPlace place = {-1, -1};                      // the root has none
};

// A WayOfSkinning is what all bodies of a tree that are skinned in one way have in common.
struct WayOfSkinning {
  MotionBound motion_bound;  // of which each body has a copy
  PalettePacks palettes;     // Joint-sets of clusters that are near each other are near each other in the packs.
};

class MotionPieceMerger;

class ClusterTree {
 public:
  // character must outlive this. Throws std::invalid_argument for options out of range.
  explicit ClusterTree(const Character& character, const ClusterOptions& options = {});

  const Character& character() const { return *character_; }
  // Returns the wide nodes, the root first. The children of one come after it.
  const std::vector<WideNode>& wide_nodes() const { return wide_nodes_; }
  const WideNodeChild& child(int wide_node, int i) const { return child({wide_node, i}); }
  const WideNodeChild& child(ChildPlace place) const { return children_[wide_nodes_[place.wide_node].first_child + place.child]; }
  const std::vector<Cluster>& clusters() const { return clusters_; }
  const PackedVertices& vertices() const { return vertices_; }  // a group for each cluster
  const FloatVertices& floats() const { return floats_; }       // the same, which has the positions
  // Returns what bodies that are skinned in this way share, which lives as long as the tree or a copy of it. It is made when it is
  // first asked for. Several threads may ask at a time.
  const WayOfSkinning& way_of(Skinning skinning) const;

  // Returns the triangles of a cluster: their vertices by position in it, and their indices in the model.
  ClusterTriangles cluster_triangles(int cluster) const {
    const Cluster& c = clusters_[cluster];
    const auto of = [&](int i) { return triangle_vertices_[i].data() + c.first_triangle; };
    return {c.triangle_count, {of(0), of(1), of(2)}};
  }
  const int* triangles(int cluster) const { return triangles_.data() + clusters_[cluster].first_triangle; }
  // These are the most triangles of a cluster, and the most room that a coordinate of its vertices in float takes.
  int most_triangles() const { return most_triangles_; }
  int most_room() const { return most_room_; }

 private:
  // A Part is a range of triangles side by side in SphereTree::triangle_order. They are those of a node, or some of a leaf's. A
  // leaf is halved until its clusters are small enough.
  struct Part {
    int node;  // the leaf, for some of its triangles
    int first_triangle, triangle_count;
  };

  // These are by Skinning, and made on demand.
  struct Ways {
    static constexpr std::size_t count = static_cast<std::size_t>(Skinning::dual_quaternion) + 1;

    std::array<std::once_flag, count> are_made;
    std::array<std::unique_ptr<const WayOfSkinning>, count> all;
  };

  bool is_whole(const Part& part) const {
    return part.triangle_count == character_->tree.nodes[static_cast<std::size_t>(part.node)].triangle_count;
  }

  Part part_of_node(int node) const;
  std::vector<Part> children_of(const Part& part) const;
  std::vector<int> vertices_of(const Part& part) const;
  int add_wide_node(const Part& part, MotionPieceMerger& merger);
  int add_cluster(const Part& part);
  void pack_clusters();

  const Character* character_;
  ClusterOptions options_;
  std::vector<WideNode> wide_nodes_;
  std::vector<WideNodeChild> children_;
  std::vector<Cluster> clusters_;
  std::vector<Part> cluster_parts_;
  std::vector<std::uint16_t> triangle_vertices_[3];
  std::vector<int> triangles_;
  int most_triangles_ = 0, most_room_ = 0;
  PackedVertices vertices_;
  FloatVertices floats_;
  std::shared_ptr<Ways> ways_ = std::make_shared<Ways>();  // copies of the tree share them
};

}  // namespace refitlab
