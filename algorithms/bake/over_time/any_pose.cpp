// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/any_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/c8_any_pose.hpp"

namespace refitlab {
namespace {

// This factor allows for the roundings of sums and products of lengths, none of which cancels: some ten for each node of a chain,
// and chains are far shorter than 2^16.
constexpr double room_for_rounding = 1 + 0x1p-30;

std::vector<int> path_to(const std::vector<SceneNode>& nodes, int node) {
  std::vector<int> path;
  for (; node >= 0; node = nodes[node].parent) path.push_back(node);
  std::reverse(path.begin(), path.end());
  return path;
}

// Holds how far vertices of one joint-set may be from its joints and from the model's origin.
struct Lengths {
  std::vector<double> computed, summed;  // by joint, as in ImageLength
  double from_origin = 0;
};

class Ranges {
 public:
  explicit Ranges(const Model& model)
      : model_(model),
        links_(model.skeleton.nodes.size(), {0, 0}),
        stretches_(model.skeleton.nodes.size(), {std::numeric_limits<double>::infinity(), 0}) {
    for (const MorphedMesh& mesh : model.morphs) weights_.emplace_back(mesh.weights.size(), 0.0);
    const Animation rest;
    include(rest);
    for (const Clip& clip : model.clips) include(clip.animation);
  }

  std::vector<LinkRange<double>> links(std::span<const int> path) const {
    std::vector<LinkRange<double>> out;
    for (const int node : path) out.push_back(links_[node]);
    return out;
  }

  // Returns how far the linear part of any joint's skin matrix is at most from the nearest rotation.
  double defect() const { return std::min(defect_of(model_.skeleton, stretches_), rigidity_tolerance); }

  void include(int vertex, std::span<const int> joints, Lengths& lengths) const {
    lengths.computed.resize(joints.size(), 0), lengths.summed.resize(joints.size(), 0);
    double from_origin = norm<double, 3>(model_.vertices[vertex]);
    const std::vector<std::pair<double, Point3>> displacements = displacements_of(vertex);
    for (const auto& [weight, d] : displacements) from_origin += weight * norm<double, 3>(d);
    lengths.from_origin = std::max(lengths.from_origin, from_origin);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const Eigen::Matrix4d& offset = model_.skeleton.joints[joints[k]].offset;
      ImageLength length = length_of_vertex(model_, offset, vertex);
      for (const auto& [weight, d] : displacements) {
        const ImageLength more = length_of_displacement(model_, offset, vertex, d);
        length.computed += weight * more.computed, length.summed += weight * more.summed;
      }
      lengths.computed[k] = std::max(lengths.computed[k], length.computed);
      lengths.summed[k] = std::max(lengths.summed[k], length.summed);
    }
  }

 private:
  void include(const Animation& animation) {
    const AnimatedJoints joints(model_, animation, false);
    for (int part = 0; part < joints.part_count(); ++part) {
      const auto& links = joints.motions(part).links;
      const std::vector<Stretch> stretched =
          stretches(model_.skeleton.nodes, animation, joints.times()[part], joints.times()[part + 1]);
      for (std::size_t n = 0; n < links.size(); ++n) {
        links_[n] = {std::max(links_[n].length, links[n].offset.size), std::max(links_[n].stretch, links[n].linear.size)};
        stretches_[n] = widest_of(stretches_[n], stretched[n]);
      }
      for (std::size_t m = 0; m < weights_.size(); ++m)
        for (std::size_t t = 0; t < weights_[m].size(); ++t)
          weights_[m][t] = std::max(weights_[m][t], joints.motions(part).weights[m][t].size);
    }
  }

  // Returns by how much the vertex may be displaced, each with its greatest weight.
  std::vector<std::pair<double, Point3>> displacements_of(int vertex) const {
    std::vector<std::pair<double, Point3>> out;
    for (std::size_t m = 0; m < model_.morphs.size(); ++m)
      for (std::size_t t = 0; t < weights_[m].size(); ++t)
        if (const Point3* by = displacement_of(model_.morphs[m].targets[t], vertex)) out.emplace_back(weights_[m][t], *by);
    return out;
  }

  const Model& model_;
  std::vector<LinkRange<double>> links_;      // by node
  std::vector<Stretch> stretches_;            // by node
  std::vector<std::vector<double>> weights_;  // by morphed mesh and target: the greatest absolute value
};

}  // namespace

std::optional<AnyPoseBound> bound_any_pose(const Model& model, const JointSets& sets, std::span<const int> vertices,
                                           Skinning skinning, double renderer_rounding) {
  const DefaultFloatEnvironment environment;
  const Ranges ranges(model);
  const BoundSkeleton& skeleton = model.skeleton;

  std::map<std::vector<int>, Lengths> lengths;  // by all joints that the file gives a vertex
  for (const int v : vertices) {
    const auto kept = sets.joints(sets.of_vertex(v));
    std::vector<int> joints(kept.begin(), kept.end());
    for (const LostInfluence& lost : lost_influences(model, v)) joints.push_back(lost.joint);
    ranges.include(v, joints, lengths[joints]);
  }
  std::vector<int> above;  // the path that all joints' paths begin with
  bool is_first = true;
  for (const auto& [joints, list] : lengths)
    for (const int j : joints) {
      const std::vector<int> path = path_to(skeleton.nodes, skeleton.joints[j].node);
      if (is_first) above = path, is_first = false;
      above.resize(
          static_cast<std::size_t>(std::mismatch(above.begin(), above.end(), path.begin(), path.end()).first - above.begin()));
    }
  if (above.empty()) return std::nullopt;
  // Of three rotations, two may come to lie on opposite sides, and their blend may vanish.
  if (skinning != Skinning::linear)
    for (const auto& [joints, list] : lengths)
      if (joints.size() > 2) return std::nullopt;

  // The vertices below the node are carried by its scale and those above it, and not by its translation.
  const std::vector<LinkRange<double>> carrying = ranges.links(above);
  const double defect = skinning == Skinning::linear ? 0 : ranges.defect();
  double greatest = 0, summed = 0;
  for (const auto& [joints, list] : lengths) {
    // A rigid transform carries a point elsewhere than the skin matrix that it stands for, which has the same translation.
    const double beside = defect * list.from_origin;
    std::vector<std::vector<int>> paths;
    double reach = 0;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      paths.push_back(path_to(skeleton.nodes, skeleton.joints[joints[k]].node));
      const std::span<const int> below = std::span<const int>(paths[k]).subspan(above.size());
      reach = std::max(reach, apart_at_most<double>(carrying, reach_of_chain<double>(ranges.links(below), list.computed[k]), 0));
      summed = std::max(summed, reach_of_chain<double>(ranges.links(paths[k]), list.summed[k]));
    }
    double squared_spread = 0;
    if (skinning != Skinning::linear)
      for (std::size_t k = 0; k < joints.size(); ++k)
        for (std::size_t l = 0; l < k; ++l) {
          const auto parting = std::mismatch(paths[k].begin(), paths[k].end(), paths[l].begin(), paths[l].end()).first;
          const auto common = static_cast<std::size_t>(parting - paths[k].begin());
          const auto beyond = [&, &list = list](std::size_t i) {
            return reach_of_chain<double>(ranges.links(std::span<const int>(paths[i]).subspan(common)), list.computed[i]);
          };
          const auto shared = ranges.links(std::span<const int>(paths[k]).first(common));
          squared_spread += sq(apart_at_most<double>(shared, beyond(k), beyond(l)) + 2 * beside);
        }
    greatest = std::max(greatest, reach + beside + std::sqrt(squared_deviation_in_any_pose(squared_spread)));
  }
  const double rounding = renderer_rounding * (summed + reach_of_chain<double>(carrying, 0));
  return AnyPoseBound{above.back(), (greatest + rounding) * room_for_rounding + underflow_of_distance<double>()};
}

}  // namespace refitlab
