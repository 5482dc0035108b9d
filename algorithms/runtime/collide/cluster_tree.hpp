// ClusterTree: a character as the fast queries see it. Wide fans of bounded nodes on top, clusters of triangles below.
//
// Bounding a node costs more than skinning the few vertices under it once it is small, so bounds end at clusters of
// some hundred triangles; what is inside a cluster that a query reaches is skinned and put into boxes. Above, nodes are
// bounded many at a time: a fan is the set of descendants that one node is opened into, all refitted together.
#pragma once

#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/reach_packs.hpp"
#include "algorithms/runtime/collide/triangle_group.hpp"

namespace refitlab {

// So that places fit 16 bits even if each corner is alone in its joint-set, and so in eight lanes.
inline constexpr int most_cluster_triangles = (1 << 16) / (3 * Lanes<double>::count);

struct ClusterOptions {
  int most_triangles = 256;  // of a cluster; from 1 to most_cluster_triangles
  int most_children = 16;    // of a fan, at least 2; but a node of the sphere tree that has more makes a fan of its own
};

struct Cluster {
  int corner_count;  // the places of its group of vertices()
  int first_group, group_count;
};

// A node in a fan: a cluster, or opened into a fan of its own.
struct FanChild {
  int cluster, fan;  // one of them is -1
};

struct Fan {
  int first_child, child_count;       // all children in one list
  BoxPieces pieces;                   // what bounds the children, by position in the fan
  std::vector<ReachPiecePack> reach;  // what bounds them from the joints alone; none if that cannot be
};

class ClusterTree {
 public:
  // character outlives this. Throws std::invalid_argument for options out of range.
  explicit ClusterTree(const Character& character, const ClusterOptions& options = {});

  const Character& character() const { return *character_; }
  const std::vector<Fan>& fans() const { return fans_; }  // the root's first; its children are fans with larger indices
  const FanChild& child(int fan, int i) const { return children_[fans_[fan].first_child + i]; }
  const std::vector<Cluster>& clusters() const { return clusters_; }
  int group_count() const { return static_cast<int>(groups_.size()); }
  // By position in the cluster; those behind it follow.
  const TriangleGroup& group(int cluster, int i) const { return groups_[clusters_[cluster].first_group + i]; }
  const PackedVertices& vertices() const { return vertices_; }  // a group for each cluster

 private:
  // Triangles side by side in SphereTree::triangle_order: those of a node, or some of a leaf's, which is halved until
  // clusters have as few as they should.
  struct Part {
    int node;  // -1 for some of a leaf's
    int first_triangle, triangle_count;
  };

  Part part_of_node(int node) const;
  std::vector<Part> children_of(const Part& part) const;
  std::vector<int> vertices_of(const Part& part) const;
  int add_fan(const Part& part);
  int add_cluster(const Part& part);
  void pack_clusters();

  const Character* character_;
  ClusterOptions options_;
  std::vector<Fan> fans_;
  std::vector<FanChild> children_;
  std::vector<Cluster> clusters_;
  std::vector<TriangleGroup> groups_;
  std::vector<Part> cluster_parts_;
  PackedVertices vertices_;
};

}  // namespace refitlab
