// SPDX-License-Identifier: GPL-3.0-or-later
// SyntheticCase: a refit case in exact rationals, and a generator that makes the same cases of a seed on every machine.
//
// A synthetic case is what a node of a sphere tree stands for, without its mesh: for each joint-set all vertices of a
// reference ball with all admissible weights. So a ball is right if it holds a continuum, and "true" positions can be had
// as densely as wanted.
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

// The synthetic case of a number of a seed: 1 to 3 joint-sets of 1 to 5 joints; one case in four is degenerate. The cases
// are independent of each other, so that they can be made in any order.
SyntheticCase make_synthetic_case(std::uint64_t seed, std::uint64_t number);

// Weights of a joint-set at which a case is looked at: weight vertices, points between two and mixtures of all of them.
// Without those whose quaternions blend to 0, which have no rotation. The same for the same weight vertices and rotations.
std::vector<RationalWeights> sampled_weights(const SyntheticSet& set);

// Synthetic cases 0 to count - 1 of a seed as a file of cases (format: proptests/cases/README.md): each with a vertex of
// its first joint-set that the repaired Algorithm 1 is expected to enclose.
std::string synthetic_cases_as_case_file(std::uint64_t seed, int count);

}  // namespace refitlab
