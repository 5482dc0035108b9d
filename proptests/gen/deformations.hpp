// SPDX-License-Identifier: GPL-3.0-or-later
// Draws what deforms a character: morph targets, their weights, and affine joints, from all over what is accepted.
#pragma once

#include <random>

#include "algorithms/runtime/skinning/deformation.hpp"

namespace proptests::gen {

// Adds up to five morph targets, which move all vertices or some: by nothing, a little, as far as the mesh is large, or farther.
void add_targets(refitlab::SkinnedMesh& mesh, std::mt19937& random);

// Draws a weight for each target: 0, 1, in between, or anywhere; large ones are rare.
std::vector<double> random_weights(const refitlab::SkinnedMesh& mesh, std::mt19937& random);

enum class JointKind { rigid, uniform, axes, shear, mirrored, flat, extreme, mixed };
inline constexpr int joint_kind_count = 8;

// Draws joints that are all of one kind, or each of its own. They turn about their origins, and lengths are those of the mesh.
refitlab::AffinePose random_affine_pose(const refitlab::SkinnedMesh& mesh, JointKind kind, std::mt19937& random);

// Draws the scales of such joints alone.
refitlab::AffinePose random_scales(const refitlab::SkinnedMesh& mesh, JointKind kind, std::mt19937& random);

}  // namespace proptests::gen
