// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a scene as assimp could have read it from some file, from bytes: mostly a sensible rig, in which anything may be wrong.
#pragma once

#include <assimp/scene.h>

#include <memory>
#include <string>

namespace proptests::fuzz {

// Returns a scene of up to 8 nodes, 3 meshes of up to 12 vertices and 16 faces, 4 bones for each mesh, and 2 clips. No bytes make
// one empty mesh.
std::unique_ptr<aiScene> scene_of_bytes(const std::string& bytes);

}  // namespace proptests::fuzz
