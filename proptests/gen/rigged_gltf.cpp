// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/rigged_gltf.hpp"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace proptests::gen {
namespace {

using nlohmann::json;

// Adds an accessor over plain numbers that come `width` at a time.
std::size_t add_numbers(GltfBuilder& out, const std::vector<float>& values, int width) {
  const char* const type = width == 4 ? "VEC4" : width == 3 ? "VEC3" : "SCALAR";
  const std::size_t index = out.add_accessor(values, type, gltf_float);
  out.json["accessors"][index]["count"] = values.size() / static_cast<std::size_t>(width);
  return index;
}

void add(GltfBuilder& out, const GltfNode& n) {
  json node = {{"name", n.name}, {"translation", n.translation}, {"rotation", n.rotation}, {"scale", n.scale}};
  if (n.mesh >= 0) node["mesh"] = n.mesh;
  if (n.skin >= 0) node["skin"] = n.skin;
  out.json["nodes"].push_back(node);
}

void add(GltfBuilder& out, const GltfMesh& m) {
  json attributes = {{"POSITION", out.add_accessor(m.positions, "VEC3", gltf_float)}};
  for (std::size_t i = 0; i < m.joints.size(); ++i)
    attributes["JOINTS_" + std::to_string(i)] = out.add_accessor(m.joints[i], "VEC4", gltf_ushort);
  for (std::size_t i = 0; i < m.weights.size(); ++i)
    attributes["WEIGHTS_" + std::to_string(i)] = out.add_accessor(m.weights[i], "VEC4", gltf_float);
  json primitive = {{"attributes", attributes}};
  if (!m.indices.empty()) primitive["indices"] = out.add_accessor(m.indices, "SCALAR", gltf_uint);
  out.json["meshes"].push_back({{"primitives", json::array({primitive})}});
}

void add(GltfBuilder& out, const GltfClip& c) {
  json channels = json::array(), samplers = json::array();
  for (const GltfTrack& t : c.tracks) {
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", t.node}, {"path", t.path}}}});
    const std::size_t input = add_numbers(out, t.times, 1);
    samplers.push_back({{"input", input}, {"output", add_numbers(out, t.values, t.path == "rotation" ? 4 : 3)}});
  }
  out.json["animations"].push_back({{"name", c.name}, {"channels", channels}, {"samplers", samplers}});
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  if (!out.flush()) throw std::runtime_error(path + ": cannot be written");
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

GltfBuilder built(const RiggedGltf& scene) {
  GltfBuilder out;
  out.json["scene"] = 0;
  out.json["scenes"] = json::array({{{"nodes", json::array()}}});
  for (const GltfNode& n : scene.nodes) add(out, n);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const int parent = scene.nodes[i].parent;
    (parent < 0 ? out.json["scenes"][0]["nodes"] : out.json["nodes"][parent]["children"]).push_back(i);
  }
  for (const GltfMesh& m : scene.meshes) add(out, m);
  for (const GltfSkin& s : scene.skins)
    out.json["skins"].push_back(
        {{"joints", s.joints}, {"inverseBindMatrices", out.add_accessor(s.inverse_bind, "MAT4", gltf_float)}});
  for (const GltfClip& c : scene.clips) add(out, c);
  return out;
}

void write_glb(const RiggedGltf& scene, const std::string& path) { write_file(path, built(scene).binary_file()); }
void write_gltf(const RiggedGltf& scene, const std::string& path) { write_file(path, built(scene).text_file()); }

}  // namespace proptests::gen
