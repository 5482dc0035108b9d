// SPDX-License-Identifier: MIT
#include "algorithms/runtime/refit/deformed_reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "algorithms/runtime/refit/rounding.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "lemmas/a3_morph_displacement.hpp"

namespace refitlab {
namespace {

bool same(const AffinePose& a, const AffinePose& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const AffineMap<double>& x, const AffineMap<double>& y) {
    return x.columns == y.columns && x.offset == y.offset;
  });
}

bool same(std::span<const Slab<double>> a, std::span<const Slab<double>> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Slab<double>& x, const Slab<double>& y) { return x.low == y.low && x.high == y.high; });
}

// Returns a ball that encloses these. It is for lengths alone and need not be small.
Ball3<double> some_ball_around(std::span<const NodePiece> pieces, const std::vector<Ball3<double>>& references) {
  const Point3 center = references[static_cast<std::size_t>(pieces[0].reference)].center;
  double radius = 0;
  for (const NodePiece& piece : pieces) {
    const Ball3<double>& ball = references[static_cast<std::size_t>(piece.reference)];
    radius = max_of(radius, norm<double, 3>(ball.center - center) + ball.radius);
  }
  return rounded_up(Ball3<double>{center, radius});
}

std::span<const NodePiece> pieces_of(const PieceTable& table, int node) {
  const auto n = static_cast<std::size_t>(node);
  return {table.pieces.data() + table.first[n], table.first[n + 1] - table.first[n]};
}

}  // namespace

DeformedReference::DeformedReference(const Character& character, Pieces kind)
    : character_(character),
      kind_(kind),
      nodes_made_(character.tree.nodes.size()),
      references_made_(character.pieces[static_cast<std::size_t>(kind)].references.size()),
      nodes_(character.tree.nodes.size()),
      references_(character.pieces[static_cast<std::size_t>(kind)].references.size()) {
  if (!character.has(kind)) throw std::invalid_argument(character.mesh.name + ": baked without the pieces to be deformed");
}

void DeformedReference::begin(const Deformation& deformation) {
  std::vector<Slab<double>> ranges;
  for (const double weight : deformation.weights) ranges.push_back({weight, weight});
  begin(ranges, deformation.scales);
}

void DeformedReference::begin(std::span<const Slab<double>> weights, const AffinePose& scales) {
  const DefaultFloatEnvironment environment;
  if (is_begun_ && same(weights, ranges_) && same(scales, deformation_.scales)) return;
  // The greatest weights are looked at, and the lowest stay.
  Deformation deformation{{}, scales};
  for (const Slab<double>& range : weights) {
    if (range.high < range.low) throw ModelError(character_.mesh.name, "pose", "a range of its weights ends before it begins");
    deformation.weights.push_back(max_of(std::abs(range.low), std::abs(range.high)) + 0 * range.high);  // NaN if one of both is
  }
  check_deformation(character_.mesh, deformation);
  deformation.weights.clear();
  for (const Slab<double>& range : weights) deformation.weights.push_back(range.low);
  is_begun_ = false;
  deformation_ = std::move(deformation);
  ranges_.assign(weights.begin(), weights.end());
  scales_ = make_scale_palette(character_.mesh, character_.sets, scales);
  nodes_made_.begin(), references_made_.begin();
  is_begun_ = true;
}

// A vertex and its displacements are within L of the origin, all of them together; u is half of epsilon. With K targets, a vertex
// in double is off by (K + 1) u L, and so is the center; the radius is a sum of 2 K + 1 numbers, which is off by (2 K + 1) u L. A
// vertex that is a ball of its own has the ball's center in double, to the last bit.
Ball3<double> DeformedReference::displaced(const Ball3<double>& ball, std::span<const TargetBall> displacements) const {
  if (ranges_.empty() || displacements.empty()) return ball;
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  Ball3<double> out = ball;
  double size = upper_norm(ball.center) + ball.radius;
  for (const TargetBall& by : displacements) {
    const Slab<double>& range = ranges_[static_cast<std::size_t>(by.target)];
    const double length = upper_norm(by.ball.center);
    out = displaced_by(out, by.ball, range, length);
    size += max_of(std::abs(range.low), std::abs(range.high)) * (length + by.ball.radius);
  }
  const auto roundings = static_cast<double>(4 * displacements.size() + 8);
  return rounded_up(Ball3<double>{out.center, out.radius + roundings * u * size});
}

Ball3<double> DeformedReference::scaled(const Ball3<double>& ball, std::span<const NodePiece> pieces,
                                        const double* weight_vertices) const {
  if (!scales_.is_affine()) return ball;
  thread_local ControlLists<double> lists;
  const RefitNode<double> node{ball, pieces, weight_vertices, scales_};
  return certified<Skinning::linear>(refit_linear<NearSmallestBalls>(node, lists), node);
}

void DeformedReference::make_reference(const NodePiece& piece) {
  if (references_made_.is_made(piece.reference)) return;
  const auto i = static_cast<std::size_t>(piece.reference);
  const PieceTable& table = character_.pieces[static_cast<std::size_t>(kind_)];
  references_[i] = scaled(displaced(table.references[i], table.displacements[i]), {&piece, 1}, table.weight_vertices.data());
  references_made_.mark(piece.reference);
}

RefitNode<double> DeformedReference::refit_node(int n, const SkinningPalette<double>& palette) {
  RefitNode<double> node = character_.refit_node(n, palette, kind_);
  if (ranges_.empty() && !scales_.is_affine()) return node;
  const DefaultFloatEnvironment environment;
  const auto i = static_cast<std::size_t>(n);
  if (!nodes_made_.is_made(n)) {
    if (kind_ == Pieces::node) {
      nodes_[i] = scaled(displaced(node.reference, character_.tree.displacements[i]), node.pieces, node.weight_vertices);
    } else {
      for (const NodePiece& piece : node.pieces) make_reference(piece);
      nodes_[i] = some_ball_around(node.pieces, references_);
    }
    nodes_made_.mark(n);
  }
  // Pieces of a node as a whole have no balls of their own.
  return {nodes_[i], node.pieces, node.weight_vertices, palette, kind_ == Pieces::node ? node.piece_references : references_};
}

Point3 DeformedReference::vertex(int v) const {
  const DefaultFloatEnvironment environment;
  const SkinnedMesh& mesh = character_.mesh;
  const PaletteEntry<double> scales =
      scales_.is_affine() ? scales_[static_cast<std::size_t>(character_.sets.of_vertex(v))] : PaletteEntry<double>{};
  return deformed<double>(mesh.vertices[static_cast<std::size_t>(v)], mesh.displacements(v), deformation_.weights, scales,
                          character_.sets.weights(v));
}

Character deformed_character(const Character& character, const Deformation& deformation) {
  const DefaultFloatEnvironment environment;
  Character out = character;
  out.mesh.vertices = deformed_vertices(character.mesh, character.sets, deformation);
  out.mesh.targets = {};
  out.tree.displacements = {};
  validate(out.mesh);
  for (std::size_t n = 0; n < out.tree.nodes.size(); ++n) {
    std::vector<Point3> points;
    for (const int v : out.vertices[static_cast<int>(n)]) points.push_back(out.mesh.vertices[static_cast<std::size_t>(v)]);
    out.tree.nodes[n].reference = rounded_up(as_ball(smallest_ball<double, 3>(points)));
  }
  const SkinningPalette<double> none;
  for (const Pieces kind : {Pieces::joint_sets, Pieces::mixed, Pieces::many}) {
    if (!character.has(kind)) continue;
    const PieceTable& table = character.pieces[static_cast<std::size_t>(kind)];
    PieceTable& own = out.pieces[static_cast<std::size_t>(kind)];
    own.displacements = {};
    DeformedReference reference(character, kind);
    reference.begin(deformation);
    for (int n = 0; n < static_cast<int>(out.tree.nodes.size()); ++n) {
      const RefitNode<double> node = reference.refit_node(n, none);
      Ball3<double>& whole = out.tree.nodes[static_cast<std::size_t>(n)].reference;
      for (const NodePiece& piece : pieces_of(table, n)) {
        const auto i = static_cast<std::size_t>(piece.reference);
        own.references[i] = node.piece_references[i];
        // The slack for rounding takes lengths of the node's ball for those of its pieces' (refit/rounding.hpp).
        const double apart = norm<double, 3>(own.references[i].center - whole.center);
        whole.radius = max_of(whole.radius, max_of(apart, own.references[i].radius));
      }
    }
  }
  return out;
}

}  // namespace refitlab
