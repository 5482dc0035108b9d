// SPDX-License-Identifier: MIT
// Orientations of boxes that are likely to be small around given balls, from the balls' centers.
#pragma once

#include <array>
#include <span>

#include "lemmas/vocabulary/quaternion.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// Unit quaternions, whose rotations take the coordinate axes to the boxes': no rotation; the principal axes of the
// centers [Gottschalk et al. 1996]; and for each side of a large triangle of centers the side, the triangle's normal
// and what is perpendicular to both [Larsson and Kallberg 2011, "Fast computation of tight-fitting oriented bounding
// boxes"]. What does not exist for centers on a line or at one point is replaced by no rotation. balls is not empty.
std::array<Quaternion<double>, 5> box_orientations(std::span<const Ball3<double>> balls);

}  // namespace refitlab
