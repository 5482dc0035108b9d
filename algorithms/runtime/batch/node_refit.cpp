// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/node_refit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/runtime/batch/refit_kernel.hpp"
#include "algorithms/runtime/batch/single_precision.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/lemma5_cap_enclosing_sphere.hpp"
#include "lemmas/s43_rotated_cap.hpp"

namespace refitlab {
namespace {

Row<float, 4> four(const Point3& v) {
  return Row<float, 4>{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0};
}

// The imaginary part first, so that it stands where a point has its coordinates.
Row<float, 4> four(const Quaternion<double>& q) {
  return Row<float, 4>{static_cast<float>(q[1]), static_cast<float>(q[2]), static_cast<float>(q[3]), static_cast<float>(q[0])};
}

float squared_length(const Row<float, 4>& v) {
  const Row<float, 4> squares = v * v, pairs = squares + __builtin_shufflevector(squares, squares, 2, 3, 0, 1);
  return pairs[0] + pairs[1];
}

// Of the first three; the last one is 0.
Row<float, 4> cross(const Row<float, 4>& a, const Row<float, 4>& b) {
  return __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) -
         __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
}

// The image of the point x by a unit quaternion, as rotate has it.
Row<float, 4> rotated(const Row<float, 4>& unit, const Row<float, 4>& x) {
  const Row<float, 4> t = cross(unit, x);
  return x + 2 * (t * unit[3] + cross(unit, t));
}

}  // namespace

NodeRefit::NodeRefit(const SphereTree& tree, const JointSets& sets) : pieces_(tree.pieces), sets_(sets.count()) {
  const DefaultFloatEnvironment environment;
  for (const double w : tree.weight_vertices) weights_.push_back(static_cast<float>(w));  // exact
  int most_weight_vertices = 0, most_pieces = 0;
  for (const TreeNode& n : tree.nodes) {
    checked_single(norm(n.reference.center) + n.reference.radius);
    nodes_.push_back({four(n.reference.center), float_above(n.reference.radius), n.first_piece, n.piece_count});
    int weight_vertices = 0;
    for (int i = 0; i < n.piece_count; ++i) weight_vertices += pieces_[n.first_piece + i].weight_vertex_count;
    most_weight_vertices = std::max(most_weight_vertices, weight_vertices);
    most_pieces = std::max(most_pieces, n.piece_count);
  }
  weight_vertices_.resize(most_weight_vertices);
  radii_.resize(most_pieces);
}

void NodeRefit::begin(const SkinningPalette<double>& palette) {
  const DefaultFloatEnvironment environment;
  joints_.clear();
  for (std::size_t s = 0; s < palette.size(); ++s) {
    const PaletteEntry<double> set = palette[s];
    double size = 0;
    for (const auto& image : set.center_images) size = std::max(size, squared_norm(image));
    sets_[s] = {four(set.rotation_center),
                static_cast<float>(checked_single(1.001 * (std::sqrt(size) + 2 * norm(set.rotation_center)))),
                static_cast<int>(joints_.size()), static_cast<int>(set.transforms.size())};
    for (std::size_t i = 0; i < set.transforms.size(); ++i)
      joints_.push_back({four(set.transforms[i].rotation), four(set.center_images[i])});
  }
}

float NodeRefit::place_weight_vertices(const NodePiece& piece, const Row<float, 4>& p, WeightVertex* out) const {
  const Set& set = sets_[piece.joint_set];
  const Joint* joints = joints_.data() + set.first_joint;
  const float* w = weights_.data() + piece.first_weight;
  Row<float, 4> direction = {0, 0, 0, 0};
  float longest_inverse = 1;
  for (int k = 0; k < piece.weight_vertex_count; ++k, w += set.joint_count) {
    Row<float, 4> blend = joints[0].rotation * w[0], center = joints[0].center_image * w[0];
    for (int i = 1; i < set.joint_count; ++i) {
      blend += joints[i].rotation * w[i];
      center += joints[i].center_image * w[i];
    }
    const float inverse = 1 / std::sqrt(squared_length(blend));
    longest_inverse = std::max(longest_inverse, inverse);
    out[k] = {blend * inverse, center};
    direction += out[k].unit;
  }
  const Row<float, 4> x = p - set.rotation_center;
  const float longer = std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);  // than x
  const float slack = node_refit_slack(set.joint_count);
  if (piece.weight_vertex_count == 1 && longest_inverse < std::numeric_limits<float>::infinity()) {
    out[0].center += rotated(direction, x);
    return slack * (longer * longest_inverse + set.size);
  }
  const Row<float, 4> apex = direction * (1 / std::sqrt(squared_length(direction)));
  float far = 0;
  bool is_bounded = true;  // not if a blend vanishes: then it is not a number
  for (int k = 0; k < piece.weight_vertex_count; ++k) {
    const float squared = squared_length(out[k].unit - apex);
    is_bounded = is_bounded && squared < 2;
    far = std::max(far, squared);
  }
  const float length = std::sqrt(squared_length(x));
  const CapBallRatios<float> ratios = cap_ball_ratios(rotated_cap_versine(far / 4));
  if (!is_bounded || ratios.center == 0) return length + slack * (longer + set.size);
  const Row<float, 4> offset = rotated(apex, x) * ratios.center;
  for (int k = 0; k < piece.weight_vertex_count; ++k) out[k].center += offset;
  return std::sqrt(ratios.squared_radius) * length + slack * (longer * longest_inverse + set.size);
}

Ball3<float> NodeRefit::operator()(int node) {
  const DefaultFloatEnvironment environment;
  const Node& n = nodes_[node];
  const std::span<const NodePiece> pieces(pieces_.data() + n.first_piece, n.piece_count);
  Row<float, 4> sum = {0, 0, 0, 0};
  int count = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    WeightVertex* own = weight_vertices_.data() + count;
    radii_[i] = place_weight_vertices(pieces[i], n.center, own);
    for (int k = 0; k < pieces[i].weight_vertex_count; ++k) sum += own[k].center;
    count += pieces[i].weight_vertex_count;
  }
  const Row<float, 4> center = sum * (1 / static_cast<float>(count));
  float radius = 0;
  const WeightVertex* weight_vertex = weight_vertices_.data();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    float far = 0;
    for (int k = 0; k < pieces[i].weight_vertex_count; ++k, ++weight_vertex)
      far = std::max(far, squared_length(weight_vertex->center - center));
    radius = std::max(radius, std::sqrt(far) + radii_[i]);
  }
  return {{center[0], center[1], center[2]}, (radius + n.radius) * refit_radius_stretch + underflow_slack};
}

}  // namespace refitlab
