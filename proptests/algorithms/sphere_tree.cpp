// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/tree/sphere_tree.hpp"

#include <algorithm>
#include <ctime>
#include <map>
#include <set>

#include "algorithms/bake/build_tree.hpp"
#include "algorithms/bake/weight_vertices.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/smallest_ball.hpp"
#include "proptests/oracles/weight_vertices.hpp"

namespace proptests::suite_sphere_tree {
namespace {

using namespace refitlab;

// It is a prune ratio that keeps all nodes.
constexpr double keep_all = 1e300;

std::set<int> vertices_below(const SphereTree& tree, const SkinnedMesh& model, const TreeNode& n) {
  std::set<int> out;
  for (int k = 0; k < n.triangle_count; ++k)
    for (const int v : model.triangles[tree.triangle_order[n.first_triangle + k]]) out.insert(v);
  return out;
}

// Returns what is wrong with the arrays of the tree, or nothing.
std::string structural_fault(const SphereTree& tree, const SkinnedMesh& model, const TreeOptions& options) {
  const auto& nodes = tree.nodes;
  std::set<int> all(tree.triangle_order.begin(), tree.triangle_order.end());
  if (all.size() != model.triangles.size() || tree.triangle_order.size() != all.size() || *all.begin() != 0 ||
      *all.rbegin() + 1 != static_cast<int>(all.size()))
    return "the order is no permutation of the triangles";
  if (nodes[0].parent != -1 || nodes[0].level != 1 || nodes[0].first_triangle != 0 ||
      nodes[0].triangle_count != static_cast<int>(all.size()))
    return "root";
  int next = 1, leaf_triangles = 0, levels = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const TreeNode& n = nodes[i];
    levels = std::max(levels, n.level);
    if (i > 0 && n.level < nodes[i - 1].level) return "levels out of order";
    if (n.triangle_count < 1) return "a node without triangles";
    if (n.child_count == 0) {
      leaf_triangles += n.triangle_count;
      if (n.triangle_count > options.triangles_per_leaf) return "a leaf that is too large";
      const auto below = vertices_below(tree, model, n);
      if (std::vector<int>(below.begin(), below.end()) !=
          std::vector<int>(tree.leaf_vertices.begin() + n.first_vertex,
                           tree.leaf_vertices.begin() + n.first_vertex + n.vertex_count))
        return "vertices of a leaf";
      continue;
    }
    if (n.triangle_count <= options.triangles_per_leaf) return "an inner node that could be a leaf";
    if (n.vertex_count != 0) return "an inner node with vertices of its own";
    if (n.child_count < 2 || n.first_child != next) return "children";
    next += n.child_count;
    int first = n.first_triangle;
    for (int c = 0; c < n.child_count; ++c) {
      const TreeNode& child = nodes[n.first_child + c];
      if (child.parent != static_cast<int>(i) || child.level != n.level + 1) return "parent or level of a child";
      if (child.first_triangle != first) return "children do not partition their parent";
      first += child.triangle_count;
    }
    if (first != n.first_triangle + n.triangle_count) return "children do not hold all triangles of their parent";
  }
  if (next != static_cast<int>(nodes.size())) return "nodes without a parent";
  if (leaf_triangles != static_cast<int>(all.size())) return "triangles in no leaf or in two";
  return levels == tree.level_count() ? "" : "number of levels";
}

// Returns a fault unless the balls hold their vertices exactly, and none is larger than needed.
std::string ball_fault(const SphereTree& tree, const SkinnedMesh& model) {
  for (const TreeNode& n : tree.nodes) {
    std::vector<Ball<Rational, 3>> points;
    Ball<Rational, 3> ball{convert<Rational>(n.reference.center), Rational(n.reference.radius)};
    for (const int v : vertices_below(tree, model, n)) {
      points.push_back({convert<Rational>(model.vertices[v]), Rational(0)});
      if (encloses(ball, points.back().center) != Verdict::holds) return "a ball misses a vertex";
    }
    if (points.size() > 12) continue;
    const auto optimum = oracle::smallest_ball_by_cgal<3>(points).radius;
    if (optimum < ball.radius * Rational(1 - 1e-9) - Rational(1e-14)) return "a ball that is larger than needed";
  }
  return "";
}

std::vector<oracle::ExactWeights> rows_of(const SphereTree& tree, const NodePiece& set, std::size_t width) {
  std::vector<oracle::ExactWeights> rows;
  for (int k = 0; k < set.weight_vertex_count; ++k) {
    const auto first = tree.weight_vertices.begin() + set.first_weight + k * static_cast<long>(width);
    rows.emplace_back(first, first + static_cast<long>(width));
  }
  return rows;
}

// Returns a fault unless the joint-sets of a node are those of its vertices, and their weight vertices those of the vertices'
// weight bounds.
std::string weight_fault(const SphereTree& tree, const SkinnedMesh& model, const JointSets& sets) {
  for (const TreeNode& n : tree.nodes) {
    std::map<int, std::vector<oracle::ExactWeights>> weights;
    for (const int v : vertices_below(tree, model, n)) {
      const auto w = sets.weights(v);
      weights[sets.of_vertex(v)].emplace_back(w.begin(), w.end());
    }
    if (static_cast<int>(weights.size()) != n.piece_count) return "number of joint-sets";
    for (int k = 0; k < n.piece_count; ++k) {
      const NodePiece& set = tree.pieces[n.first_piece + k];
      if (!weights.count(set.joint_set)) return "a joint-set that no vertex has";
      const auto& own = weights[set.joint_set];
      const auto bounds = oracle::bounds_around(own);
      const auto rows = rows_of(tree, set, own[0].size());
      const auto weight_vertices = oracle::weight_vertices(bounds);
      if (weight_vertices.size() > weight_vertex_limit
              ? rows != low_bound_simplex(bounds)
              : rows.size() != weight_vertices.size() || std::set(rows.begin(), rows.end()) != weight_vertices)
        return "weight_vertices";
    }
  }
  return "";
}

// Such a range of triangles names a node of the binary tree.
using Range = std::pair<int, int>;

// Returns a fault unless pruning takes exactly the inner nodes that are larger than their share of the nearest node above that
// stays.
std::string pruning_fault(const SphereTree& pruned, const SphereTree& binary, double ratio) {
  std::map<Range, const TreeNode*> kept;
  for (const TreeNode& n : pruned.nodes) kept[{n.first_triangle, n.triangle_count}] = &n;
  if (pruned.triangle_order != binary.triangle_order) return "order of triangles";
  std::size_t found = 0;
  // This is the radius of the nearest kept node, which may be the node itself.
  std::vector<double> radius_above(binary.nodes.size());
  for (std::size_t i = 0; i < binary.nodes.size(); ++i) {
    const TreeNode& n = binary.nodes[i];
    const bool is_kept = kept.count({n.first_triangle, n.triangle_count}) > 0;
    found += is_kept;
    if (n.child_count == 0 || i == 0) {
      if (!is_kept) return "a leaf or the root went";
    } else if (is_kept == (n.reference.radius > ratio * radius_above[n.parent])) {
      return is_kept ? "a node stayed that is too large" : "a node went that is small enough";
    }
    radius_above[i] = is_kept ? n.reference.radius : radius_above[n.parent];
  }
  return found == kept.size() ? "" : "nodes that the binary tree does not have";
}

// Returns the sum of the edges of the box around the first i triangles, for each i.
std::vector<double> extents_of_first(const SkinnedMesh& model, const std::vector<int>& triangles) {
  std::vector<double> out{0};
  Point3 low = Point3::Constant(infinite), high = -low;
  for (const int t : triangles) {
    for (const int v : model.triangles[t]) low = low.cwiseMin(model.vertices[v]), high = high.cwiseMax(model.vertices[v]);
    out.push_back((high - low).sum());
  }
  return out;
}

// Returns the cost of each way to split the triangles in their order, by how many come first. What leaves less than a quarter of
// them on a side costs infinitely much.
std::vector<double> split_costs(const SkinnedMesh& model, std::vector<int> triangles) {
  const std::size_t n = triangles.size(), least = std::max<std::size_t>(1, n / 4);
  const auto left = extents_of_first(model, triangles);
  std::reverse(triangles.begin(), triangles.end());
  const auto right = extents_of_first(model, triangles);
  std::vector<double> out(n + 1, infinite);
  for (std::size_t i = least; i + least <= n; ++i)
    out[i] = static_cast<double>(i) * left[i] + static_cast<double>(n - i) * right[n - i];
  return out;
}

// Returns a fault unless each node is split in two where it costs least, to within rounding, along the axis where it does.
std::string split_fault(const SphereTree& binary, const SkinnedMesh& model) {
  const auto centroid = [&](int triangle) {
    const Triangle& t = model.triangles[triangle];
    return Point3((model.vertices[t[0]] + model.vertices[t[1]] + model.vertices[t[2]]) / 3);
  };
  for (const TreeNode& n : binary.nodes) {
    if (n.child_count == 0) continue;
    if (n.child_count != 2) return "halves";
    const auto first = binary.triangle_order.begin() + n.first_triangle;
    std::vector<int> triangles(first, first + n.triangle_count);
    const int of_left = binary.nodes[n.first_child].triangle_count;
    const double own = split_costs(model, triangles)[of_left];
    double least = infinite;
    bool is_sorted = false;
    for (int axis = 0; axis < 3; ++axis) {
      const auto is_less = [&](int a, int b) { return std::pair(centroid(a)[axis], a) < std::pair(centroid(b)[axis], b); };
      is_sorted = is_sorted || !is_less(*std::min_element(triangles.begin() + of_left, triangles.end(), is_less),
                                        *std::max_element(triangles.begin(), triangles.begin() + of_left, is_less));
      auto sorted = triangles;
      std::sort(sorted.begin(), sorted.end(), is_less);
      for (const double cost : split_costs(model, sorted)) least = std::min(least, cost);
    }
    if (!is_sorted) return "not split along an axis";
    if (!(own <= least * (1 + 1e-12))) return "split where it costs more, or too far from the middle";
  }
  return "";
}

TreeOptions draw_options() {
  return {.triangles_per_leaf = *rc::gen::element(1, 1, 2, 3, 8), .prune_ratio = *rc::gen::element(0.0, 0.5, 0.9, 1.0, keep_all)};
}

void single_trees(Suite& t) {
  t.example("triangles that no split tells apart are halved", {}, [] {
    SkinnedMesh model;
    model.name = "triangles";
    model.joints = {{"only", -1, {0, 0, 0}}};
    bool ok = true;
    for (const double size : {0.0, 1.0, 1e40}) {
      model.vertices = {{-size, 0, 0}, {size, 0, 0}, {0, size, 0}};
      model.influences.assign(3, {{0, 1}});
      model.triangles.assign(37, {0, 1, 2});
      for (const TreeNode& n : build_sphere_tree(model, JointSets(model), {1, keep_all}).nodes) ok = ok && n.level <= 7;
    }
    return ok;
  });
  t.example("a leaf without triangles is refused", {}, [] {
    const SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 3, 3, 1, 1});
    try {
      build_sphere_tree(model, JointSets(model), {.triangles_per_leaf = 0});
    } catch (const std::invalid_argument& e) {
      return std::string(e.what()).find("not 0") != std::string::npos;
    }
    return false;
  });
  t.example("the trees of the built-in models are right, and built in less than a second of processor time", {}, [] {
    std::string detail;
    bool all = true;
    for (const SkinnedMesh& model : {make_man(), make_creature()}) {
      const JointSets sets(model);
      const TreeOptions options;
      const std::clock_t start = std::clock();
      const auto tree = build_sphere_tree(model, sets, options);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      const std::string fault = structural_fault(tree, model, options);
      const auto binary = build_sphere_tree(model, sets, {1, keep_all});
      all = all && fault.empty() && pruning_fault(tree, binary, 0.9).empty() && split_fault(binary, model).empty() && seconds < 1;
      detail += model.name + ": " + std::to_string(tree.nodes.size()) + " nodes, " + std::to_string(tree.level_count()) +
                " levels, " + std::to_string(seconds) + " s" + (fault.empty() ? "" : ", " + fault) + "; ";
    }
    return Checked(all, 2, detail);
  });
}

}  // namespace

PROPTEST(sphere_tree) {
  t.holds("every triangle is in one leaf, children partition their parent, levels and leaf vertices are right",
          {.number_type = "double", .cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const SkinnedMesh model = gen::make_mesh(plan);
            const TreeOptions options = draw_options();
            const auto tree = build_sphere_tree(model, JointSets(model), options);
            RC_ASSERT(structural_fault(tree, model, options) == "");
            const NodeVertices listed(tree, model);
            for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
              const auto own = vertices_below(tree, model, tree.nodes[i]);
              const auto span = listed[static_cast<int>(i)];
              RC_ASSERT(std::vector<int>(span.begin(), span.end()) == std::vector<int>(own.begin(), own.end()));
            }
          });
  t.holds("each ball holds its vertices and is the smallest that does",
          {.number_type = "rational", .cases = 100, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const SkinnedMesh model = gen::make_mesh(plan);
            RC_ASSERT(ball_fault(build_sphere_tree(model, JointSets(model), draw_options()), model) == "");
          });
  t.holds("the joint-sets of a node are those of its vertices, with all weight vertices of their weights' bounds",
          {.number_type = "rational", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const SkinnedMesh model = gen::make_mesh(plan);
            const JointSets sets(model);
            RC_ASSERT(weight_fault(build_sphere_tree(model, sets, draw_options()), model, sets) == "");
          });
  t.holds("pruning takes the inner nodes that are too large for what is above them, and no others",
          {.number_type = "double", .cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const SkinnedMesh model = gen::make_mesh(plan);
            const TreeOptions options = draw_options();
            const JointSets sets(model);
            const auto tree = build_sphere_tree(model, sets, options);
            const auto binary = build_sphere_tree(model, sets, {options.triangles_per_leaf, keep_all});
            RC_ASSERT(pruning_fault(tree, binary, options.prune_ratio) == "");
            RC_ASSERT(split_fault(binary, model) == "");
            if (options.triangles_per_leaf == 1) RC_ASSERT(binary.nodes.size() == 2 * model.triangles.size() - 1);
            for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
              const TreeNode& n = tree.nodes[i];
              if (n.child_count > 0 && n.parent >= 0)
                RC_ASSERT(n.reference.radius <= options.prune_ratio * tree.nodes[n.parent].reference.radius);
            }
          });
  single_trees(t);
}

}  // namespace proptests::suite_sphere_tree
