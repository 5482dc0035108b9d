// SPDX-License-Identifier: GPL-3.0-or-later
// This finds the pose in which the printed algorithm fails worst.
#pragma once

#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// Returns the twist of one joint by 90, 120, 150 or 175 degrees for which the printed algorithm (with the skinning's own signs,
// so that only its geometry is to blame) has the most balls with a vertex outside. Undefined balls do not count here.
NamedPose worst_twist(const AnimatedCharacter& character);

}  // namespace refitlab
