// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/reweighted_vertex.hpp"

#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace proptests::oracle {

using namespace refitlab;

Point3 reweighted_vertex(const Model& model, Skinning skinning, std::span<const RigidTransform<double>> transforms,
                         std::span<const double> weights) {
  OwnedPaletteEntry<double> palette;
  palette.transforms.assign(transforms.begin(), transforms.end());
  make_signs_consistent<double>(palette.transforms);
  if (skinning == Skinning::dual_quaternion) place_duals(palette);
  if (skinning == Skinning::spherical) {
    const JointSets sets(model);
    const Point3 prior = center_prior(model, sets.joints(sets.of_vertex(0)), skinning);
    place_rotation_center(palette, rotation_center<double>(palette.transforms, prior));
  }
  return blend<double>(skinning, palette, weights, model.vertices[0]);
}

}  // namespace proptests::oracle
