// ClusterTree: a character as the fast queries see it. Few wide fans of bounded nodes on top, clusters of triangles below.
//
// Bounding a node costs more than skinning the few vertices under it once it is small, so bounds end at clusters of some
// hundred triangles; what is inside a cluster that a query reaches is skinned and put into boxes. Above, nodes are bounded many
// at a time: a fan is the set of descendants that one node is opened into, all refitted together.
#pragma once

#include <array>

#include "algorithms/collide/box_packs.hpp"
#include "algorithms/refit/character.hpp"

namespace refitlab {

struct ClusterOptions {
  int most_triangles = 256;  // of a cluster; at least 1
  int most_children = 32;    // of a fan; at least 2
};

inline constexpr int group_size = 8;  // triangles that are boxed together inside a cluster

struct Cluster {
  int first_vertex, vertex_count;  // in ClusterTree::vertices
  int first_group, group_count;
};

// Up to group_size triangles of a cluster.
struct TriangleGroup {
  int count;
  std::array<int, group_size> triangles;                          // of the model
  std::array<std::array<std::uint16_t, 3>, group_size> corners;  // by position among the cluster's vertices
};

// A node in a fan: a cluster, or opened into a fan of its own.
struct FanChild {
  int cluster, fan;  // one of them is -1
};

struct Fan {
  int first_child, child_count;  // in ClusterTree::children
  BoxPieces pieces;              // what bounds the children, by position in the fan
};

class ClusterTree {
 public:
  // character outlives this. Throws std::invalid_argument for options out of range.
  explicit ClusterTree(const Character& character, const ClusterOptions& options = {});

  const Character& character() const { return *character_; }
  const std::vector<Fan>& fans() const { return fans_; }  // the root's first; its children are fans with larger indices
  const std::vector<FanChild>& children() const { return children_; }
  const std::vector<Cluster>& clusters() const { return clusters_; }
  const std::vector<TriangleGroup>& groups() const { return groups_; }
  // Of the model, cluster by cluster, in each sorted by joint-set; a vertex of several clusters is in each of them.
  const std::vector<int>& vertices() const { return vertices_; }

 private:
  int add_fan(int node);
  int add_cluster(int node);

  const Character* character_;
  ClusterOptions options_;
  std::vector<Fan> fans_;
  std::vector<FanChild> children_;
  std::vector<Cluster> clusters_;
  std::vector<TriangleGroup> groups_;
  std::vector<int> vertices_;
};

}  // namespace refitlab
