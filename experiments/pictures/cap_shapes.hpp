// SPDX-License-Identifier: GPL-3.0-or-later
// These are shapes of spherical geometry in space, as meshes and lines.
#pragma once

#include "experiments/render/scene.hpp"
#include "lemmas/vocabulary/cap.hpp"

namespace refitlab {

// Returns the part of the sphere's surface, a little outside it so that it covers the surface.
render::MeshShape cap_shape(const Cap<double, 3>& cap, render::Color color);

// Returns the border of a half-space near its point that is nearest to 0. It is a disc of this radius.
render::MeshShape border_shape(const HalfSpace<double, 3>& half_space, double radius, render::Color color);

}  // namespace refitlab
