// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/posed_character.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/skin.hpp"

namespace refitlab {

void PosedCharacter::begin(ClusterBody& body, const RigidTransform<double>& placement) const {
  if (affine.empty()) body.begin(pose, placement);
  else body.begin(affine, placement);
}

PosedCharacter posed_character(Model model, const Animation& animation, double time, Skinning skinning) {
  const DefaultFloatEnvironment environment;
  Pose rigid;
  AffinePose affine;
  Deformation deformation{morph_weights(model, animation, time), {}};
  // Linear skinning blends the matrices as they are, be they nearly rigid or not.
  if (skinning != Skinning::linear && rigidity_defect(skin_matrices(model.skeleton, animation, time)) <= rigidity_tolerance) {
    rigid = pose(model.skeleton, animation, time).pose;
  } else {
    affine = affine_pose(model.skeleton, animation, time);
    if (skinning != Skinning::linear) {
      SplitPose phases = split(model, affine);
      rigid = std::move(phases.pose), deformation.scales = std::move(phases.scales);
      affine.clear();
    }
  }
  SkinnedMesh mesh = skinned_mesh(std::move(model));
  if (!deformation.is_none()) mesh.vertices = deformed_vertices(mesh, JointSets(mesh), deformation);
  mesh.targets = {};
  return {bake(std::move(mesh), {}, {}), std::move(rigid), std::move(affine)};
}

}  // namespace refitlab
