// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/any_pose.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/c8_any_pose.hpp"

namespace refitlab {
namespace {

// This factor allows for the roundings in a chain of nodes, which are far fewer than 2^20.
constexpr double room_for_rounding = 1 + 0x1p-30;

std::vector<int> path_to(const std::vector<SceneNode>& nodes, int node) {
  std::vector<int> path;
  for (; node >= 0; node = nodes[node].parent) path.push_back(node);
  std::reverse(path.begin(), path.end());
  return path;
}

class Ranges {
 public:
  explicit Ranges(const Model& model) : model_(model), links_(model.skeleton.nodes.size(), {0, 0}) {
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

  // Returns the greatest distance of a vertex from the origin of a joint, in the joint's frame.
  double distance(int vertex, const BoundJoint& joint) const {
    const Eigen::Matrix3d linear = joint.offset.topLeftCorner<3, 3>();
    double distance = norm<double, 3>(linear * model_.vertices[vertex] + joint.offset.topRightCorner<3, 1>());
    for (std::size_t m = 0; m < model_.morphs.size(); ++m)
      for (std::size_t t = 0; t < weights_[m].size(); ++t) {
        const auto& list = model_.morphs[m].targets[t].displacements;
        const auto found = std::lower_bound(list.begin(), list.end(), vertex, [](const auto& d, int v) { return d.first < v; });
        if (found != list.end() && found->first == vertex) distance += weights_[m][t] * norm<double, 3>(linear * found->second);
      }
    return distance;
  }

 private:
  void include(const Animation& animation) {
    const AnimatedJoints joints(model_, animation, false);
    for (int part = 0; part < joints.part_count(); ++part) {
      const auto& links = joints.motions(part).links;
      for (std::size_t n = 0; n < links.size(); ++n)
        links_[n] = {std::max(links_[n].length, links[n].offset.size), std::max(links_[n].stretch, links[n].linear.size)};
      for (std::size_t m = 0; m < weights_.size(); ++m)
        for (std::size_t t = 0; t < weights_[m].size(); ++t)
          weights_[m][t] = std::max(weights_[m][t], joints.motions(part).weights[m][t].size);
    }
  }

  const Model& model_;
  std::vector<LinkRange<double>> links_;      // by node
  std::vector<std::vector<double>> weights_;  // by morphed mesh and target: the greatest absolute value
};

}  // namespace

std::optional<AnyPoseBound> bound_any_pose(const Model& model, const JointSets& sets, std::span<const int> vertices,
                                           Skinning skinning) {
  const DefaultFloatEnvironment environment;
  const Ranges ranges(model);
  const BoundSkeleton& skeleton = model.skeleton;

  // These are, by joint-set, the greatest distances of its vertices from its joints.
  std::map<int, std::vector<double>> distances;
  for (const int v : vertices) {
    const auto joints = sets.joints(sets.of_vertex(v));
    auto& list = distances[sets.of_vertex(v)];
    list.resize(joints.size(), 0);
    for (std::size_t k = 0; k < joints.size(); ++k) list[k] = std::max(list[k], ranges.distance(v, skeleton.joints[joints[k]]));
  }
  std::vector<int> above;  // the path that all joints' paths begin with
  bool is_first = true;
  for (const auto& [set, list] : distances)
    for (const int j : sets.joints(set)) {
      const std::vector<int> path = path_to(skeleton.nodes, skeleton.joints[j].node);
      if (is_first) above = path, is_first = false;
      above.resize(
          static_cast<std::size_t>(std::mismatch(above.begin(), above.end(), path.begin(), path.end()).first - above.begin()));
    }
  if (above.empty()) return std::nullopt;

  // The vertices below the node are carried by its scale and those above it, and not by its translation.
  const std::vector<LinkRange<double>> scales = ranges.links(above);
  double greatest = 0;
  for (const auto& of_set : distances) {
    const int set = of_set.first;
    const std::vector<double>& list = of_set.second;
    const auto joints = sets.joints(set);
    std::vector<std::vector<int>> paths;
    double reach = 0;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      paths.push_back(path_to(skeleton.nodes, skeleton.joints[joints[k]].node));
      const std::span<const int> below = std::span<const int>(paths[k]).subspan(above.size());
      reach = std::max(reach, reach_of_chain<double>(ranges.links(below), list[k]));
    }
    double squared_spread = 0;
    if (skinning != Skinning::linear)
      for (std::size_t k = 0; k < joints.size(); ++k)
        for (std::size_t l = 0; l < k; ++l) {
          const auto parting = std::mismatch(paths[k].begin(), paths[k].end(), paths[l].begin(), paths[l].end()).first;
          const auto common = static_cast<std::size_t>(parting - paths[k].begin());
          const auto beyond = [&](std::size_t i) {
            return reach_of_chain<double>(ranges.links(std::span<const int>(paths[i]).subspan(common)), list[i]);
          };
          const auto shared = ranges.links(std::span<const int>(paths[k]).first(common).subspan(above.size()));
          squared_spread += sq(apart_at_most<double>(shared, beyond(k), beyond(l)));
        }
    greatest = std::max(greatest, reach + std::sqrt(squared_stray_in_any_pose(squared_spread)));
  }
  return AnyPoseBound{above.back(), apart_at_most<double>(scales, greatest, 0) * room_for_rounding};
}

}  // namespace refitlab
