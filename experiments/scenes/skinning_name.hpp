// SPDX-License-Identifier: GPL-3.0-or-later
// These are the names of the ways of skinning in tables of results.
#pragma once

#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab {

inline const char* table_name_of(Skinning skinning) {
  switch (skinning) {
    case Skinning::linear: return "linear";
    case Skinning::spherical: return "spherical";
    case Skinning::hejl: return "hejl";
    case Skinning::dual_quaternion: break;
  }
  return "dual_quaternion";
}

}  // namespace refitlab
