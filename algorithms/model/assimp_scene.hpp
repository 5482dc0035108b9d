// SPDX-License-Identifier: GPL-3.0-or-later
// Files that assimp reads become scenes: FBX, X, Collada and whatever else it knows with bones.
#pragma once

#include <assimp/scene.h>

#include <string>

#include "algorithms/model/scene.hpp"

namespace refitlab {

// Checks what later steps, assimp's own triangulation among them, take for granted: meshes are not empty, positions are finite,
// indices are in range, and weights are finite and not negative. Throws ModelError otherwise.
void check_assimp_scene(const aiScene& source, const std::string& file);

// Converts a scene that check_assimp_scene let pass and that has only triangles. Each of assimp's meshes is a mesh of one
// primitive with a skin of its own. Channels of nodes that the file does not have are left out, and so are morph targets.
// Throws ModelError for a bone without a node or with a name that two nodes have, for a node transform that is not finite, and
// for a key that is not finite, out of order, or a zero rotation.
Scene convert_scene(const aiScene& source, const std::string& file);

// Returns the scene in a file. Throws ModelError for a file that assimp does not read, and what the functions above throw.
Scene assimp_scene(const std::string& path);

}  // namespace refitlab
