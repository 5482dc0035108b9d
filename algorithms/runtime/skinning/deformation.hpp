// SPDX-License-Identifier: MIT
// A deformation is what a pose does to the vertices of the reference pose before its rigid joints move them: morph targets, and
// then the first phase of skinning by joints that scale.
//
// Spherical and dual quaternion skinning of affine joints C_j has two phases (a2_two_phase_skinning). With C_j = R_j S_j, the S_j
// scale and shear about the joint's origin, and are blended linearly; then the R_j are blended as usual. The weights of a vertex
// are the same in both phases and do not change. So the first phase makes another reference pose, and everything that is known of
// rigid joints holds for it. Linear skinning blends the C_j themselves, and has no first phase.
#pragma once

#include "algorithms/runtime/skinning/blend.hpp"
#include "lemmas/vocabulary/displacement.hpp"

namespace refitlab {

struct Deformation {
  std::vector<double> weights = {};  // m_k by morph target; none where no target moves anything
  AffinePose scales = {};            // S_j by joint; none where no joint scales

  bool is_none() const { return weights.empty() && scales.empty(); }
};

// Throws ModelError if there are weights, but not one for each morph target of the mesh; for a weight that is not finite; for
// weights whose absolute values sum to more than largest_stretch; and for scales that check_pose refuses.
void check_deformation(const SkinnedMesh& mesh, const Deformation& deformation);

// Returns the palette of the S_j. It has no joint-sets if no joint scales.
SkinningPalette<double> make_scale_palette(const SkinnedMesh& mesh, const JointSets& sets, const AffinePose& scales);

// Returns the vertex as the second phase has it, v'' = sum w_i S_i (v + sum m_k d_k). scales is the entry of its joint-set, which
// has no maps if no joint scales. weights are by target, and empty if no target moves.
template <class S>
Vec<S, 3> deformed(const Vec<S, 3>& v, std::span<const Displacement<S>> displacements, std::span<const S> weights,
                   const PaletteEntry<S>& scales, std::span<const S> w) {
  const Vec<S, 3> moved = weights.empty() ? v : displaced(v, displacements, weights);
  return scales.maps.empty() ? moved : blend_linear(scales, w, moved);
}

// A SplitJoint is C = R S of an affine joint.
struct SplitJoint {
  RigidTransform<double> rigid;
  AffineMap<double> scale;
};

// Splits by the polar decomposition of the joint's matrix: R has the rotation nearest to it, and S is symmetric about origin,
// which it leaves where it is. If a joint mirrors, S has a negative eigenvalue. The product of the two is off from C by rounding.
// Bounds and skin() take the same computed R and S, so nothing is lost between them. Against exact factors there is no slack, and
// none could be given: where two singular values of the matrix are opposite or both are small, the matrix does not determine R.
SplitJoint split(const AffineMap<double>& joint, const Point3& origin);

// A SplitPose is a pose of affine joints as both phases take it.
struct SplitPose {
  Pose pose;
  AffinePose scales;
};

// Splits every joint about its own origin. Throws ModelError as check_pose does. (What takes the scales refuses those that
// stretch by more than 1e4 in some direction.)
SplitPose split(const SkinnedMesh& mesh, const AffinePose& pose);

}  // namespace refitlab
