// SPDX-License-Identifier: GPL-3.0-or-later
// Joint capsules make our box around a linearly skinned character at the cost of joint boxes. Each joint carries a capsule, which
// is an axis from one point to another and a radius about it; the box is around all carried capsules.
//
// A capsule need not hold all vertices that its joint moves (weighted_radii.hpp). Joints are rigid here.
//
// Rounding. Let u = 2^-24. Entries of matrices from quaternions in float have an error below 10 u, an image of p has four
// roundings of each of its products, and a quaternion whose squared length is off by 1e-6 turns p by 34 u of its length:
// together, of the coordinate along an axis, below 256 u (||p|| + |t|), where t is the joint's translation along it, which is
// at most that of C p and ||p||. All C p are in the box. So the box is grown along each axis by a share of its own farthest
// coordinate, and the error of p is in the radius. Radii have a share of 1e-5 for the joints' stretch.
#pragma once

#include <array>

#include "experiments/engines/joint_matrices.hpp"

namespace refitlab {

struct JointCapsule {
  std::array<Point3, 2> ends;
  double radius = -1;  // of a joint that moves no vertex; else at least 0
};

// Returns the distance of a point from a capsule's axis.
double distance_from_axis(const JointCapsule& capsule, const Point3& point);

// Returns capsules that fit the mesh, by joint.
std::vector<JointCapsule> fit_capsules(const SkinnedMesh& mesh);

class JointCapsules {
 public:
  // The capsules must fit the mesh.
  JointCapsules(const SkinnedMesh& mesh, const std::vector<JointCapsule>& capsules);
  explicit JointCapsules(const SkinnedMesh& mesh) : JointCapsules(mesh, fit_capsules(mesh)) {}

  // Returns a box around the vertices, linearly skinned with exactly this pose. Coordinates must be in the normal range of
  // float: a model whose size is between 1e-36 and 1e36. Nothing is checked.
  Box<float> box(const JointMatrices& matrices, Target target = best_target()) const;

 private:
  JointNumbers numbers_;
};

}  // namespace refitlab
