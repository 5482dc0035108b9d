// SPDX-License-Identifier: MIT
// How an engine blends the rotations of two clips while one fades to the other (lemmas/c7_crossfade.hpp).
#pragma once

namespace refitlab {

// By the shorter way at even speed (slerp), or linearly and then normalised (nlerp).
enum class RotationBlend { slerp, nlerp };

}  // namespace refitlab
