// ControlLists: what the control balls of a node are made in, for every kind of skinning. The balls are the result.
#pragma once

#include <vector>

#include "algorithms/refit/ball_policy.hpp"

namespace refitlab {

// One corner of a weight simplex, with what is linear in the weights there: spherical blending's.
template <class S>
struct ControlCorner {
  Quaternion<S> rotation;  // q'_k, not of unit length
  Vec<S, 3> center_image;  // r'_k
};

// The same of dual quaternions.
template <class S>
struct DualCorner {
  Quaternion<S> rotation;  // q'_k, not of unit length
  Quaternion<S> dual;      // d'_k
};

// Reused between calls, so that a refit does not allocate.
template <class S>
struct ControlLists {
  RefitLists<S> cap;                         // balls (the result) and the quaternions of the fallback
  std::vector<ControlCorner<S>> corners;     // of the simplices in work, one after the other
  std::vector<DualCorner<S>> dual_corners;   // the same for dual quaternions
  std::vector<S> dots;                       // W_kl, m x m
  std::vector<Vec<S, 3>> products;           // N_kl of degree 2, m x m
};

}  // namespace refitlab
