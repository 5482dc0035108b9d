// SPDX-License-Identifier: GPL-3.0-or-later
// Rounded joint boxes: our box around a linearly skinned character at about the cost of joint boxes. Each joint carries a box
// grown by a radius in all directions, and the box of the character is around all of them. Each vertex asks for one inequality
// (a4_joint_volumes), which makes the boxes sound for rigid joints in every pose. Among sound boxes, a linear program picks those
// that make the box of the character small (box_program.hpp) in poses that are expected, such as those of clips.
//
// A block of joints, as kernels take them, has balls instead, which cost less, where that makes the character's box hardly
// larger.
//
// Rounding. Let u = 2^-24. Entries of matrices from quaternions in float have an error below 10 u, an image of p has four
// roundings of each of its products, and a quaternion whose squared length is off by 1e-6 turns p by 34 u of its length:
// together, of the coordinate along an axis, below 256 u (||p|| + |t|), where t is the joint's translation along it, which is
// at most that of C p and ||p||. All C p are in the box. So the box is grown along each axis by a share of its own farthest
// coordinate, and the error of p is in the radius. Radii and half extents have a share of 1e-5 for the joints' stretch and for
// roundings of their own.
#pragma once

#include <span>

#include "experiments/engines/joint_matrices.hpp"

namespace refitlab {

struct RoundedBox {
  Point3 center = Point3::Zero(), half = Point3::Zero();
  double radius = -1;  // of a joint that moves no vertex; else at least 0
};

// Returns the smallest ball around the box with its radius, which is at least 0: a box without half extents.
RoundedBox ball_around(const RoundedBox& box);
// Returns the distance of a point from the box without its radius.
double distance_from_box(const RoundedBox& box, const Point3& point);

// Returns the boxes by joint. They are fitted to the reference pose if none is expected.
std::vector<RoundedBox> fit_rounded_boxes(const SkinnedMesh& mesh, std::span<const Pose> expected);

class RoundedBoxes {
 public:
  // The boxes must be sound for the mesh.
  RoundedBoxes(const SkinnedMesh& mesh, const std::vector<RoundedBox>& boxes);
  RoundedBoxes(const SkinnedMesh& mesh, std::span<const Pose> expected) : RoundedBoxes(mesh, fit_rounded_boxes(mesh, expected)) {}

  // Returns a box around the vertices, linearly skinned with exactly this pose. Coordinates must be in the normal range of
  // float: a model whose size is between 1e-36 and 1e36. Nothing is checked.
  Box<float> box(const JointMatrices& matrices, Target target = best_target()) const;

 private:
  JointNumbers numbers_;
  std::vector<unsigned char> are_balls_;  // by block
};

}  // namespace refitlab
