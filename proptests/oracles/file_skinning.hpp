// SPDX-License-Identifier: GPL-3.0-or-later
// Skins a model file by assimp's own types: single precision, straight matrices, no welding, no rigidity.
#pragma once

#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <string>
#include <vector>

namespace proptests::oracle {

class FileSkinning {
 public:
  // Throws std::runtime_error if assimp does not read it.
  explicit FileSkinning(const std::string& path);
  // Returns every triangle, node by node, depth first, in the space of the file's scene. Each corner is sum w G O v / sum w, with
  // G the global transform of the bone's node at that time (s) and O its offset matrix, or G v for a mesh without bones.
  // Triangles of which two vertices agree in position and weights are left out.
  std::vector<std::array<aiVector3D, 3>> posed_triangles(unsigned clip, double time) const;

 private:
  Assimp::Importer importer_;
  const aiScene* scene_;
};

}  // namespace proptests::oracle
