// FlippedBox: low and -high, each with an unused fourth, so that merging two boxes is one minimum.
#pragma once

#include "algorithms/runtime/packs/transpose.hpp"

namespace refitlab {

struct alignas(32) FlippedBox {
  float of[8];
};

// Merges boxes, a lane each, into those that target says by lane. sides: the low and the -high of each lane, row by row
// as in FlippedBox.
template <int width>
[[gnu::always_inline]] inline void merge_lanes(const float (&sides)[8][width], const int* target, FlippedBox* boxes) {
  using Row = EightOf<float>::Row;
  alignas(64) float rows[8 * width];
  if constexpr (width >= 8) {
    for (int block = 0; block < width; block += 8) {
      const float* from[8];
      for (int i = 0; i < 8; ++i) from[i] = sides[i] + block;
      transpose<float>(from, rows + 8 * block, 8);
    }
  } else {
    for (int i = 0; i < 8 * width; ++i) rows[i] = sides[i % 8][i / 8];
  }
  for (int lane = 0; lane < width; ++lane) {
    Row& of = *reinterpret_cast<Row*>(boxes[target[lane]].of);
    const Row own = *reinterpret_cast<const Row*>(rows + 8 * lane);
    of = own < of ? own : of;
  }
}

}  // namespace refitlab
