// SPDX-License-Identifier: MIT
// TriangleGroup: a few triangles of a cluster that lie side by side and share a box.
#pragma once

#include <array>
#include <cstdint>

namespace refitlab {

inline constexpr int group_size = 8;  // at most

struct TriangleGroup {
  int count;
  std::array<int, group_size> triangles;                         // of the model
  std::array<std::array<std::uint16_t, 3>, group_size> corners;  // by place in the cluster
};

}  // namespace refitlab
