// SPDX-License-Identifier: MIT
// The refits that are proved to enclose, by name: one interface, each node by itself in any order, no vertex touched.
#pragma once

#include <string>
#include <vector>

#include "algorithms/runtime/tree/character.hpp"

namespace refitlab {

// The ball of one node in the pose of node.palette. Thread-safe.
using Refit = Ball3<double> (*)(const RefitNode<double>& node);

struct RefitVariant {
  std::string name;         // as in result files: snake_case, fixed
  std::string description;  // one line for tables and reports
  Skinning skinning;        // whose vertices it bounds
  bool sound;               // proved to enclose
  Pieces pieces;
  // If the variant is sound, certified: encloses the node's vertices, whether skinned exactly from the pose's numbers or by
  // skin(), with the slack for all rounding in the radius (rounding.hpp).
  Refit refit;
  // The same without that slack: what it costs and how much it adds is measured against this.
  Refit refit_as_computed;
};

const std::vector<RefitVariant>& refit_variants();

// The one to take unless there is a reason for another: no dearer than Algorithm 1 (most nodes hold so few vertices that
// skinning these costs less than bounding them, and their ball is known from those that touched it in the reference
// pose), on the experiments' characters within a tenth of the smallest ball on average, and exact at the leaves.
const RefitVariant& default_variant(Skinning skinning);

// Throws std::invalid_argument that lists the names there are.
const RefitVariant& refit_variant(const std::string& name);
const RefitVariant& variant_named(const std::string& name, const std::vector<RefitVariant>& variants);

// The balls of all nodes. character has the variant's pieces.
std::vector<Ball3<double>> refit_all(const Character& character, const RefitVariant& variant,
                                     const SkinningPalette<double>& palette);

}  // namespace refitlab
