// SPDX-License-Identifier: MIT
// Targets are the instruction sets that kernels are compiled for. One of them is picked when the program runs.
//
// A kernel is one source file, *_kernel.cpp, compiled once a target into the namespace REFITLAB_TARGET. Other code calls it
// through a table of function pointers. Only plain numbers and pointers cross: an inline function of a type that both sides use,
// compiled for the wider target, could be linked in place of the common one. So every function that a kernel calls is inlined
// into its entry points (REFITLAB_KERNEL), and the build fails if it leaves another symbol behind (.ci/lone_kernels.cmake).
#pragma once

#include <vector>

#ifndef REFITLAB_TARGET
#define REFITLAB_TARGET baseline
#endif
#define REFITLAB_KERNEL __attribute__((flatten))

namespace refitlab {

enum class Target {
  baseline,  // what all other code is compiled for: on x86-64, 2 doubles or 4 floats
  avx2,      // x86-64-v3: 4 or 8
  avx512     // x86-64-v4: 8 or 16
};

const char* name_of(Target target);

// Returns the targets that this program has and this processor runs. The narrowest comes first.
const std::vector<Target>& available_targets();
inline Target best_target() { return available_targets().back(); }

}  // namespace refitlab
