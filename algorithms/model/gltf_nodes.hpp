// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a glTF file are put in the order of a Scene.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/gltf_file.hpp"
#include "algorithms/model/scene.hpp"

namespace refitlab {

struct GltfNodes {
  std::vector<SceneNode> nodes;  // depth first: those of the scene, then all others (a skin may have its joints there)
  std::vector<int> places;       // by the file's index: the node in this order
  int shown = 0;                 // so many of them, the first, are in the scene
};

// The scene is the default one, or else the first one, or else all nodes. Throws ModelError for a node that is below two others,
// below itself, or not there, for a transform that is no affine map, and for a scene that has a node twice, or one below another.
GltfNodes convert_nodes(const tinygltf::Model& source, const std::string& file);

// Returns the transform of a node at rest. Throws ModelError for a rotation by a zero quaternion, and for a node that has a
// matrix.
NodeTransform rest_transform(const tinygltf::Node& node, const std::string& file, const std::string& thing);

}  // namespace refitlab
