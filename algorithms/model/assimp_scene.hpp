// SPDX-License-Identifier: GPL-3.0-or-later
// What assimp reads, as a scene: FBX, X, Collada and whatever else it knows with bones.
#pragma once

#include <assimp/scene.h>

#include <string>

#include "algorithms/model/scene.hpp"

namespace refitlab {

// What later steps take for granted, assimp's own triangulation among them: meshes that are not empty, finite
// positions, indices in range, weights that are finite and not negative. Throws ModelError.
void check_assimp_scene(const aiScene& source, const std::string& file);

// A scene that check_assimp_scene let pass, by its triangles. Each of assimp's meshes is a mesh of one primitive with a skin of
// its own. Channels of nodes that the file does not have are left out, and so are morph targets.
// Throws ModelError: a bone without a node or with a name that two nodes have, a node transform that is not finite, a key
// that is not finite, out of order, or a zero rotation.
Scene convert_scene(const aiScene& source, const std::string& file);

// The scene in a file. Throws ModelError for one that assimp does not read, and what the above throw.
Scene assimp_scene(const std::string& path);

}  // namespace refitlab
