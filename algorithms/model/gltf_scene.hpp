// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 files as scenes, by tinygltf.
#pragma once

#include <string>

#include "algorithms/model/scene.hpp"

namespace refitlab {

// bytes: of a .gltf or .glb file. path: for errors, and where the files of its buffers are.
//
// Read are: any number of meshes, primitives (triangles, strips and fans, indexed or not) and skins; all sets of joints and
// weights; nodes with a matrix or with a translation, rotation and scale; all three interpolations; sparse, normalised and
// quantised accessors; buffers in the file, beside it, and in data URIs. Materials, cameras and lights are
// passed over; morph targets are read as displacements of positions. The nodes are those of the default scene, or of the first, and all that a skin may need besides.
//
// Throws ModelError that names the file, the thing and the reason: what glTF does not allow wherever it makes a difference,
// and compressed geometry.
Scene gltf_scene(const std::string& bytes, const std::string& path);

// By its first bytes or its name.
bool is_gltf(const std::string& bytes, const std::string& path);

}  // namespace refitlab
