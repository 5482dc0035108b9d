// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments compare methods. Each has one name in result files and in the report.
#pragma once

#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

// A Method is a refit variant, with or without what a frame's balls know of each other.
struct Method {
  std::string name, description;
  const RefitVariant* variant;
  FrameOptions options;

  bool stands_alone() const { return options.most_joint_sets == 0 && !options.children_first; }
};

// Returns every refit variant by itself. Each default one (default_variant) is followed by the same through BVH cuts and children
// first.
const std::vector<Method>& methods();

// Returns the method of this name. Throws std::invalid_argument for an unknown name.
const Method& method(const std::string& name);

// Returns the balls of all nodes in this pose. They are made children before parents.
std::vector<Ball3<double>> refit_all(const Character& character, const Method& method, const SkinningPalette<double>& palette);

}  // namespace refitlab
