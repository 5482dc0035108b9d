// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/rigged_gltf.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace proptests::gen {
namespace {

using nlohmann::json;

constexpr int float_component = 5126, short_component = 5123, int_component = 5125;

// The JSON of a scene, and the one buffer that its accessors point into.
class Writer {
 public:
  explicit Writer(const RiggedGltf& scene) {
    json_["asset"] = {{"version", "2.0"}};
    json_["scene"] = 0;
    json_["scenes"] = json::array({{{"nodes", json::array()}}});
    for (const GltfNode& n : scene.nodes) add(n);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      const int parent = scene.nodes[i].parent;
      (parent < 0 ? json_["scenes"][0]["nodes"] : json_["nodes"][parent]["children"]).push_back(i);
    }
    for (const GltfMesh& m : scene.meshes) add(m);
    for (const GltfSkin& s : scene.skins)
      json_["skins"].push_back(
          {{"joints", s.joints}, {"inverseBindMatrices", accessor(s.inverse_bind, "MAT4", float_component)}});
    for (const GltfClip& c : scene.clips) add(c);
  }
  json finished(const std::string& uri) const {
    json out = json_;
    out["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    if (!uri.empty()) out["buffers"][0]["uri"] = uri;
    return out;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class Row>
  std::size_t accessor(const std::vector<Row>& rows, const char* type, int component) {
    const std::size_t length = rows.size() * sizeof(Row);
    json_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}});
    bytes_.append(reinterpret_cast<const char*>(rows.data()), length);
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    json_["accessors"].push_back(
        {{"bufferView", json_["bufferViews"].size() - 1}, {"componentType", component}, {"count", rows.size()}, {"type", type}});
    return json_["accessors"].size() - 1;
  }
  // An accessor over plain numbers that come `width` at a time.
  std::size_t accessor(const std::vector<float>& values, int width) {
    const std::size_t index = accessor(values, width == 4 ? "VEC4" : width == 3 ? "VEC3" : "SCALAR", float_component);
    json_["accessors"][index]["count"] = values.size() / width;
    return index;
  }
  void add(const GltfNode& n) {
    json node = {{"name", n.name}, {"translation", n.translation}, {"rotation", n.rotation}, {"scale", n.scale}};
    if (n.mesh >= 0) node["mesh"] = n.mesh;
    if (n.skin >= 0) node["skin"] = n.skin;
    json_["nodes"].push_back(node);
  }
  void add(const GltfMesh& m) {
    json attributes = {{"POSITION", accessor(m.positions, "VEC3", float_component)}};
    for (std::size_t i = 0; i < m.joints.size(); ++i)
      attributes["JOINTS_" + std::to_string(i)] = accessor(m.joints[i], "VEC4", short_component);
    for (std::size_t i = 0; i < m.weights.size(); ++i)
      attributes["WEIGHTS_" + std::to_string(i)] = accessor(m.weights[i], "VEC4", float_component);
    json primitive = {{"attributes", attributes}};
    if (!m.indices.empty()) primitive["indices"] = accessor(m.indices, "SCALAR", int_component);
    json_["meshes"].push_back({{"primitives", json::array({primitive})}});
  }
  void add(const GltfClip& c) {
    json channels = json::array(), samplers = json::array();
    for (const GltfTrack& t : c.tracks) {
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", t.node}, {"path", t.path}}}});
      samplers.push_back({{"input", accessor(t.times, 1)}, {"output", accessor(t.values, t.path == "rotation" ? 4 : 3)}});
    }
    json_["animations"].push_back({{"name", c.name}, {"channels", channels}, {"samplers", samplers}});
  }

  json json_;
  std::string bytes_;
};

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  if (!out.flush()) throw std::runtime_error(path + ": cannot be written");
}

std::string word(std::uint32_t value) {
  std::string out(4, '\0');
  std::memcpy(out.data(), &value, 4);
  return out;
}

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return out;
}

}  // namespace

std::array<float, 16> translation_matrix(float x, float y, float z) { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}; }

RiggedGltf bending_tube(int joints) {
  RiggedGltf scene;
  GltfSkin skin;
  GltfClip bend{"bend", {}};
  for (int j = 0; j < joints; ++j) {
    GltfNode node{.name = "j" + std::to_string(j), .parent = j - 1};
    if (j > 0) node.translation = {0, 1, 0};
    scene.nodes.push_back(node);
    skin.joints.push_back(j);
    skin.inverse_bind.push_back(translation_matrix(0, static_cast<float>(-j), 0));
    const float half = 0.3f;
    bend.tracks.push_back({j, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, std::sin(half), std::cos(half)}});
  }
  bend.tracks.push_back({0, "translation", {0, 1}, {0, 0, 0, 0.5f, 0, 1}});

  GltfMesh mesh;
  mesh.joints.resize(1), mesh.weights.resize(1);
  for (int ring = 0; ring <= 2 * joints; ++ring) {
    const auto joint = static_cast<std::uint16_t>(std::min(ring / 2, joints - 1));
    const bool shared = ring % 2 == 0 && ring > 0 && ring < 2 * joints;
    for (int k = 0; k < 4; ++k) {
      mesh.positions.push_back({k == 0 || k == 3 ? -0.2f : 0.2f, 0.5f * static_cast<float>(ring), k < 2 ? -0.2f : 0.2f});
      mesh.joints[0].push_back({joint, static_cast<std::uint16_t>(shared ? joint - 1 : 0), 0, 0});
      mesh.weights[0].push_back({shared ? 0.75f : 1.0f, shared ? 0.25f : 0.0f, 0, 0});
    }
  }
  for (std::uint32_t ring = 0; ring < 2 * static_cast<std::uint32_t>(joints); ++ring)
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = 4 * ring + k, b = 4 * ring + (k + 1) % 4;
      mesh.indices.insert(mesh.indices.end(), {a, a + 4, b, b, a + 4, b + 4});
    }
  scene.nodes.push_back({.name = "skin", .mesh = 0, .skin = 0});
  scene.meshes.push_back(mesh);
  scene.skins.push_back(skin);
  scene.clips.push_back(bend);
  return scene;
}

void write_glb(const RiggedGltf& scene, const std::string& path) {
  const Writer writer(scene);
  std::string text = writer.finished("").dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string& bytes = writer.bytes();
  const std::size_t length = 12 + 8 + text.size() + 8 + bytes.size();
  write_file(path, "glTF" + word(2) + word(static_cast<std::uint32_t>(length)) + word(static_cast<std::uint32_t>(text.size())) +
                       "JSON" + text + word(static_cast<std::uint32_t>(bytes.size())) + std::string("BIN\0", 4) + bytes);
}

void write_gltf(const RiggedGltf& scene, const std::string& path) {
  const Writer writer(scene);
  write_file(path, writer.finished("data:application/octet-stream;base64," + base64(writer.bytes())).dump());
}

}  // namespace proptests::gen
