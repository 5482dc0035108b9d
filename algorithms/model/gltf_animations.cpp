// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_animations.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace refitlab {
namespace {

constexpr double least_rotation = 1e-6;         // the norm of a quaternion that is taken for a rotation
constexpr double usual_length_error = 2e-6;     // of floats, also where they were written with few digits
constexpr double unit_length_tolerance = 1e-2;  // of quaternions of splines; as normalised bytes they are off by nearly that

Eigen::Vector3d vector_of(const NumberTable& values, std::size_t row, const Eigen::Vector3d&) {
  return {values.at(row, 0), values.at(row, 1), values.at(row, 2)};
}
Eigen::VectorXd vector_of(const NumberTable& values, std::size_t row, const Eigen::VectorXd& targets) {
  return Eigen::Map<const Eigen::VectorXd>(values.values.data() + row * static_cast<std::size_t>(targets.size()), targets.size());
}
Eigen::Quaterniond vector_of(const NumberTable& values, std::size_t row, const Eigen::Quaterniond&) {
  return Eigen::Quaterniond(Eigen::Vector4d(values.at(row, 0), values.at(row, 1), values.at(row, 2), values.at(row, 3)));
}

bool is_finite(const Eigen::Vector3d& v) { return v.allFinite(); }
bool is_finite(const Eigen::VectorXd& v) { return v.allFinite(); }
bool is_finite(const Eigen::Quaterniond& q) { return q.coeffs().allFinite(); }
// A spline's keys stay as they are, because its curve depends on their lengths. Its values are normalised afterwards.
Eigen::Vector3d key_value(const Eigen::Vector3d& v, Interpolation) { return v; }
Eigen::VectorXd key_value(const Eigen::VectorXd& v, Interpolation) { return v; }
Eigen::Quaterniond key_value(const Eigen::Quaterniond& q, Interpolation interpolation) {
  return interpolation == Interpolation::cubic ? q : q.normalized();
}

// Returns how many rows of an accessor a value takes.
std::size_t scalars_of(const Eigen::VectorXd& v) { return static_cast<std::size_t>(v.size()); }
std::size_t scalars_of(const Eigen::Vector3d&) { return 1; }
std::size_t scalars_of(const Eigen::Quaterniond&) { return 1; }

// Returns by how much the length of a value is off that of a rotation. Other values have any length.
double off_unit_length(const Eigen::Quaterniond& q) { return std::abs(q.norm() - 1); }
template <class Other>
double off_unit_length(const Other&) {
  return 0;
}

// Returns why a value cannot be a key, or nothing if it can.
std::string complaint(const Eigen::Vector3d& v, Interpolation) { return v.allFinite() ? "" : "not finite"; }
std::string complaint(const Eigen::VectorXd& v, Interpolation) { return v.allFinite() ? "" : "not finite"; }
std::string complaint(const Eigen::Quaterniond& q, Interpolation interpolation) {
  if (!q.coeffs().allFinite()) return "not finite";
  if (!(q.norm() > least_rotation)) return "a rotation by a zero quaternion";
  const bool unit = off_unit_length(q) <= unit_length_tolerance;
  return unit || interpolation != Interpolation::cubic ? "" : "a spline's rotation by a quaternion that is not of unit length";
}

class ClipReader {
 public:
  ClipReader(const tinygltf::Model& source, std::size_t clip, const GltfNodes& nodes, const GltfNumbers& numbers,
             const std::string& file)
      : source_(source),
        animation_(source.animations[clip]),
        nodes_(nodes),
        numbers_(numbers),
        file_(file) {
    out_.name = animation_.name.empty() ? "clip " + std::to_string(clip) : animation_.name;
  }

  // Returns by how much the length of a quaternion is off, which no spline has, at most. After read().
  double farthest_length() const { return farthest_length_; }

  Animation read() {
    const std::string clip = "clip '" + out_.name + "'";
    std::map<int, std::map<std::string, const tinygltf::AnimationChannel*>> channels;  // by node and path
    for (const tinygltf::AnimationChannel& channel : animation_.channels) {
      if (static_cast<std::size_t>(channel.target_node) >= nodes_.places.size())
        throw ModelError(file_, clip, "moves a node that there is not");
      const int place = nodes_.places[channel.target_node];
      const std::string thing = clip + ", joint '" + nodes_.nodes[place].name + "'";
      const std::string& path = channel.target_path;
      if (path != "translation" && path != "rotation" && path != "scale" && path != "weights")
        throw ModelError(file_, thing, "a channel moves '" + path + "', which glTF has not");
      if (!channels[place].emplace(path, &channel).second) throw ModelError(file_, thing, "two channels move its " + path);
    }
    for (auto& [node_place, paths] : channels) {
      const int place = node_place;
      auto& by_path = paths;
      const std::string thing = clip + ", joint '" + nodes_.nodes[place].name + "'";
      const tinygltf::Node& node = source_.nodes[static_cast<std::size_t>(nodes_.nodes[place].source)];
      if (const auto weights = by_path.find("weights"); weights != by_path.end()) {
        add_weights(place, *weights->second, node, thing);
        by_path.erase(weights);
      }
      if (by_path.empty()) continue;
      const NodeTransform rest = by_path.size() < 3 ? rest_transform(node, file_, thing) : NodeTransform{};
      const auto channel = [&](const char* path) {
        const auto found = by_path.find(path);
        return found == by_path.end() ? nullptr : found->second;
      };
      out_.tracks.push_back({place, converted(channel("translation"), rest.translation, thing),
                             converted(channel("rotation"), rest.rotation, thing),
                             converted(channel("scale"), rest.scale, thing)});
    }
    return std::move(out_);
  }

 private:
  Interpolation interpolation_of(const tinygltf::AnimationSampler& sampler, const std::string& thing) const {
    if (sampler.interpolation == "LINEAR") return Interpolation::linear;
    if (sampler.interpolation == "STEP") return Interpolation::step;
    if (sampler.interpolation == "CUBICSPLINE") return Interpolation::cubic;
    throw ModelError(file_, thing, "interpolates by '" + sampler.interpolation + "', which glTF has not");
  }

  // Adds the weights of a node. They move nothing if the node shows no morph targets.
  void add_weights(int place, const tinygltf::AnimationChannel& channel, const tinygltf::Node& node, const std::string& thing) {
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (node.mesh < 0 || mesh >= source_.meshes.size() || source_.meshes[mesh].primitives.empty()) return;
    const std::size_t targets = source_.meshes[mesh].primitives[0].targets.size();
    if (targets == 0) return;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(targets));
    out_.weight_tracks.push_back({place, converted(&channel, none, thing)});
  }

  template <class Value>
  Channel<Value> converted(const tinygltf::AnimationChannel* channel, const Value& rest, const std::string& thing) {
    if (!channel) return {{{0, rest}}};
    if (static_cast<std::size_t>(channel->sampler) >= animation_.samplers.size())
      throw ModelError(file_, thing, "a channel has a sampler that there is not");
    const tinygltf::AnimationSampler& sampler = animation_.samplers[static_cast<std::size_t>(channel->sampler)];
    const std::string& path = channel->target_path;
    const int type = path == "rotation" ? TINYGLTF_TYPE_VEC4 : path == "weights" ? TINYGLTF_TYPE_SCALAR : TINYGLTF_TYPE_VEC3;
    const NumberTable times = numbers_.read(sampler.input, TINYGLTF_TYPE_SCALAR, Numbers::floats, thing);
    NumberTable values = numbers_.read(sampler.output, type, Numbers::floats_or_normalized, thing);
    values.rows /= scalars_of(rest);
    Channel<Value> out{{}, interpolation_of(sampler, thing), {}};
    const std::size_t row_count = out.interpolation == Interpolation::cubic ? 3 * times.rows : times.rows;
    if (times.rows == 0 || values.rows < row_count)
      throw ModelError(file_, thing,
                       "a channel has " + std::to_string(times.rows) + " times but " + std::to_string(values.rows) + " values");
    for (std::size_t k = 0; k < times.rows; ++k) add_key(k, times.at(k, 0), values, rest, thing, out);
    out_.duration = std::max(out_.duration, out.keys.back().time);
    return out;
  }

  template <class Value>
  void add_key(std::size_t k, double time, const NumberTable& values, const Value& as, const std::string& thing,
               Channel<Value>& out) {
    const auto refuse = [&](const std::string& reason) {
      throw ModelError(file_, thing + ", key " + std::to_string(k) + " at " + std::to_string(time) + " s", reason);
    };
    const bool cubic = out.interpolation == Interpolation::cubic;
    const Value value = vector_of(values, cubic ? 3 * k + 1 : k, as);
    const std::string wrong = std::isfinite(time) ? complaint(value, out.interpolation) : "not finite";
    if (!wrong.empty()) refuse(wrong);
    if (!out.keys.empty() && time < out.keys.back().time) refuse("keys are not in order of time");
    out.keys.push_back({time, key_value(value, out.interpolation)});
    if (!cubic) {
      farthest_length_ = std::max(farthest_length_, off_unit_length(value));
      return;
    }
    out.tangents.push_back({vector_of(values, 3 * k, as), vector_of(values, 3 * k + 2, as)});
    if (!is_finite(out.tangents.back().into) || !is_finite(out.tangents.back().out)) refuse("a tangent is not finite");
  }

  const tinygltf::Model& source_;
  const tinygltf::Animation& animation_;
  const GltfNodes& nodes_;
  const GltfNumbers& numbers_;
  const std::string& file_;
  Animation out_;
  double farthest_length_ = 0;
};

}  // namespace

std::vector<Animation> convert_animations(const tinygltf::Model& source, const GltfNodes& nodes, const GltfNumbers& numbers,
                                          const std::string& file, std::vector<std::string>& notes) {
  std::vector<Animation> out;
  for (std::size_t a = 0; a < source.animations.size(); ++a) {
    ClipReader reader(source, a, nodes, numbers, file);
    out.push_back(reader.read());
    if (reader.farthest_length() > usual_length_error)
      notes.push_back("clip '" + out.back().name + "': has rotations whose quaternions are not of unit length but off by up to " +
                      std::to_string(reader.farthest_length()) +
                      ", as integers are. They are divided by their lengths. A renderer that does not do so, such as three.js, "
                      "moves vertices by up to four times this share of their distance from the joint, and out of bounds");
  }
  return out;
}

}  // namespace refitlab
