// SPDX-License-Identifier: GPL-3.0-or-later
// Lists rigs with one thing wrong each, and what their refusal has to say.
#pragma once

#include <functional>

#include "proptests/gen/rigged_gltf.hpp"

namespace proptests::gen {

// break_it makes bending_tube(3) wrong.
struct BrokenRig {
  const char* what;
  std::function<void(RiggedGltf&)> break_it;
  std::vector<std::string> words;  // of the refusal
};

std::vector<BrokenRig> broken_rigs();

}  // namespace proptests::gen
