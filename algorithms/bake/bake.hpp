// SPDX-License-Identifier: GPL-3.0-or-later
// Baking makes everything that refits and queries need of a skinned mesh. It is done once, before any pose.
#pragma once

#include <initializer_list>

#include "algorithms/bake/build_tree.hpp"
#include "algorithms/model/model.hpp"
#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

inline constexpr std::initializer_list<Pieces> all_pieces{Pieces::joint_sets, Pieces::mixed, Pieces::many};

// mesh must be valid (see SkinnedMesh). pieces are the descriptions that the later refits need (RefitVariant::pieces).
// For affine joints there are more pieces, which are tighter where joints scale; for rigid joints there are fewer. The refits
// hold for both. Baking takes some thirty microseconds a triangle. Throws std::invalid_argument for triangles_per_leaf < 1.
Character bake(SkinnedMesh mesh, const TreeOptions& tree = {}, std::initializer_list<Pieces> pieces = all_pieces,
               Joints joints = Joints::rigid);

// Does the same for a model, with its morph targets, mesh after mesh, and with pieces for joints as those of its clips are
// (joints_of).
Character bake(Model model, const TreeOptions& tree = {}, std::initializer_list<Pieces> pieces = all_pieces);
// Does the same with pieces for such joints, whatever those of the clips are.
Character bake(Model model, const TreeOptions& tree, std::initializer_list<Pieces> pieces, Joints joints);

}  // namespace refitlab
