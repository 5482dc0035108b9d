// SPDX-License-Identifier: GPL-3.0-or-later
// The real models of the experiments and of the tests, which experiments/fetch_models leaves in out/models.
#pragma once

#include <array>

namespace refitlab {

inline constexpr std::array real_models{"BCN_Epileptic.X", "Testwuson.X", "Soldier.glb", "leftHandHigh.glb"};  // files

}  // namespace refitlab
