// SPDX-License-Identifier: MIT
// Slab: the points between two parallel planes, {x : low <= (n, x) <= high}, for a direction n that is known.
#pragma once

namespace refitlab {

template <class S>
struct Slab {
  S low, high;
};

}  // namespace refitlab
