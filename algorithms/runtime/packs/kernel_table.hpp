// SPDX-License-Identifier: MIT
// A kernel's translation units define one table in the namespace of each target. This macro names the table of a target.
#pragma once

#include "algorithms/runtime/packs/targets.hpp"

#ifdef REFITLAB_X86_TARGETS
#define REFITLAB_OF_TARGET(target, table) \
  ((target) == Target::avx512 ? avx512::table : (target) == Target::avx2 ? avx2::table : baseline::table)
#else
#define REFITLAB_OF_TARGET(target, table) (static_cast<void>(target), baseline::table)
#endif
