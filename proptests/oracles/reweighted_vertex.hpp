// SPDX-License-Identifier: GPL-3.0-or-later
// Returns where the library's own skinning in double would place a vertex if its joints had other weights.
#pragma once

#include <span>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace proptests::oracle {

// Returns the place of the model's first vertex. Its joints, in their order, have these transforms, which are rigid, and these
// weights. The signs of the quaternions are made consistent, and the center is that of the model's joints, as in the library's
// palettes.
refitlab::Point3 reweighted_vertex(const refitlab::Model& model, refitlab::Skinning skinning,
                                   std::span<const refitlab::RigidTransform<double>> transforms, std::span<const double> weights);

}  // namespace proptests::oracle
