// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes and skins of a glTF file are converted here.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/gltf_nodes.hpp"
#include "algorithms/model/gltf_numbers.hpp"

namespace refitlab {

// Returns all meshes, by the file's index. Strips and fans become triangles; points and lines have none. Throws ModelError that
// names the mesh, the primitive, the vertex or index, and the reason.
std::vector<SceneMesh> convert_meshes(const tinygltf::Model& source, const GltfNumbers& numbers, const std::string& file);

// Returns all skins, by the file's index. Missing inverse bind matrices are identities.
// Throws ModelError for fewer matrices than joints, for a joint that does not exist, and for a skin without joints.
std::vector<SceneSkin> convert_skins(const tinygltf::Model& source, const GltfNodes& nodes, const GltfNumbers& numbers,
                                     const std::string& file);

// Returns the meshes that nodes of the scene show, each with its skin, in the order of the nodes. Throws ModelError for a mesh or
// skin that does not exist, and for joints or weights that do not fit the skin.
std::vector<ShownMesh> convert_shown(const tinygltf::Model& source, const GltfNodes& nodes, const Scene& scene);

// Adds a note to the scene if nodes that are not in it show meshes.
void note_other_scenes(const tinygltf::Model& source, const GltfNodes& nodes, Scene& scene);

}  // namespace refitlab
