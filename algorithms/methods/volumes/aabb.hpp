// SPDX-License-Identifier: MIT
// An Aabb is the box with edges along the axes, which is the k-DOP of the axes alone.
#pragma once

#include "algorithms/methods/volumes/k_dop.hpp"

namespace refitlab {

template <class S>
using Aabb = KDop<S, 6>;

}  // namespace refitlab
