// SPDX-License-Identifier: GPL-3.0-or-later
// A SyntheticCase is a refit case in exact rationals. Its generator makes the same cases from a seed on every machine.
//
// A synthetic case is what a node of a sphere tree stands for, without its mesh. For each joint-set it has all vertices of a
// reference ball with all admissible weights. So a ball is right if it holds a continuum, and "true" positions can be as dense as
// wanted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "lemmas/exact/exact.hpp"
#include "lemmas/vocabulary/sphere.hpp"
#include "lemmas/vocabulary/weights.hpp"

namespace refitlab {

using RationalWeights = std::vector<Rational>;

struct SyntheticSet {
  Ball3<Rational> reference;                     // S_z: the joint-set's vertices, in the reference pose
  OwnedPaletteEntry<Rational> palette;           // rotations of exactly unit length, with the skinning's signs
  WeightBounds<Rational> bounds;                 // multiples of 2^-24
  std::vector<RationalWeights> weight_vertices;  // of W': all of them
};

struct SyntheticCase {
  Ball3<Rational> reference;  // S: holds the balls of all joint-sets
  std::vector<SyntheticSet> sets;
  std::string degeneracy;  // one word or two; empty for a general case
};

// Returns the synthetic case of a number of a seed. It has 1 to 3 joint-sets of 1 to 5 joints, and one case in four is
// degenerate. The cases are independent of each other, so that they can be made in any order.
SyntheticCase make_synthetic_case(std::uint64_t seed, std::uint64_t number);

// Returns the weights of a joint-set at which a case is looked at: weight vertices, points between two and mixtures of all of
// them. Weights whose quaternions blend to 0 have no rotation and are left out. The result depends only on the weight vertices
// and rotations.
std::vector<RationalWeights> sampled_weights(const SyntheticSet& set);

// Returns the synthetic cases 0 to count - 1 of a seed as a file of cases (format: proptests/cases/README.md). Each has a vertex
// of its first joint-set that the repaired Algorithm 1 is expected to enclose.
std::string synthetic_cases_as_case_file(std::uint64_t seed, int count);

}  // namespace refitlab
