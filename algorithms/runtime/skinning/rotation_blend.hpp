// SPDX-License-Identifier: MIT
// A RotationBlend says how an engine blends the rotations of two clips while one fades to the other (lemmas/c7_crossfade.hpp).
#pragma once

namespace refitlab {

// slerp goes the shorter way at even speed; nlerp blends linearly and then normalises.
enum class RotationBlend { slerp, nlerp };

}  // namespace refitlab
