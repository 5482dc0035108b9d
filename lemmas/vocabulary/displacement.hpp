// SPDX-License-Identifier: MIT
// Morph targets or reduced coordinates displace vertices before they are skinned: v = v_0 + sum m_k d_k.
#pragma once

#include <span>

#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {

// A Displacement is d_k of a vertex by one target. A vertex has one for each target that moves it.
template <class S>
struct Displacement {
  int target;
  Vec<S, 3> by;
};

template <class S>
Vec<S, 3> displaced_by(const Vec<S, 3>& v, const Vec<S, 3>& by, const S& weight) {
  return v + by * weight;
}

// Returns v. weights holds m_k by target.
template <class S>
Vec<S, 3> displaced(const Vec<S, 3>& reference, std::span<const Displacement<S>> displacements, std::span<const S> weights) {
  Vec<S, 3> v = reference;
  for (const Displacement<S>& d : displacements) v = displaced_by<S>(v, d.by, weights[static_cast<std::size_t>(d.target)]);
  return v;
}

}  // namespace refitlab
