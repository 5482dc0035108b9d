// SPDX-License-Identifier: MIT
// These are boxes around pieces that affine joints move, in linear skinning (a1_affine_image). They are computed in double, a
// piece at a time.
//
// The image of a piece under a blend of joints is within that of its box and within that of its ball, and so within the common
// part of the boxes around both.
//
// Rounding. Let u be half of epsilon, F bound the Frobenius norms of the joints' matrices, and t their offsets. A placement's
// rotation is the matrix of rotate(), which is off by 24 u and of a norm below 2. A blend of n matrices is off by n u F, their
// product with the rotation by 60 u F, an image by 4 u F ||p||. So is a skinned vertex, by the same order of things. F and t of a
// blend are those of its joints, blended with the same weights, even where the joints cancel each other. Where the ball decides a
// side it reaches no farther than the box, so that its radius is within twice the lengths there. The slack is lost_of_affine_box,
// of F ||p|| + t, which proptests/algorithms/bound_budgets.cpp derives. least_affine_box is what may underflow.
#pragma once

#include <span>

#include "algorithms/runtime/collide/simplex_pieces.hpp"

namespace refitlab {

constexpr double lost_of_affine_box(int joints) { return (112 + 2 * joints) * 0x1p-53; }
inline constexpr double least_affine_box = 1e-100;

// AffineSizes are what rounding depends on, of the joints that make up a map: how many they are, F and t.
struct AffineSizes {
  int joints;
  double matrix, offset;
};
AffineSizes sizes_of(const AffineMap<double>& map, int joints);

// Returns a box around the image of what is in the ball and in the box. It is all of space if the ball or the image is not
// finite.
Box<double> box_of_image(const AffineMap<double>& map, const Ball3<double>& ball, const Box<double>& box,
                         const AffineSizes& sizes);

// Returns R C for the linear map R that rotate() is for this quaternion.
AffineMap<double> turned(const Quaternion<double>& rotation, const AffineMap<double>& map);

// Makes boxes[target] for every target of the pieces: around all of their vertices, skinned linearly by the affine joints of
// palette and then turned by rotation.
void bound_affine_boxes(std::span<const SimplexPiece> pieces, const SkinningPalette<double>& palette,
                        const Quaternion<double>& rotation, std::span<Box<double>> boxes);

}  // namespace refitlab
