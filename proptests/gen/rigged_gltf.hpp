// SPDX-License-Identifier: GPL-3.0-or-later
// Describes small rigged glTF files, right ones and broken ones: a description is written out byte by byte, without checks.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "proptests/gen/gltf_builder.hpp"

namespace proptests::gen {

struct GltfNode {
  std::string name;
  int parent = -1;
  std::array<float, 3> translation = {0, 0, 0};
  std::array<float, 4> rotation = {0, 0, 0, 1};  // x, y, z, w, as in the file format
  std::array<float, 3> scale = {1, 1, 1};
  int mesh = -1, skin = -1;
};

// Holds influences in sets of four, JOINTS_n and WEIGHTS_n; there are no sets for a mesh without a skin.
struct GltfMesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::uint32_t> indices;
  std::vector<std::vector<std::array<std::uint16_t, 4>>> joints;
  std::vector<std::vector<std::array<float, 4>>> weights;
};

struct GltfSkin {
  std::vector<int> joints;                          // nodes
  std::vector<std::array<float, 16>> inverse_bind;  // column by column
};

struct GltfTrack {
  int node;
  std::string path;  // "translation", "rotation", "scale"
  std::vector<float> times;
  std::vector<float> values;  // 3 or 4 a time
};

struct GltfClip {
  std::string name;
  std::vector<GltfTrack> tracks;
};

struct RiggedGltf {
  std::vector<GltfNode> nodes;
  std::vector<GltfMesh> meshes;
  std::vector<GltfSkin> skins;
  std::vector<GltfClip> clips;
};

// Makes a square tube of `joints` segments along +y, a unit each, whose nodes "j0", "j1", ... hang below each other. There are
// rings of four vertices every half unit; at a joint the two bones share a ring. In the clip "bend" every joint turns about its
// own z by up to 0.6 radian at 1 s, and the first one moves. The last node, "skin", carries the mesh.
RiggedGltf bending_tube(int joints);

std::array<float, 16> translation_matrix(float x, float y, float z);

GltfBuilder built(const RiggedGltf& scene);

// Writes one binary file; throws std::runtime_error where it cannot be written.
void write_glb(const RiggedGltf& scene, const std::string& path);
// Writes the same as a JSON text file with its bytes in a data URI.
void write_gltf(const RiggedGltf& scene, const std::string& path);

}  // namespace proptests::gen
