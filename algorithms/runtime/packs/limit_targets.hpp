// SPDX-License-Identifier: MIT
// A program that compares targets, or stands in for an older processor, can do without the wider ones.
#pragma once

#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// Removes the targets that are wider than this one from available_targets(), so that best_target() is this one. Call it before
// anything else of the library: what was made before keeps its kernels, and no other thread may use the library meanwhile. Throws
// std::invalid_argument, and removes none, if this program does not have the target or this processor does not run it.
void limit_targets(Target widest);

}  // namespace refitlab
