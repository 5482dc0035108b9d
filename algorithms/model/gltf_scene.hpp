// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 files become scenes by tinygltf.
#pragma once

#include <string>

#include "algorithms/model/scene.hpp"

namespace refitlab {

// bytes are those of a .gltf or .glb file. path is for error messages, and the files of its buffers are beside it.
//
// The function reads any number of meshes, primitives (triangles, strips and fans, indexed or not) and skins; all sets of joints
// and weights; nodes with a matrix or with a translation, rotation and scale; all three interpolations; sparse, normalised and
// quantised accessors; buffers in the file, beside it, and in data URIs. It skips materials, cameras and lights, and reads morph
// targets as displacements of positions. The nodes are those of the default scene, or of the first, and all others that a skin
// may need.
//
// Throws ModelError that names the file, the thing and the reason. It refuses compressed geometry, and content that glTF does not
// allow, wherever it makes a difference.
Scene gltf_scene(const std::string& bytes, const std::string& path);

// Returns whether a file is glTF, by its first bytes or its name.
bool is_gltf(const std::string& bytes, const std::string& path);

}  // namespace refitlab
