// SPDX-License-Identifier: GPL-3.0-or-later
// Each joint has a box around all vertices that it moves, however little, in the bind pose. In a pose every box is carried by its
// joint's matrix, and the axis-aligned boxes around the carried boxes are merged.
//
// It is what Bevy does for meshes that have DynamicSkinnedMeshBounds, Godot with its bone AABBs, and PlayCanvas with
// Mesh._initBoneAabbs and MeshInstance.aabb; [Heim et al. 2004] have such a layer of boxes a bone. With linear skinning a
// vertex is a convex combination of its joints' images of it, and each of these is in its joint's carried box, so it is
// in their hull (a1_affine_image, also for joints that scale and shear). With other skinnings it is not: a blended rotation
// swings a vertex out of the hull of its images.
#pragma once

#include "experiments/engines/joint_matrices.hpp"

namespace refitlab {

class JointBoxes {
 public:
  explicit JointBoxes(const SkinnedMesh& mesh);
  // Carries these boxes, by joint.
  explicit JointBoxes(std::vector<Box<double>> bind);

  // Returns the boxes by joint, in the bind pose. That of a joint that moves no vertex is empty.
  const std::vector<Box<double>>& bind() const { return bind_; }
  // Returns a box around all carried boxes. As in engines, it is in float, and its rounding is not allowed for.
  Box<float> box(const JointMatrices& matrices, Target target = best_target()) const;

 private:
  std::vector<Box<double>> bind_;
  JointNumbers numbers_;
};

}  // namespace refitlab
