// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the pieces of nodes: they hold all vertices, are split as the options say, and may be listed as vertices instead.
#include "algorithms/bake/build_pieces.hpp"

#include <algorithm>
#include <set>

#include "algorithms/bake/build_tree.hpp"
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"
#include "experiments/procedural/procedural.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/convex_combination.hpp"
#include "proptests/oracles/weight_vertices.hpp"

namespace proptests::suite_build_pieces {
namespace {

using namespace refitlab;

struct Rig {
  explicit Rig(SkinnedMesh m, const TreeOptions& options = {})
      : mesh(std::move(m)),
        sets(mesh),
        tree(build_sphere_tree(mesh, sets, options)),
        vertices(tree, mesh) {
    for (int s = 0; s < sets.count(); ++s) {
      palette.append(sets.joints(s).size());
      palette.complete(Point3::Zero());
    }
  }
  SkinnedMesh mesh;
  JointSets sets;
  SphereTree tree;
  NodeVertices vertices;
  SkinningPalette<double> palette;  // at rest
};

oracle::Row exact(std::span<const double> w) { return {w.begin(), w.end()}; }

std::vector<oracle::Row> weight_vertices_of(const RefitNode<double>& node, const NodePiece& piece) {
  std::vector<oracle::Row> rows;
  for (int k = 0; k < piece.weight_vertex_count; ++k) rows.push_back(exact(node.weight_vertex(piece, k)));
  return rows;
}

// Says exactly whether w is in the hull. For more than four weights a simplex search is too slow: there the weight vertices are
// rows, or those of a weight box.
bool in_hull(const std::vector<oracle::Row>& weight_vertices, const oracle::Row& w) {
  if (w.size() <= 4 || std::find(weight_vertices.begin(), weight_vertices.end(), w) != weight_vertices.end())
    return oracle::as_convex_combination(weight_vertices, w).has_value();
  const auto box = oracle::bounds_around(weight_vertices);
  for (std::size_t i = 0; i < w.size(); ++i)
    if (w[i] < box.low[i] || box.high[i] < w[i]) return false;
  return true;
}

bool in_ball(const Ball3<double>& ball, const Point3& v) {
  const Ball3<Rational> exact{convert<Rational>(ball.center), Rational(ball.radius)};
  return encloses<Rational, 3>(exact, convert<Rational>(v)) == Verdict::holds;
}

// Returns what is wrong with a node's pieces, or nothing. At most `most` of its vertices are looked at.
std::string fault(const Rig& rig, const PieceTable& table, int n, const PieceOptions& options, std::size_t most) {
  const auto share = static_cast<int>(options.pieces_per_joint_set * rig.tree.nodes[n].piece_count);
  const int most_pieces = std::max(options.most_pieces, share);
  const auto node = table.refit_node(rig.tree, n, rig.palette);
  const auto of_node = rig.vertices[n];
  std::set<int> expected, seen;
  for (const int v : of_node) expected.insert(rig.sets.of_vertex(v));
  for (const auto& piece : node.pieces) seen.insert(piece.joint_set);
  if (seen != expected) return "the pieces' joint-sets are not those of the vertices";
  const auto by_set = [](const NodePiece& a, const NodePiece& b) { return a.joint_set < b.joint_set; };
  if (node.pieces.size() > 4 && !std::is_sorted(node.pieces.begin() + 4, node.pieces.end(), by_set))
    return "behind those that come first, the joint-sets are not in order";
  if (options.vertices_per_control_point == 0 &&
      node.pieces.size() > std::max<std::size_t>(expected.size(), static_cast<std::size_t>(most_pieces)))
    return "too many pieces";
  const auto simple = rig.tree.refit_node(n, rig.palette);
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    if (node.piece_reference(i).radius > simple.reference.radius * (1 + 1e-12)) return "a piece is larger than its node";
    for (const auto& set : simple.pieces)
      if (most_pieces == 1 && set.joint_set == node.pieces[i].joint_set &&
          node.pieces[i].weight_vertex_count > set.weight_vertex_count)
        return "more weight vertices than the weight box";
  }
  const std::size_t step = std::max<std::size_t>(1, of_node.size() / most);
  for (std::size_t i = 0; i < of_node.size(); i += step) {
    const int v = of_node[i];
    bool covered = false;
    for (std::size_t p = 0; p < node.pieces.size() && !covered; ++p)
      covered = node.pieces[p].joint_set == rig.sets.of_vertex(v) && in_ball(node.piece_reference(p), rig.mesh.vertices[v]) &&
                in_hull(weight_vertices_of(node, node.pieces[p]), exact(rig.sets.weights(v)));
    if (!covered) return "vertex " + std::to_string(v) + " is in no piece";
  }
  return "";
}

// Compares pieces with and without vertices in place of the cheap ones. Which of a node's pieces are listed vertex by vertex has
// to follow from their vertices and weight vertices alone. Counts the pieces of both kinds.
struct Listed {
  std::string wrong;
  long listed = 0, kept = 0;
};
void compare_lists(const Rig& rig, const PieceTable& plain, const PieceTable& mixed, double factor, int n, Listed& out) {
  const auto before = plain.refit_node(rig.tree, n, rig.palette), after = mixed.refit_node(rig.tree, n, rig.palette);
  std::vector<bool> found(after.pieces.size());
  // The pieces come in any order.
  const auto find = [&](auto&& is_it) {
    for (std::size_t at = 0; at < found.size(); ++at)
      if (!found[at] && is_it(after.pieces[at], after.piece_reference(at))) {
        found[at] = true;
        return true;
      }
    return false;
  };
  for (std::size_t i = 0; i < before.pieces.size() && out.wrong.empty(); ++i) {
    const NodePiece& piece = before.pieces[i];
    std::vector<int> own;
    for (const int v : rig.vertices[n])
      if (rig.sets.of_vertex(v) == piece.joint_set) own.push_back(v);
    const int m = piece.weight_vertex_count, control_points = m * (m + 1) * (m + 2) / 6;
    const bool exact_as_it_is = m == 1 && before.pieces.size() == 1;
    if (!exact_as_it_is && static_cast<double>(own.size()) <= factor * control_points) {
      ++out.listed;
      for (const int v : own)
        if (!find([&](const NodePiece& single, const Ball3<double>& reference) {
              return single.joint_set == piece.joint_set && single.weight_vertex_count == 1 && reference.radius == 0 &&
                     reference.center == rig.mesh.vertices[v] &&
                     exact(after.weight_vertex(single, 0)) == exact(rig.sets.weights(v));
            }))
          out.wrong = "vertex " + std::to_string(v) + " is not listed";
    } else {
      ++out.kept;
      if (!find([&](const NodePiece& same, const Ball3<double>& reference) {
            return same.joint_set == piece.joint_set && reference.radius == before.piece_reference(i).radius &&
                   weight_vertices_of(after, same) == weight_vertices_of(before, piece);
          }))
        out.wrong = "a piece of many vertices was changed";
    }
  }
  if (out.wrong.empty() && std::find(found.begin(), found.end(), false) != found.end()) out.wrong = "there are further pieces";
}

// Makes a rig of vertices alone: each becomes a triangle of one point, and the tree is one leaf.
struct Vertex {
  Point3 at;
  std::vector<Influence> influences;
};
Rig rig_of(const std::vector<Vertex>& vertices, int joints, MorphTargets targets = {}) {
  SkinnedMesh m;
  m.targets = std::move(targets);
  m.name = "vertices";
  for (int j = 0; j < joints; ++j) m.joints.push_back({"joint", -1, {0, 0, 0}});
  for (const Vertex& v : vertices) {
    const int i = static_cast<int>(m.vertices.size());
    m.triangles.push_back({i, i, i});
    m.vertices.push_back(v.at);
    m.influences.push_back(v.influences);
  }
  validate(m);
  return Rig(std::move(m), {.triangles_per_leaf = 1 << 20});
}

// Describes a piece at the root: its joint-set, its radius, and how far its weight vertices' first weights are apart.
struct RootPiece {
  std::vector<int> joints;
  double radius, weight_range;
};
std::vector<RootPiece> root_pieces(const Rig& rig, const PieceOptions& options) {
  const PieceTable table = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, options);
  const auto node = table.refit_node(rig.tree, 0, rig.palette);
  std::vector<RootPiece> out;
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    double low = 1, high = 0;
    for (int k = 0; k < node.pieces[i].weight_vertex_count; ++k) {
      low = std::min(low, node.weight_vertex(node.pieces[i], k)[0]);
      high = std::max(high, node.weight_vertex(node.pieces[i], k)[0]);
    }
    const auto joints = rig.sets.joints(node.pieces[i].joint_set);
    out.push_back({{joints.begin(), joints.end()}, node.piece_reference(i).radius, high - low});
  }
  return out;
}

const std::vector<Influence> rigid{{2, 1.0}};
// Returns influences of the weight part / of, for a part from 1 to of - 1.
std::vector<Influence> blended(int part, int of) {
  const double w = std::floor(0x1p24 * part / of) * 0x1p-24;
  return {{0, w}, {1, 1 - w}};
}

// Makes a ring of rigid vertices of this radius, and 32 vertices along the x axis. The weights of these have no relation to their
// places, and run from `least` of 64 parts in steps of one.
std::vector<Vertex> ring_and_row(double ring, double row_length, int least) {
  std::vector<Vertex> out;
  for (int k = 0; k < 16; ++k) out.push_back({{ring * std::cos(k * 0.392699), ring * std::sin(k * 0.392699), 0}, rigid});
  for (int k = 0; k < 32; ++k) out.push_back({{row_length * (k / 31. - 0.5), 0, 0}, blended(least + 13 * k % 32, 64)});
  return out;
}

Checked check_man(const PieceOptions& options) {
  static const Rig rig(make_man());
  const PieceTable table = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, options);
  long nodes = 0;
  const int count = static_cast<int>(rig.tree.nodes.size());
  for (int n = 0; n < count; n += n < 30 ? 1 : 61) {
    const std::string wrong = fault(rig, table, n, options, 40);
    if (!wrong.empty()) return Checked(false, nodes, "node " + std::to_string(n) + ": " + wrong);
    ++nodes;
  }
  return Checked(nodes > 100, nodes, std::to_string(table.pieces.size()) + " pieces for " + std::to_string(count) + " nodes");
}

void pieces_hold_all_vertices_and_get_smaller(Suite& t) {
  t.holds("every vertex is in a piece of its joint-set: in its ball, and in the hull of its weights",
          {.number_type = "rational", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const Rig rig(gen::make_mesh(plan));
            for (const PieceOptions& options : {PieceOptions{1}, {2}, {5}, {64}, {1, 1.5, 2.}, {3, 1, 0.5}, {1, 1.7}}) {
              const PieceTable table = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, options);
              for (int n = 0; n < static_cast<int>(rig.tree.nodes.size()); n += n < 12 ? 1 : 5)
                RC_ASSERT(fault(rig, table, n, options, 12) == "");
            }
          });
  t.holds("more pieces are smaller pieces: the largest of a node never grows, and as many as allowed are made",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const Rig rig(gen::make_mesh(plan));
            const PieceTable few = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {1});
            const bool per_set = *rc::gen::arbitrary<bool>();
            const PieceOptions options = per_set ? PieceOptions{1, 2.6} : PieceOptions{8};
            const PieceTable many = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, options);
            for (int n = 0; n < static_cast<int>(rig.tree.nodes.size()); ++n) {
              const auto a = few.refit_node(rig.tree, n, rig.palette), b = many.refit_node(rig.tree, n, rig.palette);
              const auto largest = [](const RefitNode<double>& node) {
                double r = 0;
                for (std::size_t i = 0; i < node.pieces.size(); ++i) r = std::max(r, node.piece_reference(i).radius);
                return r;
              };
              RC_ASSERT(largest(b) <= largest(a) * (1 + 1e-12));
              const std::size_t allowed = per_set ? 13 * a.pieces.size() / 5 : 8;
              RC_ASSERT(b.pieces.size() == std::max(a.pieces.size(), std::min(allowed, rig.vertices[n].size())));
            }
          });
  t.holds("the pieces that come first, at most four, have the same smallest ball as all of a node's pieces",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const Rig rig(gen::make_mesh(plan));
            const PieceOptions options = *rc::gen::element(PieceOptions{1}, PieceOptions{4}, PieceOptions{1, 4. / 3, 2});
            const PieceTable table = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, options);
            for (int n = 0; n < static_cast<int>(rig.tree.nodes.size()); ++n) {
              const auto node = table.refit_node(rig.tree, n, rig.palette);
              std::vector<Ball3<double>> all;
              for (std::size_t i = 0; i < node.pieces.size(); ++i) all.push_back(node.piece_reference(i));
              const std::vector<Ball3<double>> first(all.begin(), all.begin() + std::min<std::size_t>(4, all.size()));
              RC_ASSERT(smallest_ball_of_balls(first).radius >= smallest_ball_of_balls(all).radius * (1 - 1e-9));
            }
          });
}

void what_is_split_and_how(Suite& t) {
  t.example("the widest piece is split first: eight pieces of a tube of one joint are a fraction of it", {}, [] {
    const Rig rig(gen::make_mesh({gen::MeshKind::tube, 12, 4, 1, 2006}));
    const PieceTable table = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {8});
    const auto root = table.refit_node(rig.tree, 0, rig.palette);
    double largest = 0;
    for (std::size_t i = 0; i < root.pieces.size(); ++i) largest = std::max(largest, root.piece_reference(i).radius);
    return Checked(root.pieces.size() == 8 && largest < 0.45 * root.reference.radius, 8,
                   "the largest has " + std::to_string(largest / root.reference.radius) + " of the node's radius");
  });
  t.example("a full change of weight counts as the node's radius: weights are split where they vary more than places do", {}, [] {
    // The rigid ring's spread is its radius, 10; the row's 4 and half of 10: less. With a row of 14 or a ring of 2 it is more.
    const auto sizes = [](const std::vector<Vertex>& vertices, int most) {
      // These are the numbers of vertices of the ring and of the row.
      std::array<int, 2> count{0, 0};
      for (const RootPiece& p : root_pieces(rig_of(vertices, 3), {most})) ++count[p.joints.size() == 1 ? 0 : 1];
      return count;
    };
    const bool ring_first = sizes(ring_and_row(10, 8, 16), 3) == std::array{2, 1};
    const bool row_first = sizes(ring_and_row(10, 14, 16), 3) == std::array{1, 2};
    bool by_weight = true;  // 10 half ways apart is more than a row of 1
    for (const RootPiece& p : root_pieces(rig_of(ring_and_row(10, 1, 16), 3), {12}))
      if (p.joints.size() == 2) by_weight = by_weight && p.weight_range < 0.3;
    bool by_place = true;  // The weights count less than a row of 14.
    for (const RootPiece& p : root_pieces(rig_of(ring_and_row(10, 14, 16), 3), {3}))
      if (p.joints.size() == 2) by_place = by_place && p.weight_range > 0.4 && p.radius < 4;
    // A quarter of the radius counts 2.5: the row of 14 then counts less than the ring, that of 18 does not.
    const auto root_sizes = [&](double row) {
      std::array<int, 2> count{0, 0};
      const PieceOptions options{.most_pieces = 3, .weight_extent = 0.25};
      for (const RootPiece& p : root_pieces(rig_of(ring_and_row(10, row, 16), 3), options)) ++count[p.joints.size() == 1 ? 0 : 1];
      return count;
    };
    const bool quarter = root_sizes(14) == std::array{2, 1} && root_sizes(18) == std::array{1, 2};
    return Checked(ring_first && row_first && by_weight && by_place && quarter, 6,
                   std::to_string(ring_first) + std::to_string(row_first) + std::to_string(by_weight) + std::to_string(by_place) +
                       std::to_string(quarter));
  });
  t.example("of several weights that vary, the one that varies most is split, wherever it is in the joint-set", {}, [] {
    bool good = true;
    for (int widest = 0; widest < 3; ++widest) {
      std::vector<Vertex> vertices;
      for (int k = 0; k < 16; ++k) vertices.push_back({{k % 2 ? -10. : 10., 0, 0}, {{3, 1.0}}});
      for (int k = 0; k < 64; ++k) {
        // One weight runs from 1/4 to 3/4, the next takes most of what that leaves, and the third wavers.
        const double most = 0.25 + k / 126., least = 0.0625 + (k * 29 % 64) / 4096.;
        std::vector<Influence> influences{{widest, std::floor(0x1p24 * most) * 0x1p-24}, {(widest + 2) % 3, least}};
        influences.push_back({(widest + 1) % 3, 1 - influences[0].weight - influences[1].weight});
        std::sort(influences.begin(), influences.end(), [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
        vertices.push_back({{0, 0, 0}, influences});
      }
      const Rig rig = rig_of(vertices, 4);
      const PieceTable table = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {20});
      const auto node = table.refit_node(rig.tree, 0, rig.palette);
      for (const NodePiece& piece : node.pieces) {
        if (rig.sets.joints(piece.joint_set).size() == 1) continue;
        double low = 1, high = 0;
        for (int k = 0; k < piece.weight_vertex_count; ++k)
          low = std::min(low, node.weight_vertex(piece, k)[widest]), high = std::max(high, node.weight_vertex(piece, k)[widest]);
        good = good && high - low < 0.1;
      }
    }
    return Checked(good, 3);
  });
  t.example("a piece is split in halves of as many vertices each", {}, [] {
    std::vector<Vertex> row;
    for (int k = 0; k < 64; ++k) row.push_back({{1. * k, 0, 0}, rigid});
    const Rig rig = rig_of(row, 3);
    bool good = true;
    for (const int pieces : {2, 4, 8, 16}) {
      const auto found = root_pieces(rig, {pieces});
      good = good && static_cast<int>(found.size()) == pieces;
      for (const RootPiece& p : found) good = good && std::abs(p.radius - (32. / pieces - 0.5)) < 1e-9;
    }
    return Checked(good, 4);
  });
}

// Checks vertices of one joint. A target moves all of them alike, half of them in one direction and half in the other, or one
// alone.
void check_displaced_vertices() {
  const int count = *gen::between(2, 20);
  std::vector<Vertex> vertices;
  MorphTargets targets{*gen::between(1, 9), {}};
  for (int v = 0; v < count; ++v)
    vertices.push_back({{*gen::between(-100, 101) / 100., *gen::between(-100, 101) / 100., 1. * v}, rigid});
  targets.of_vertex.resize(vertices.size());
  // These are the radii of all targets' displacements.
  double apart = 0;
  for (int target = 0; target < targets.count; ++target) {
    const int kind = *gen::between(0, 3);
    const double far = *gen::between(1, 100) / 1000.;
    const Point3 by = far * std::array{Point3(1, 0, 0), Point3(0, -0.6, 0.8)}[static_cast<std::size_t>(*gen::between(0, 2))];
    for (int v = 0; v < (kind == 2 ? 1 : count); ++v)
      targets.of_vertex[static_cast<std::size_t>(v)].push_back({target, kind == 0   ? by
                                                                        : kind == 1 ? Point3(v % 2 == 0 ? by : -by)
                                                                                    : Point3(2 * by)});
    if (kind > 0) apart += far;
  }
  const Rig rig = rig_of(vertices, 3, targets);
  const double radius = rig.tree.refit_node(0, rig.palette).reference.radius;
  PieceOptions options;
  options.least_displacement = apart > 0 ? apart / radius * *rc::gen::element(0.5, 0.9, 1.1, 2.) : 1e-9;
  options.most_displaced_vertices = static_cast<std::size_t>(count + *rc::gen::element(-1, 0, 5));
  const bool is_listed = apart / radius > options.least_displacement && vertices.size() <= options.most_displaced_vertices;
  RC_TAG(is_listed ? "listed" : "kept");
  const auto pieces = root_pieces(rig, options);
  RC_ASSERT(pieces.size() == (is_listed ? vertices.size() : 1));
  for (const RootPiece& piece : pieces) RC_ASSERT((piece.radius == 0) == is_listed);
}

void what_is_listed_by_its_vertices(Suite& t) {
  t.holds("a piece is listed by its vertices if all morph targets together take these farther apart than said, and they are few",
          {.number_type = "double", .cases = 200, .tags_at_least = {{"listed", 0.15}, {"kept", 0.3}}}, check_displaced_vertices);
  t.example("what is better listed by its vertices is not split, but counts as a piece", {}, [] {
    // There are three blended vertices, far apart, against the four control points of their two weight vertices, twice; and a
    // rigid ring.
    std::vector<Vertex> vertices = ring_and_row(1, 0, 0);
    vertices.resize(16);
    for (int k = 0; k < 3; ++k) vertices.push_back({{-50. + 50 * k, 0, 0}, blended(1 + k, 4)});
    int listed = 0, balls = 0;
    for (const RootPiece& p : root_pieces(rig_of(vertices, 3), {3, 1, 2})) ++(p.radius == 0 ? listed : balls);
    return Checked(listed == 3 && balls == 2, 5, std::to_string(listed) + " listed, " + std::to_string(balls) + " balls");
  });
  t.example("where joints scale, a node of rigid pieces is split into as many as said, and few vertices are listed one by one",
            {}, [] {
              std::vector<Vertex> row;
              for (int k = 0; k < 64; ++k) row.push_back({{1. * k, 0, 0}, rigid});
              const auto pieces = [](const std::vector<Vertex>& vertices, std::size_t listed, int split) {
                int balls = 0, points = 0;
                const PieceOptions options{.most_stretched_vertices = listed, .stretched_pieces = split};
                for (const RootPiece& p : root_pieces(rig_of(vertices, 3), options)) ++(p.radius > 0 ? balls : points);
                return std::array{balls, points};
              };
              // A rigid ring is beside a blended row: the node is not split, and of its two pieces only the rigid one may be
              // listed.
              const std::vector<Vertex> mixed = ring_and_row(10, 8, 16);
              const auto kept = pieces(mixed, 15, 8), listed = pieces(mixed, 16, 8);
              const bool good = pieces(row, 63, 1) == std::array{1, 0} && pieces(row, 64, 1) == std::array{0, 64} &&
                                pieces(row, 15, 4) == std::array{4, 0} && pieces(row, 16, 4) == std::array{0, 64} &&
                                pieces(row, 0, 1) == std::array{1, 0} && kept == std::array{2, 0} && listed == std::array{1, 16};
              return Checked(good, 7,
                             std::to_string(kept[0]) + " and " + std::to_string(kept[1]) + "; " + std::to_string(listed[0]) +
                                 " and " + std::to_string(listed[1]));
            });
  t.holds("pieces of few vertices are these vertices, one by one, and all others stay as they are",
          {.number_type = "rational", .cases = 60, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const Rig rig(gen::make_mesh(plan));
            const double factor = *rc::gen::element(0.25, 1., 2., 8.);
            const PieceTable plain = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {1}),
                             mixed = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {1, 1, factor});
            Listed result;
            for (int n = 0; n < static_cast<int>(rig.tree.nodes.size()); ++n) compare_lists(rig, plain, mixed, factor, n, result);
            RC_ASSERT(result.wrong == "");
          });
}

}  // namespace

PROPTEST(build_pieces) {
  pieces_hold_all_vertices_and_get_smaller(t);
  what_is_split_and_how(t);
  what_is_listed_by_its_vertices(t);
  t.example("on the built-in man, a piece for each joint-set", {.number_type = "rational"}, [] { return check_man({}); });
  t.example("on the built-in man, up to 64 pieces", {.number_type = "rational"}, [] { return check_man({64}); });
  t.example("on the built-in man, some of its pieces are listed as vertices and some are not", {}, [] {
    const Rig rig(make_man());
    const PieceTable plain = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {}),
                     mixed = build_pieces(rig.tree, rig.vertices, rig.mesh, rig.sets, {1, 1, 2.});
    Listed result;
    for (int n = 0; n < static_cast<int>(rig.tree.nodes.size()); n += 7) compare_lists(rig, plain, mixed, 2, n, result);
    return Checked(result.wrong.empty() && result.listed > 500 && result.kept > 500, result.listed + result.kept,
                   result.wrong + std::to_string(result.listed) + " listed, " + std::to_string(result.kept) + " kept");
  });
}

}  // namespace proptests::suite_build_pieces
