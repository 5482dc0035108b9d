// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/check_character.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace refitlab {
namespace {

// A level halves the triangles. The sizes of what is made of a tree grow with its levels.
constexpr int most_levels = 64;

// Returns whether first, ..., first + count - 1 are indices of a list.
bool is_range(long first, long count, std::size_t size) {
  return first >= 0 && count >= 0 && static_cast<std::size_t>(first + count) <= size;
}

bool is_ball(const Ball3<double>& ball) {
  // A greatest coefficient of some with a NaN may be another.
  return ball.center.allFinite() && ball.center.cwiseAbs().maxCoeff() <= largest_coordinate * (1 + 1e-12) && ball.radius >= 0 &&
         ball.radius <= 4 * largest_coordinate;
}

// Checks pieces that have their weight vertices in one list. Each weight is looked at once.
class PieceCheck {
 public:
  PieceCheck(const JointSets& sets, const std::vector<double>& weights) : sets_(sets), weights_(weights) {}

  // Returns what is wrong with a piece, or nothing.
  std::string fault_of(const NodePiece& piece) {
    if (piece.joint_set < 0 || piece.joint_set >= sets_.count()) return "names a joint-set out of range";
    const auto joints = static_cast<long>(sets_.joints(piece.joint_set).size());
    if (piece.weight_vertex_count < 1 || !is_range(piece.first_weight, piece.weight_vertex_count * joints, weights_.size()))
      return "names weight vertices out of range";
    const Range range{piece.first_weight + piece.weight_vertex_count * joints, piece.joint_set};
    const auto next = seen_.lower_bound(piece.first_weight);
    if (next != seen_.end() && next->first == piece.first_weight && next->second == range) return "";
    if ((next != seen_.end() && next->first < range.end) ||
        (next != seen_.begin() && std::prev(next)->second.end > piece.first_weight))
      return "names weight vertices of another one";
    seen_.emplace_hint(next, piece.first_weight, range);
    for (long k = 0; k < piece.weight_vertex_count; ++k) {
      double sum = 0;
      for (long i = 0; i < joints; ++i) {
        const double weight = weights_[piece.first_weight + k * joints + i];
        if (!(weight >= 0 && weight <= 1)) return "has a weight vertex with a weight that is not in [0, 1]";
        sum += weight;
      }
      if (sum != 1) return "has a weight vertex whose weights do not sum to 1";
    }
    return "";
  }

 private:
  struct Range {
    long end;
    int joint_set;
    bool operator==(const Range&) const = default;
  };
  const JointSets& sets_;
  const std::vector<double>& weights_;
  std::map<int, Range> seen_;  // by the first weight
};

// Returns what is wrong with the displacements of so many balls, or nothing.
std::string fault_of(const DisplacementTable& table, std::size_t balls, int targets) {
  if (table.first.empty()) return targets > 0 || !table.balls.empty() ? "are missing" : "";
  if (table.first.size() != balls + 1 || table.first.front() != 0 || table.first.back() != table.balls.size() ||
      !std::is_sorted(table.first.begin(), table.first.end()))
    return "are not of as many balls as there are";
  for (std::size_t i = 0; i < balls; ++i) {
    int last = -1;
    for (const TargetBall& by : table[i]) {
      if (by.target <= last || by.target >= targets) return "are not by increasing targets of the mesh";
      if (!is_ball(by.ball)) return "have a ball that is none";
      last = by.target;
    }
  }
  return "";
}

class TreeCheck {
 public:
  TreeCheck(const SphereTree& tree, const SkinnedMesh& mesh, const JointSets& sets, const std::string& file)
      : tree_(tree),
        mesh_(mesh),
        sets_(sets),
        file_(file) {}

  void run() const {
    if (tree_.nodes.empty()) throw ModelError(file_, "tree", "has no nodes");
    std::vector<int> order = tree_.triangle_order;
    std::sort(order.begin(), order.end());
    bool is_permutation = order.size() == mesh_.triangles.size();
    for (std::size_t i = 0; i < order.size() && is_permutation; ++i) is_permutation = order[i] == static_cast<int>(i);
    if (!is_permutation) throw ModelError(file_, "tree", "does not have each triangle once");
    const TreeNode& root = tree_.nodes[0];
    require(root.parent == -1 && root.level == 1, 0, "is no root");
    require(root.first_triangle == 0 && root.triangle_count == static_cast<int>(order.size()), 0, "does not have all triangles");
    int next_child = 1, next_piece = 0;
    PieceCheck pieces(sets_, tree_.weight_vertices);
    for (int n = 0; n < static_cast<int>(tree_.nodes.size()); ++n) {
      const TreeNode& node = tree_.nodes[n];
      require(is_ball(node.reference), n, "its ball is none");
      require(node.level <= most_levels, n, "is below more than 63 others");
      check_pieces_of(n, next_piece, pieces);
      next_piece += node.piece_count;
      require(node.child_count >= 0, n, "has less than no children");
      if (node.child_count == 0) {
        check_leaf(n);
        continue;
      }
      require(node.first_child == next_child && is_range(next_child, node.child_count, tree_.nodes.size()), n,
              "its children are not those that follow");
      check_children(n);
      next_child += node.child_count;
    }
    require(next_child == static_cast<int>(tree_.nodes.size()), next_child - 1, "is followed by a node without a parent");
    if (const auto fault = fault_of(tree_.displacements, tree_.nodes.size(), mesh_.targets.count); !fault.empty())
      throw ModelError(file_, "tree", "its displacements " + fault);
  }

 private:
  void require(bool condition, int node, const char* reason) const {
    if (!condition) throw ModelError(file_, "node " + std::to_string(node), reason);
  }

  void check_pieces_of(int n, int next_piece, PieceCheck& pieces) const {
    const TreeNode& node = tree_.nodes[n];
    require(node.piece_count > 0 && is_range(node.first_piece, node.piece_count, tree_.pieces.size()), n,
            "names joint-sets out of range");
    require(node.first_piece == next_piece, n, "its joint-sets are not those that follow");
    for (int i = node.first_piece; i < node.first_piece + node.piece_count; ++i) {
      require(tree_.pieces[i].reference == 0, n, "a joint-set names a ball, and the node has but one");
      if (const auto fault = pieces.fault_of(tree_.pieces[i]); !fault.empty())
        throw ModelError(file_, "node " + std::to_string(n), "a joint-set " + fault);
    }
  }

  void check_leaf(int n) const {
    const TreeNode& leaf = tree_.nodes[n];
    require(is_range(leaf.first_vertex, leaf.vertex_count, tree_.leaf_vertices.size()), n, "names vertices out of range");
    const auto own = std::span(tree_.leaf_vertices).subspan(leaf.first_vertex, leaf.vertex_count);
    const auto expected =
        distinct_vertices(mesh_, std::span(tree_.triangle_order).subspan(leaf.first_triangle, leaf.triangle_count));
    require(std::equal(own.begin(), own.end(), expected.begin(), expected.end()), n,
            "its vertices are not those of its triangles");
  }

  void check_children(int n) const {
    const TreeNode& node = tree_.nodes[n];
    long next_triangle = node.first_triangle;
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const TreeNode& child = tree_.nodes[c];
      require(child.parent == n && child.level == node.level + 1, c, "is not the child of its parent");
      require(child.first_triangle == next_triangle && child.triangle_count > 0 && child.triangle_count <= node.triangle_count, c,
              "its triangles are not part of its parent's");
      next_triangle += child.triangle_count;
    }
    require(next_triangle == node.first_triangle + node.triangle_count, n, "its children do not have all of its triangles");
  }

  const SphereTree& tree_;
  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const std::string& file_;
};

}  // namespace

void check_tree(const SphereTree& tree, const SkinnedMesh& mesh, const JointSets& sets, const std::string& file) {
  TreeCheck(tree, mesh, sets, file).run();
}

void check_pieces(const PieceTable& table, const SphereTree& tree, const SkinnedMesh& mesh, const JointSets& sets,
                  const std::string& file) {
  const auto require = [&](bool condition, const char* reason) {
    if (!condition) throw ModelError(file, "pieces", reason);
  };
  if (table.first.empty())
    return require(table.pieces.empty() && table.references.empty() && table.weight_vertices.empty() &&
                       table.displacements.first.empty() && table.displacements.balls.empty(),
                   "belong to no node");
  require(table.first.size() == tree.nodes.size() + 1, "are not of as many nodes as there are");
  require(table.first.front() == 0 && table.first.back() == table.pieces.size() &&
              std::is_sorted(table.first.begin(), table.first.end()),
          "are not in the order of the nodes");
  require(std::adjacent_find(table.first.begin(), table.first.end()) == table.first.end(), "are missing for a node");
  require(std::all_of(table.references.begin(), table.references.end(), is_ball), "have a ball that is none");
  PieceCheck pieces(sets, table.weight_vertices);
  for (const NodePiece& piece : table.pieces) {
    require(piece.reference >= 0 && static_cast<std::size_t>(piece.reference) < table.references.size(),
            "name a ball out of range");
    if (const auto fault = pieces.fault_of(piece); !fault.empty()) throw ModelError(file, "pieces", "one " + fault);
  }
  if (const auto fault = fault_of(table.displacements, table.references.size(), mesh.targets.count); !fault.empty())
    throw ModelError(file, "pieces", "their displacements " + fault);
}

}  // namespace refitlab
