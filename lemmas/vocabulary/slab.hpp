// SPDX-License-Identifier: MIT
// A Slab holds the points between two parallel planes, {x : low <= (n, x) <= high}. The direction n is known from elsewhere.
#pragma once

namespace refitlab {

template <class S>
struct Slab {
  S low, high;
};

}  // namespace refitlab
