// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/certificate/certificate.hpp"

#include <map>

#include "algorithms/certificate/bound.hpp"
#include "algorithms/certificate/exact_json.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/certificate/shares.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

json json_of(const Bound& bound) {
  json out;
  switch (bound.by) {
    case Bound::By::control: out["by"] = "control"; break;
    case Bound::By::all_rotations: out["by"] = "all_rotations"; break;
    case Bound::By::cap:
      out["by"] = "cap";
      out["axis"] = exact_json(bound.axis);
      break;
    case Bound::By::reach:
      out["by"] = "reach";
      out["axis"] = exact_json(bound.axis);
      out["center"] = exact_json(bound.center);
      break;
    case Bound::By::stretch:
      out["by"] = "stretch";
      for (const Rational& s : bound.of_joints) out["of_joints"].push_back(as_text(s));
      for (const Rational& s : bound.of_weight_vertices) out["of_weight_vertices"].push_back(as_text(s));
      break;
    case Bound::By::halves:
      out["by"] = "halves";
      out["edge"] = bound.edge;
      for (const Bound& half : bound.halves) out["halves"].push_back(json_of(half));
      break;
  }
  return out;
}

json weight_vertices_of(const RefitNode<double>& node, const NodePiece& set) {
  json out;
  for (int k = 0; k < set.weight_vertex_count; ++k) {
    json weights;
    Rational sum(0);
    for (const double w : node.weight_vertex(set, k)) {
      weights.push_back(exact_json(w));
      sum += Rational(w);
      if (w < 0) throw std::invalid_argument("certificate: the weight of a weight vertex is negative");
    }
    if (sum != 1) throw std::invalid_argument("certificate: the weights of a weight vertex have the sum " + as_text(sum));
    out.push_back(weights);
  }
  return out;
}

// Returns whether the reference ball holds the position, exactly.
bool is_in(const Ball3<double>& ball, const Point3& position) {
  Rational apart(0);
  for (int i = 0; i < 3; ++i) {
    const Rational step = Rational(position[i]) - Rational(ball.center[i]);
    apart += step * step;
  }
  return apart <= Rational(ball.radius) * Rational(ball.radius);
}

std::vector<std::span<const double>> weight_vertex_rows(const RefitNode<double>& node, const NodePiece& set) {
  std::vector<std::span<const double>> rows;
  for (int k = 0; k < set.weight_vertex_count; ++k) rows.push_back(node.weight_vertex(set, k));
  return rows;
}

json json_of(const CertifiedVertex& v, const RefitNode<double>& node, const std::string& about) {
  json out{{"id", v.id}, {"position", exact_json(v.position)}, {"weights", exact_json(v.weights)}};
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const NodePiece& set = node.pieces[i];
    if (set.joint_set != v.joint_set || !is_in(node.piece_reference(i), v.position)) continue;
    const auto found = find_shares(weight_vertex_rows(node, set), v.weights);
    if (!found) continue;
    out["piece"] = i;
    out["weight_vertices"] = found->places;
    for (const Rational& share : found->shares) out["shares"].push_back(as_text(share));
    return out;
  }
  throw NoProof(about + ": no piece holds vertex " + std::to_string(v.id));
}

}  // namespace

json exact_json(const PaletteEntry<double>& palette, std::span<const int> joints, Skinning skinning) {
  json out{{"joints", joints}};
  if (!palette.maps.empty()) {
    for (const AffineMap<double>& map : palette.maps) {
      json columns;
      for (const auto& column : map.columns) columns.push_back(exact_json(column));
      out["columns"].push_back(columns);
      out["offsets"].push_back(exact_json(map.offset));
    }
    return out;
  }
  for (const auto& joint : palette.transforms) out["rotations"].push_back(exact_json(joint.rotation));
  switch (skinning) {
    case Skinning::linear:
      for (const auto& joint : palette.transforms) out["translations"].push_back(exact_json(joint.translation));
      break;
    case Skinning::dual_quaternion:
      for (const auto& dual : palette.duals) out["duals"].push_back(exact_json(dual));
      break;
    default:
      out["rotation_center"] = exact_json(palette.rotation_center);
      for (const auto& image : palette.center_images) out["center_images"].push_back(exact_json(image));
  }
  return out;
}

const char* certified_name(const SkinningPalette<double>& palette, Skinning skinning) {
  if (palette.is_affine()) return "affine";
  switch (skinning) {
    case Skinning::linear: return "linear";
    case Skinning::dual_quaternion: return "dual_quaternion";
    default: return "spherical";
  }
}

std::string certificate(const RefitNode<double>& node, Skinning skinning, const Ball3<double>& ball, const CertifiedNode& of) {
  const DefaultFloatEnvironment environment;
  if (node.palette.is_affine() && skinning != Skinning::linear)
    throw std::invalid_argument("certificate: affine joints are skinned linearly");
  json document;
  document["about"] = of.about;
  document["ball"] = exact_json(ball);
  document["digest"] = "";
  document["model"] = of.model_digest;
  document["node"] = of.number;
  document["pose"] = of.pose_digest;
  document["skinning"] = certified_name(node.palette, skinning);
  std::map<int, std::size_t> numbers;  // of the joint-sets in use, in the document
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const NodePiece& set = node.pieces[i];
    const auto [number, is_new] = numbers.try_emplace(set.joint_set, numbers.size());
    if (is_new) document["joint_sets"].push_back(exact_json(node.palette[set.joint_set], of.joints[set.joint_set], skinning));
    json piece;
    piece["weight_vertices"] = weight_vertices_of(node, set);
    piece["joint_set"] = number->second;
    piece["reference"] = exact_json(node.piece_reference(i));
    const auto bound = find_bound(node, i, skinning, ball);
    if (!bound)
      throw NoProof(of.about + ": no proof that the ball holds piece " + std::to_string(i) + " of " +
                    std::to_string(node.pieces.size()));
    piece["bound"] = json_of(*bound);
    document["pieces"].push_back(piece);
  }
  for (const CertifiedVertex& v : of.vertices) document["vertices"].push_back(json_of(v, node, of.about));
  document["digest"] = sha256(canonical(document));
  return canonical(document);
}

}  // namespace refitlab
