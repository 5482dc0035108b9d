// SPDX-License-Identifier: MIT
// Here are the refit variants that are proved to enclose their vertices, by name. They share one interface: each node is refitted
// by itself, in any order, and the cost does not grow with the mesh (`mixed` variants skin a node's few vertices).
#pragma once

#include <string>
#include <vector>

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// Computes the ball of one node in the pose of node.palette. It is thread-safe.
using Refit = Ball3<double> (*)(const RefitNode<double>& node);

// A RefitVariant is a refit with its name, and what it needs and bounds.
struct RefitVariant {
  std::string name;         // as in result files: snake_case, fixed
  std::string description;  // one line for tables and reports
  Skinning skinning;        // whose vertices it bounds
  bool sound;               // proved to enclose
  Pieces pieces;
  // This is the certified refit. If the variant is sound, its ball encloses the node's vertices, whether skinned exactly from the
  // pose's numbers or by skin(). The radius includes the slack for all rounding (rounding.hpp).
  Refit refit;
  // This is the same refit without the slack. It is the baseline for the cost and the size of the slack.
  Refit refit_as_computed;
};

// Returns all of them.
const std::vector<RefitVariant>& refit_variants();

// Returns the variant to use unless there is a reason for another. It costs about as much as Algorithm 1: most nodes hold so
// few vertices that skinning these costs less than bounding them. The ball of such a node is first made around the vertices that
// touched it in the reference pose, and mostly encloses the others. On the experiments' characters it is within a tenth of the
// smallest ball on average, and it is exact at the leaves.
const RefitVariant& default_variant(Skinning skinning);

// Throws std::invalid_argument that lists the existing names.
const RefitVariant& refit_variant(const std::string& name);
const RefitVariant& variant_named(const std::string& name, const std::vector<RefitVariant>& variants);

// Throws std::invalid_argument for a palette that make_skinning_palette did not make, or that is one of affine joints unless the
// variant's skinning is linear.
void check_palette(const SkinningPalette<double>& palette, const RefitVariant& variant);

// Returns the balls of all nodes. character must have the variant's pieces. Throws what check_palette throws.
std::vector<Ball3<double>> refit_all(const Character& character, const RefitVariant& variant,
                                     const SkinningPalette<double>& palette);

}  // namespace refitlab
