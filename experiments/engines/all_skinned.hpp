// SPDX-License-Identifier: GPL-3.0-or-later
// AllSkinned skins all vertices. It finds the true box of a pose, and no smaller box will do.
//
// three.js computes it for a SkinnedMesh, whose computeBoundingBox skins every vertex on the processor, when a program asks
// it to. Here packs skin the vertices, in double, as exactly as skin() does.
#pragma once

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"

namespace refitlab {

class AllSkinned {
 public:
  // mesh and sets must outlive this.
  AllSkinned(const SkinnedMesh& mesh, const JointSets& sets)
      : mesh_(mesh),
        sets_(sets),
        packed_(mesh, sets),
        vertices_(mesh.vertices.size()) {}

  Box<double> box(const Pose& pose, Skinning skinning, Target target = best_target()) {
    const DefaultFloatEnvironment environment;
    make_skinning_palette(mesh_, sets_, pose, skinning, palette_);
    packed_.skin_all(palette_, skinning, vertices_, target);
    return box_around<double>(vertices_);
  }
  // Returns the vertices of the last pose.
  const std::vector<Point3>& vertices() const { return vertices_; }

 private:
  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  PackedVertices packed_;
  SkinningPalette<double> palette_;
  std::vector<Point3> vertices_;
};

}  // namespace refitlab
