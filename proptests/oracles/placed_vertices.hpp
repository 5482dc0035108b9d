// SPDX-License-Identifier: GPL-3.0-or-later
// Skins vertices and places them in the world, and says whether a box holds points.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/skinning/skin.hpp"

namespace proptests::oracle {

// Returns all vertices of the mesh, in the world.
inline std::vector<refitlab::Point3> placed_vertices(const refitlab::SkinnedMesh& mesh, const refitlab::JointSets& sets,
                                                     const refitlab::Pose& pose, refitlab::Skinning skinning,
                                                     const refitlab::RigidTransform<double>& placement = {}) {
  auto out = refitlab::skin(mesh, sets, refitlab::make_skinning_palette(mesh, sets, pose, skinning), skinning);
  for (refitlab::Point3& p : out) p = refitlab::apply(placement, p);
  return out;
}

// A box with a NaN holds nothing, and a point with one is held by nothing.
inline bool holds(const refitlab::Box<double>& box, const refitlab::Point3& p) {
  return (box.low.array() <= p.array()).all() && (p.array() <= box.high.array()).all();
}
inline bool holds(const refitlab::Box<double>& box, const std::vector<refitlab::Point3>& points) {
  return std::all_of(points.begin(), points.end(), [&](const refitlab::Point3& p) { return holds(box, p); });
}

}  // namespace proptests::oracle
