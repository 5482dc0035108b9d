// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/build_tree.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// A BinaryNode is one of the binary tree before pruning.
struct BinaryNode {
  Ball3<double> ball;
  int first_triangle, triangle_count;
  int children[2] = {-1, -1};
  bool is_leaf() const { return children[0] < 0; }
};

// Each child gets at least one of so many of its parent's triangles, so that trees are not deep.
constexpr int least_share = 4;

class Builder {
 public:
  Builder(const SkinnedMesh& mesh, const JointSets& sets, const TreeOptions& options)
      : mesh_(mesh),
        sets_(sets),
        options_(options) {}

  SphereTree build() {
    for (const Triangle& t : mesh_.triangles)
      centroids_.push_back((mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]) / 3);
    tree_.triangle_order.resize(mesh_.triangles.size());
    std::iota(tree_.triangle_order.begin(), tree_.triangle_order.end(), 0);
    split(0, static_cast<int>(mesh_.triangles.size()));
    flatten();
    for (TreeNode& node : tree_.nodes) add_joint_sets(node);
    return std::move(tree_);
  }

 private:
  std::span<int> triangles(int first, int count) {
    return {tree_.triangle_order.data() + first, static_cast<std::size_t>(count)};
  }

  // Makes the binary node of these triangles and all below it. Returns its index.
  int split(int first, int count) {
    const int index = static_cast<int>(binary_.size());
    std::vector<Point3> points;
    for (const int v : distinct_vertices(mesh_, triangles(first, count))) points.push_back(mesh_.vertices[v]);
    binary_.push_back({rounded_up(as_ball(smallest_ball<double, 3>(points))), first, count});
    if (count <= options_.triangles_per_leaf) return index;

    const int left_count = part(triangles(first, count));
    const int left = split(first, left_count);
    const int right = split(first + left_count, count - left_count);
    binary_[index].children[0] = left;
    binary_[index].children[1] = right;
    return index;
  }

  // Orders the triangles so that those of the left child come first, and returns how many these are.
  int part(std::span<int> range) const {
    const int count = static_cast<int>(range.size()), least = std::max(1, count / least_share);
    std::vector<int> order(range.begin(), range.end());
    std::vector<double> extents_from(range.size());  // of what is from a place on
    std::pair best(infinite, count);
    int left_count = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::sort(order.begin(), order.end(),
                [&](int a, int b) { return std::pair(centroids_[a][axis], a) < std::pair(centroids_[b][axis], b); });
      Box<double> left = Box<double>::empty(), right = Box<double>::empty();
      for (int i = count - 1; i >= least; --i) merge(order[i], right), extents_from[i] = right.extent();
      bool is_best = false;
      for (int i = 1; i <= count - least; ++i) {
        merge(order[i - 1], left);
        if (i < least) continue;
        // If costs are the same, as where no triangles differ, the sides are to be as equal as can be.
        const std::pair cost(i * left.extent() + (count - i) * extents_from[i], std::abs(count - 2 * i));
        if (cost < best) best = cost, left_count = i, is_best = true;
      }
      if (is_best) std::copy(order.begin(), order.end(), range.begin());
    }
    return left_count;
  }

  void merge(int triangle, Box<double>& box) const {
    for (const int v : mesh_.triangles[triangle]) box.merge(mesh_.vertices[v]);
  }

  // Appends the binary nodes that become the children of one with this radius. They are those that stay, in order.
  void kept_children(int binary, double radius, std::vector<int>& out) const {
    for (const int child : binary_[binary].children) {
      const BinaryNode& c = binary_[child];
      if (!c.is_leaf() && c.ball.radius > options_.prune_ratio * radius) kept_children(child, radius, out);
      else out.push_back(child);
    }
  }

  // Writes the nodes level by level into the flat array. The queue of binary nodes runs parallel to it.
  void flatten() {
    std::vector<int> source{0};
    tree_.nodes.push_back(node_of(0, -1, 1));
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
      if (binary_[source[i]].is_leaf()) {
        add_leaf_vertices(tree_.nodes[i]);
        continue;
      }
      std::vector<int> children;
      kept_children(source[i], tree_.nodes[i].reference.radius, children);
      tree_.nodes[i].first_child = static_cast<int>(tree_.nodes.size());
      tree_.nodes[i].child_count = static_cast<int>(children.size());
      for (const int c : children) {
        tree_.nodes.push_back(node_of(c, static_cast<int>(i), tree_.nodes[i].level + 1));
        source.push_back(c);
      }
    }
  }

  TreeNode node_of(int binary, int parent, int level) const {
    const BinaryNode& b = binary_[binary];
    return {.reference = b.ball,
            .parent = parent,
            .first_child = 0,
            .child_count = 0,
            .level = level,
            .first_triangle = b.first_triangle,
            .triangle_count = b.triangle_count,
            .first_vertex = 0,
            .vertex_count = 0,
            .first_piece = 0,
            .piece_count = 0};
  }

  void add_leaf_vertices(TreeNode& leaf) {
    const auto vertices = distinct_vertices(mesh_, triangles(leaf.first_triangle, leaf.triangle_count));
    leaf.first_vertex = static_cast<int>(tree_.leaf_vertices.size());
    leaf.vertex_count = static_cast<int>(vertices.size());
    tree_.leaf_vertices.insert(tree_.leaf_vertices.end(), vertices.begin(), vertices.end());
  }

  // Adds the joint-sets, weight bounds and weight vertices of a node's vertices.
  void add_joint_sets(TreeNode& node) {
    std::map<int, WeightBounds<double>> bounds;
    for (const int v : distinct_vertices(mesh_, triangles(node.first_triangle, node.triangle_count))) {
      const auto w = sets_.weights(v);
      auto& b =
          bounds.try_emplace(sets_.of_vertex(v), WeightBounds<double>{{w.begin(), w.end()}, {w.begin(), w.end()}}).first->second;
      for (std::size_t i = 0; i < w.size(); ++i) {
        b.low[i] = std::min(b.low[i], w[i]);
        b.high[i] = std::max(b.high[i], w[i]);
      }
    }
    node.first_piece = static_cast<int>(tree_.pieces.size());
    node.piece_count = static_cast<int>(bounds.size());
    for (const auto& [set, b] : bounds) {
      const auto weight_vertices = weight_vertices_or_simplex(b);
      tree_.pieces.push_back({set, static_cast<int>(tree_.weight_vertices.size()), static_cast<int>(weight_vertices.size())});
      for (const auto& c : weight_vertices) tree_.weight_vertices.insert(tree_.weight_vertices.end(), c.begin(), c.end());
    }
  }

  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const TreeOptions options_;
  std::vector<Point3> centroids_;
  std::vector<BinaryNode> binary_;
  SphereTree tree_;
};

}  // namespace

SphereTree build_sphere_tree(const SkinnedMesh& mesh, const JointSets& sets, const TreeOptions& options) {
  const DefaultFloatEnvironment environment;
  if (options.triangles_per_leaf < 1)
    throw std::invalid_argument("a leaf of the sphere tree needs room for at least one triangle, not " +
                                std::to_string(options.triangles_per_leaf));
  return Builder(mesh, sets, options).build();
}

}  // namespace refitlab
