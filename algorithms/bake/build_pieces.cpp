// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/build_pieces.hpp"

#include <algorithm>
#include <map>
#include <queue>

#include "algorithms/bake/build_displacements.hpp"
#include "algorithms/bake/weight_hull.hpp"
#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// A Cluster has vertices of one joint-set, and the sizes by which a piece is judged.
struct Cluster {
  int joint_set;
  std::vector<int> vertices;
  Ball3<double> ball;
  double spread;        // how far a refit may be off: the ball's radius and the extent of the weights, in model units
  double displacement;  // how far morph targets may take vertices from each other, relative to the node's radius
};

class Clustering {
 public:
  Clustering(const SkinnedMesh& mesh, const JointSets& sets, double radius, double extent)
      : mesh_(mesh),
        sets_(sets),
        radius_(radius),
        extent_(extent) {}

  Cluster make(int joint_set, std::vector<int> vertices) const {
    std::vector<Point3> points;
    for (const int v : vertices) points.push_back(mesh_.vertices[v]);
    Cluster c{joint_set, std::move(vertices), rounded_up(as_ball(smallest_ball<double, 3>(points))), 0, 0};
    c.spread = c.ball.radius + extent_ * weight_range(c).second;
    if (mesh_.targets.count > 0)
      for (const TargetBall& by : build_displacements(mesh_, {&c.vertices, 1}).balls) c.displacement += by.ball.radius / radius_;
    return c;
  }

  // Halves a cluster at the median of its widest coordinate, which is that of a position, or a weight (scaled to the node's
  // size).
  std::pair<Cluster, Cluster> split(const Cluster& c) const {
    Point3 low = mesh_.vertices[c.vertices[0]], high = low;
    for (const int v : c.vertices) low = low.cwiseMin(mesh_.vertices[v]), high = high.cwiseMax(mesh_.vertices[v]);
    int axis;
    const double widest = (high - low).maxCoeff(&axis);
    const auto [weight, range] = weight_range(c);
    const bool by_weight = extent_ * range > widest;
    const auto key = [&, w = weight](int v) { return by_weight ? sets_.weights(v)[w] : mesh_.vertices[v][axis]; };
    std::vector<int> order = c.vertices;
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
    std::nth_element(order.begin(), middle, order.end(),
                     [&](int a, int b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    return {make(c.joint_set, {order.begin(), middle}), make(c.joint_set, {middle, order.end()})};
  }

 private:
  // Returns the joint (by position) whose weights vary most, and by how much.
  std::pair<int, double> weight_range(const Cluster& c) const {
    std::pair<int, double> widest{0, 0};
    for (std::size_t i = 0; i < sets_.joints(c.joint_set).size(); ++i) {
      double low = 1, high = 0;
      for (const int v : c.vertices) low = std::min(low, sets_.weights(v)[i]), high = std::max(high, sets_.weights(v)[i]);
      if (high - low > widest.second) widest = {static_cast<int>(i), high - low};
    }
    return widest;
  }

  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  double radius_;  // of the node
  double extent_;  // the length that a full change of weight counts as
};

class NodeClusters {
 public:
  NodeClusters(const SkinnedMesh& mesh, const JointSets& sets, const PieceOptions& options)
      : mesh_(mesh),
        sets_(sets),
        options_(options) {}

  std::vector<Cluster> of(const TreeNode& node, std::span<const int> vertices) const {
    const Clustering clustering(mesh_, sets_, node.reference.radius, options_.weight_extent * node.reference.radius);
    int most = std::max(options_.most_pieces, static_cast<int>(options_.pieces_per_joint_set * node.piece_count));
    std::map<int, std::vector<int>> by_set;
    for (const int v : vertices) by_set[sets_.of_vertex(v)].push_back(v);
    const auto less = [](const Cluster& a, const Cluster& b) { return a.spread < b.spread; };
    std::priority_queue<Cluster, std::vector<Cluster>, decltype(less)> queue(less);
    std::vector<Cluster> done;
    bool are_rigid = true;
    for (auto& [set, own] : by_set) {
      queue.push(clustering.make(set, std::move(own)));
      are_rigid = are_rigid && sets_.joints(set).size() == 1;
    }
    if (are_rigid) most = std::max(most, options_.stretched_pieces);
    while (!queue.empty() && static_cast<int>(queue.size() + done.size()) < most) {
      const Cluster widest = queue.top();
      queue.pop();
      if (widest.vertices.size() == 1 || is_better_as_vertices(widest, weight_vertices_of(widest))) {
        done.push_back(widest);
        continue;
      }
      auto [a, b] = clustering.split(widest);
      queue.push(std::move(a));
      queue.push(std::move(b));
    }
    for (; !queue.empty(); queue.pop()) done.push_back(queue.top());
    std::stable_sort(done.begin(), done.end(), [](const Cluster& a, const Cluster& b) { return a.joint_set < b.joint_set; });
    return done;
  }

  std::vector<std::vector<double>> weight_vertices_of(const Cluster& c) const {
    std::vector<std::span<const double>> weights;
    for (const int v : c.vertices) weights.push_back(sets_.weights(v));
    return weight_polytope(weights);
  }

  bool is_better_as_vertices(const Cluster& c, const std::vector<std::vector<double>>& weight_vertices) const {
    if (c.displacement > options_.least_displacement && c.vertices.size() <= options_.most_displaced_vertices) return true;
    if (weight_vertices.size() == 1 && c.vertices.size() <= options_.most_stretched_vertices) return true;
    const auto m = static_cast<double>(weight_vertices.size());
    return static_cast<double>(c.vertices.size()) <= options_.vertices_per_control_point * m * (m + 1) * (m + 2) / 6;
  }

 private:
  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const PieceOptions& options_;
};

// Puts the pieces that touch the smallest ball of all first. The others stay in order.
void order_by_support(std::span<NodePiece> pieces, const std::vector<Ball3<double>>& references) {
  std::vector<Ball3<double>> balls;
  for (const auto& piece : pieces) balls.push_back(references[piece.reference]);
  const auto smallest = few_balls_ball(balls);
  std::vector<int> support(smallest.support.begin(), smallest.support.begin() + smallest.support_size);
  std::sort(support.begin(), support.end());
  for (std::size_t k = 0; k < support.size(); ++k)
    std::rotate(pieces.begin() + k, pieces.begin() + support[k], pieces.begin() + support[k] + 1);
}

}  // namespace

PieceTable build_pieces(const SphereTree& tree, const NodeVertices& vertices, const SkinnedMesh& mesh, const JointSets& sets,
                        const PieceOptions& options) {
  const DefaultFloatEnvironment environment;
  PieceTable table;
  // The vertices are in the order of the leaves, so that those of a node lie close together.
  std::vector<std::vector<int>> vertices_of;                           // by reference
  std::vector<NodePiece> listed(mesh.vertices.size(), {-1, 0, 1, 0});  // by vertex
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    if (tree.nodes[n].child_count > 0) continue;
    for (const int v : vertices[static_cast<int>(n)]) {
      if (listed[v].joint_set >= 0) continue;
      const auto weights = sets.weights(v);
      listed[v] = {sets.of_vertex(v), static_cast<int>(table.weight_vertices.size()), 1,
                   static_cast<int>(table.references.size())};
      table.weight_vertices.insert(table.weight_vertices.end(), weights.begin(), weights.end());
      table.references.push_back({mesh.vertices[v], 0});
      vertices_of.push_back({v});
    }
  }
  const NodeClusters clusters(mesh, sets, options);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    table.first.push_back(table.pieces.size());
    const auto of_node = clusters.of(tree.nodes[n], vertices[static_cast<int>(n)]);
    for (const Cluster& c : of_node) {
      const auto weight_vertices = clusters.weight_vertices_of(c);
      const bool is_exact = of_node.size() == 1 && weight_vertices.size() == 1 && c.displacement <= options.least_displacement &&
                            c.vertices.size() > options.most_stretched_vertices;
      if (c.vertices.size() == 1 || (!is_exact && clusters.is_better_as_vertices(c, weight_vertices))) {
        for (const int v : c.vertices) table.pieces.push_back(listed[v]);
        continue;
      }
      table.pieces.push_back({c.joint_set, static_cast<int>(table.weight_vertices.size()),
                              static_cast<int>(weight_vertices.size()), static_cast<int>(table.references.size())});
      table.references.push_back(c.ball);
      vertices_of.push_back(c.vertices);
      for (const auto& weight_vertex : weight_vertices)
        table.weight_vertices.insert(table.weight_vertices.end(), weight_vertex.begin(), weight_vertex.end());
    }
    order_by_support({table.pieces.data() + table.first.back(), table.pieces.size() - table.first.back()}, table.references);
  }
  table.first.push_back(table.pieces.size());
  table.displacements = build_displacements(mesh, vertices_of);
  return table;
}

}  // namespace refitlab
