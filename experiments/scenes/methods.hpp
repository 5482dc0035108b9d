// SPDX-License-Identifier: GPL-3.0-or-later
// Methods: what the experiments compare, one name each in result files and in the report.
#pragma once

#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

// A refit variant, with what a frame's balls know of each other or without.
struct Method {
  std::string name, description;
  const RefitVariant* variant;
  FrameOptions options;

  bool stands_alone() const { return options.most_joint_sets == 0 && !options.children_first; }
};

// Every refit variant by itself. Each default one (default_variant) is followed by the same through BVH cuts and children first.
const std::vector<Method>& methods();

// Throws std::invalid_argument for a name that is not one of them.
const Method& method(const std::string& name);

// The balls of all nodes in this pose, children before parents.
std::vector<Ball3<double>> refit_all(const Character& character, const Method& method, const SkinningPalette<double>& palette);

}  // namespace refitlab
