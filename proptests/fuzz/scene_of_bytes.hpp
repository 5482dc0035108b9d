// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as assimp could have read it from some file, from bytes: mostly a sensible rig, and anything may be wrong.
#pragma once

#include <assimp/scene.h>

#include <memory>
#include <string>

namespace proptests::fuzz {

// Up to 8 nodes, 3 meshes of up to 12 vertices and 16 faces, 4 bones a mesh, and 2 clips. Of no bytes: one empty mesh.
std::unique_ptr<aiScene> scene_of_bytes(const std::string& bytes);

}  // namespace proptests::fuzz
