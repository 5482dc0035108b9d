// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes and skins of a glTF file.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/gltf_nodes.hpp"
#include "algorithms/model/gltf_numbers.hpp"

namespace refitlab {

// All meshes, by the file's index; strips and fans as triangles, points and lines without any.
// Throws ModelError that names the mesh, the primitive, the vertex or index, and the reason.
std::vector<SceneMesh> convert_meshes(const tinygltf::Model& source, const GltfNumbers& numbers, const std::string& file);

// All skins, by the file's index. Inverse bind matrices that are missing are identities.
// Throws ModelError for fewer matrices than joints, for a joint that there is not, and for a skin without joints.
std::vector<SceneSkin> convert_skins(const tinygltf::Model& source, const GltfNodes& nodes, const GltfNumbers& numbers,
                                     const std::string& file);

// The meshes that nodes of the scene show, each with its skin, in the order of the nodes.
// Throws ModelError for a mesh or skin that there is not, and for joints or weights that do not go with the skin.
std::vector<ShownMesh> convert_shown(const tinygltf::Model& source, const GltfNodes& nodes, const Scene& scene);

}  // namespace refitlab
