// SPDX-License-Identifier: GPL-3.0-or-later
// This measures how tight the balls of BD-tree and ours are under reduced deformations, alone and followed by skinning.
#pragma once

#include <string>
#include <vector>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "experiments/deformations/reduced_basis.hpp"
#include "experiments/tightness/levels.hpp"

namespace refitlab {

// Returns the refit before any skinning, which tables call "reference_balls". If no joint moves, its balls bound the vertices.
const RefitVariant& reference_balls();

// DisplacementBalls says which balls of displacements a refit gets.
enum class DisplacementBalls { smallest, bd_tree };

struct ReducedMeasure {
  std::string variant;  // a refit variant, or reference_balls
  DisplacementBalls balls;
  std::vector<LevelTightness> levels;
};

// A ReducedResult is that of a reduced deformation of a model in the poses of its frames.
struct ReducedResult {
  std::string kind;  // vibration, vibration_skinned, or clip: where the basis is of a clip's own skinned vertices
  int frames, size;  // of the basis
  double share;      // of the frames' squared displacements, what the basis has
  int poses;         // those of the frames that were measured
  std::vector<ReducedMeasure> measures;
};

struct ReducedSettings {
  int frames = 60;  // that a basis is made from
  int size = 8;     // of a basis
  int poses = 4;    // of these frames, evenly spread
};

// A ReducedCharacter is a model with a reduced basis in place of its morph targets. It is there as we bake it, and as a BD-tree,
// which has no pieces.
struct ReducedCharacter {
  ReducedBasis basis;
  Character ours, bd_tree;
};
// Returns a model with the basis of its vibration.
ReducedCharacter vibrating_character(const Model& model, const ReducedSettings& settings);

// model must have a clip. Its own morph targets are left out. Progress goes to stdout. Throws ModelError if the first clip is not
// rigid.
std::vector<ReducedResult> measure_reduced(const Model& model, const ReducedSettings& settings);

}  // namespace refitlab
