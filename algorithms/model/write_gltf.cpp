// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/write_gltf.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

enum ComponentType : int { ushort_component = 5123, uint_component = 5125, float_component = 5126 };

std::array<float, 3> in_file(const Eigen::Vector3d& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
std::array<float, 4> in_file(const Eigen::Quaterniond& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()), static_cast<float>(q.w())};
}

class GltfWriter {
 public:
  explicit GltfWriter(const Model& model) : model_(model), nodes_(model.skeleton.nodes) {
    out_ = {{"asset", {{"version", "2.0"}, {"generator", "refitlab"}}}, {"scene", 0}};
    add_skin();
    add_nodes();
    add_mesh();
    for (const Clip& clip : model.clips) add(clip);
  }

  std::vector<GlbChunk> chunks() const {
    json out = out_;
    out["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    return {{json_chunk, out.dump(-1, ' ', false, json::error_handler_t::replace)}, {bin_chunk, bytes_}};
  }

 private:
  template <class Row>
  std::size_t add_accessor(const std::vector<Row>& rows, const char* type, ComponentType component) {
    const std::size_t length = rows.size() * sizeof(Row);
    out_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}});
    bytes_.append(reinterpret_cast<const char*>(rows.data()), length);
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    out_["accessors"].push_back(
        {{"bufferView", out_["bufferViews"].size() - 1}, {"componentType", component}, {"count", rows.size()}, {"type", type}});
    return out_["accessors"].size() - 1;
  }

  // A node may be only one joint of a skin. For further joints it gets children that do not move.
  void add_skin() {
    std::set<int> used;
    std::vector<int> joints;
    std::vector<std::array<float, 16>> offsets;
    for (const BoundJoint& joint : model_.skeleton.joints) {
      int node = joint.node;
      if (!used.insert(node).second) {
        nodes_.push_back({joint.name, node, Eigen::Matrix4d::Identity()});
        node = static_cast<int>(nodes_.size()) - 1;
      }
      joints.push_back(node);
      const Eigen::Matrix4f offset = joint.offset.cast<float>();
      std::copy(offset.data(), offset.data() + 16, offsets.emplace_back().begin());
    }
    out_["skins"] = json::array({{{"joints", joints}, {"inverseBindMatrices", add_accessor(offsets, "MAT4", float_component)}}});
  }

  // A node that a clip moves has to have a translation, a rotation and a scale.
  void add_nodes() {
    std::set<int> moved;
    for (const Clip& clip : model_.clips)
      for (const NodeTrack& track : clip.animation.tracks) moved.insert(track.node);
    std::vector<json> nodes;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const Eigen::Matrix4d& local = nodes_[n].local;
      nodes.push_back({{"name", nodes_[n].name}});
      if (moved.contains(static_cast<int>(n))) add_parts(nodes_[n], nodes.back());
      else if (local != Eigen::Matrix4d::Identity())
        nodes.back()["matrix"] = std::vector<double>(local.data(), local.data() + 16);
    }
    nodes.push_back({{"name", "skin"}, {"mesh", 0}, {"skin", 0}});
    std::vector<std::size_t> roots = {nodes.size() - 1};
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      if (nodes_[n].parent < 0) roots.push_back(n);
      else nodes[nodes_[n].parent]["children"].push_back(n);
    out_["nodes"] = nodes;
    out_["scenes"] = json::array({{{"nodes", roots}}});
  }

  void add_parts(const SceneNode& node, json& out) const {
    const std::optional<NodeTransform> parts = parts_of(node);
    if (!parts) throw ModelError(model_.name, "node '" + node.name + "'", "its transform is no translation, rotation and scale");
    out["translation"] = in_file(parts->translation);
    out["rotation"] = in_file(parts->rotation);
    out["scale"] = in_file(parts->scale);
  }

  void add_mesh() {
    std::vector<std::array<float, 3>> positions;
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max()), high.fill(std::numeric_limits<float>::lowest());
    for (const Point3& p : model_.vertices) {
      positions.push_back(in_file(p));
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], positions.back()[k]);
        high[k] = std::max(high[k], positions.back()[k]);
      }
    }
    std::vector<std::uint32_t> indices;
    for (const Triangle& triangle : model_.triangles)
      for (const int v : triangle) indices.push_back(static_cast<std::uint32_t>(v));
    const std::size_t position = add_accessor(positions, "VEC3", float_component);
    out_["accessors"][position]["min"] = low;
    out_["accessors"][position]["max"] = high;
    json attributes = {{"POSITION", position}};
    add_weights(attributes);
    const json primitive = {{"attributes", attributes}, {"indices", add_accessor(indices, "SCALAR", uint_component)}};
    out_["meshes"] = json::array({{{"name", model_.name}, {"primitives", json::array({primitive})}}});
  }

  void add_weights(json& attributes) {
    std::size_t most = 1;
    for (const auto& influences : model_.influences) most = std::max(most, influences.size());
    for (std::size_t set = 0; 4 * set < most; ++set) {
      std::vector<std::array<std::uint16_t, 4>> joints;
      std::vector<std::array<float, 4>> weights;
      for (const auto& influences : model_.influences) {
        joints.push_back({}), weights.push_back({});
        for (std::size_t k = 0; k < 4 && 4 * set + k < influences.size(); ++k) {
          joints.back()[k] = static_cast<std::uint16_t>(influences[4 * set + k].joint);
          weights.back()[k] = static_cast<float>(influences[4 * set + k].weight);
        }
      }
      attributes["JOINTS_" + std::to_string(set)] = add_accessor(joints, "VEC4", ushort_component);
      attributes["WEIGHTS_" + std::to_string(set)] = add_accessor(weights, "VEC4", float_component);
    }
  }

  void add(const Clip& clip) {
    json animation = {{"name", clip.name}, {"channels", json::array()}, {"samplers", json::array()}};
    for (const NodeTrack& track : clip.animation.tracks) {
      add(track.positions, track.node, "translation", "VEC3", animation);
      add(track.rotations, track.node, "rotation", "VEC4", animation);
      add(track.scales, track.node, "scale", "VEC3", animation);
    }
    if (!clip.animation.tracks.empty()) out_["animations"].push_back(animation);
  }

  template <class Value>
  void add(const Channel<Value>& channel, int node, const char* path, const char* type, json& animation) {
    std::vector<float> times;
    std::vector<decltype(in_file(Value()))> values;
    for (std::size_t k = 0; k < channel.keys.size(); ++k) {
      const bool cubic = channel.interpolation == Interpolation::cubic;
      times.push_back(static_cast<float>(channel.keys[k].time));
      if (cubic) values.push_back(in_file(channel.tangents[k].into));
      values.push_back(in_file(channel.keys[k].value));
      if (cubic) values.push_back(in_file(channel.tangents[k].out));
    }
    const char* const names[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    animation["channels"].push_back({{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    const std::size_t input = add_accessor(times, "SCALAR", float_component);
    const auto [first, last] = std::minmax_element(times.begin(), times.end());
    out_["accessors"][input]["min"] = {*first};
    out_["accessors"][input]["max"] = {*last};
    animation["samplers"].push_back({{"input", input},
                                     {"output", add_accessor(values, type, float_component)},
                                     {"interpolation", names[static_cast<int>(channel.interpolation)]}});
  }

  const Model& model_;
  std::vector<SceneNode> nodes_;
  json out_;
  std::string bytes_;
};

}  // namespace

std::string gltf_bytes(const Model& model) {
  const DefaultFloatEnvironment environment;
  if (model.skeleton.joints.empty()) throw ModelError(model.name, "skeleton", "there is none to write: see keyed");
  if (!model.morphs.empty()) throw ModelError(model.name, "morph targets", "are not written");
  if (model.skeleton.joints.size() > std::numeric_limits<std::uint16_t>::max())
    throw ModelError(model.name, "skeleton", "has more joints than glTF can name");
  return glb_of(GltfWriter(model).chunks(), model.name);
}

void write_gltf(const Model& model, const std::string& path) {
  const std::string bytes = gltf_bytes(model);
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  if (!out.flush()) throw ModelError(path, "file", "cannot be written");
}

}  // namespace refitlab
