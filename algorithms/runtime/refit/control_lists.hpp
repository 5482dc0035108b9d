// SPDX-License-Identifier: MIT
// ControlLists is the working storage for the control balls of a node, for every kind of skinning. The balls are the result.
#pragma once

#include <vector>

#include "algorithms/runtime/refit/ball_policy.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

namespace refitlab {

// The lists are reused between calls, so that a refit does not allocate.
template <class S>
struct ControlLists {
  RefitLists<S> cap;                                  // balls (the result) and the quaternions of the fallback
  std::vector<BlendedJoints<S>> weight_vertices;      // of the simplices in progress, one after another: q'_k and r'_k
  std::vector<BlendedDuals<S>> dual_weight_vertices;  // the same for dual quaternions: q'_k and d'_k
  std::vector<S> dots;                                // W_kl, m x m
  std::vector<Vec<S, 3>> products;                    // N_kl of degree 2, m x m
};

}  // namespace refitlab
