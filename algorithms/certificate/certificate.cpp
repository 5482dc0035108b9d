#include "algorithms/certificate/certificate.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "algorithms/certificate/bound.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/exact/exact.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

json json_of(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("certificate: a number is not finite");
  return as_text(Rational(x));
}

template <int D>
json json_of(const Vec<double, D>& v) {
  json out = json::array();
  for (int i = 0; i < D; ++i) out.push_back(json_of(v[i]));
  return out;
}

json json_of(const Ball3<double>& ball) {
  json out;
  out["center"] = json_of(ball.center);
  out["radius"] = json_of(ball.radius);
  return out;
}

json json_of(const Bound& bound) {
  json out;
  switch (bound.by) {
    case Bound::By::control: out["by"] = "control"; break;
    case Bound::By::all_rotations: out["by"] = "all_rotations"; break;
    case Bound::By::cap:
      out["by"] = "cap";
      out["axis"] = json_of(bound.axis);
      break;
    case Bound::By::reach:
      out["by"] = "reach";
      out["axis"] = json_of(bound.axis);
      out["center"] = json_of(bound.center);
      break;
    case Bound::By::halves:
      out["by"] = "halves";
      out["edge"] = bound.edge;
      for (const Bound& half : bound.halves) out["halves"].push_back(json_of(half));
      break;
  }
  return out;
}

json json_of(const JointSetPose<double>& pose, Skinning skinning) {
  json out;
  for (const auto& joint : pose.transforms) out["rotations"].push_back(json_of(joint.rotation));
  switch (skinning) {
    case Skinning::linear:
      for (const auto& joint : pose.transforms) out["translations"].push_back(json_of(joint.translation));
      break;
    case Skinning::dual_quaternion:
      for (const auto& dual : pose.duals) out["duals"].push_back(json_of(dual));
      break;
    default:
      out["rotation_center"] = json_of(pose.rotation_center);
      for (const auto& image : pose.center_images) out["center_images"].push_back(json_of(image));
  }
  return out;
}

json corners_of(const RefitNode<double>& node, const NodeJointSet& set) {
  json out;
  for (int k = 0; k < set.corner_count; ++k) {
    json weights;
    Rational sum(0);
    for (const double w : node.corner(set, k)) {
      weights.push_back(json_of(w));
      sum += Rational(w);
      if (w < 0) throw std::invalid_argument("certificate: the weight of a corner is negative");
    }
    if (sum != 1) throw std::invalid_argument("certificate: the weights of a corner have the sum " + as_text(sum));
    out.push_back(weights);
  }
  return out;
}

std::string canonical(const json& document) {
  return document.dump(1, ' ', true, json::error_handler_t::replace) + "\n";
}

const char* name_of(Skinning skinning) {
  switch (skinning) {
    case Skinning::linear: return "linear";
    case Skinning::dual_quaternion: return "dual_quaternion";
    default: return "spherical";
  }
}

}  // namespace

std::string certificate(const RefitNode<double>& node, Skinning skinning, const Ball3<double>& ball,
                        const std::string& about) {
  const DefaultFloatEnvironment environment;
  json document;
  document["about"] = about;
  document["ball"] = json_of(ball);
  document["digest"] = "";
  document["skinning"] = name_of(skinning);
  std::map<int, std::size_t> numbers;  // of the joint-sets in use, in the document
  for (std::size_t i = 0; i < node.joint_sets.size(); ++i) {
    const NodeJointSet& set = node.joint_sets[i];
    const auto [number, is_new] = numbers.try_emplace(set.joint_set, numbers.size());
    if (is_new) document["joint_sets"].push_back(json_of(node.pose[set.joint_set], skinning));
    json piece;
    piece["corners"] = corners_of(node, set);
    piece["joint_set"] = number->second;
    piece["reference"] = json_of(node.piece_reference(i));
    const auto bound = find_bound(node, i, skinning, ball);
    if (!bound)
      throw NoProof(about + ": no proof that the ball holds piece " + std::to_string(i) + " of " +
                    std::to_string(node.joint_sets.size()));
    piece["bound"] = json_of(*bound);
    document["pieces"].push_back(piece);
  }
  document["digest"] = sha256(canonical(document));
  return canonical(document);
}

}  // namespace refitlab
