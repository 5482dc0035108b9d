// SPDX-License-Identifier: MIT
// These orientations of boxes are likely to be small around given balls. They come from the balls' centers.
#pragma once

#include <array>
#include <span>

#include "lemmas/vocabulary/quaternion.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Returns unit quaternions, whose rotations take the coordinate axes to the boxes' axes. They are no rotation; the principal axes
// of the centers [Gottschalk et al. 1996]; and for each side of a large triangle of centers the side, the triangle's normal and
// the direction perpendicular to both [Larsson and Kallberg 2011, "Fast computation of tight-fitting oriented bounding boxes"].
// For centers on a line or at one point, orientations that do not exist are replaced by no rotation. balls is not empty.
std::array<Quaternion<double>, 5> box_orientations(std::span<const Ball3<double>> balls);

}  // namespace refitlab
