// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_pieces.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace refitlab {

std::vector<MotionPiece> motion_pieces(const Character& c, std::span<const SimplexPiece> pieces) {
  const DefaultFloatEnvironment environment;
  std::vector<MotionPiece> out;
  for (const SimplexPiece& p : pieces) {
    const Point3 prior = center_prior(c.mesh, c.sets.joints(p.joint_set), Skinning::spherical);
    out.push_back({p.joint_set, p.reference, p.box, (p.reference.center - prior).norm(), p.target});
  }
  return out;
}

}  // namespace refitlab
