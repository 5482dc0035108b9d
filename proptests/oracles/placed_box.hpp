// SPDX-License-Identifier: GPL-3.0-or-later
// Returns a box in float that is seen from an origin as a box in the world. Such boxes have more to spare than rounding takes
// here.
#pragma once

#include "algorithms/runtime/collide/cluster_body.hpp"

namespace proptests::oracle {

inline refitlab::Box<double> in_world(refitlab::ClusterBody& body, const refitlab::Box<float>& box) {
  refitlab::Box<double> out;
  for (int i = 0; i < 3; ++i)
    out.low[i] = body.clusters().origin()[i] + box.low[i], out.high[i] = body.clusters().origin()[i] + box.high[i];
  return out;
}

}  // namespace proptests::oracle
