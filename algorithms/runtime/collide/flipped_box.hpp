// SPDX-License-Identifier: MIT
// A FlippedBox is a box stored as low and -high, each with an unused fourth number, so that merging two boxes is one minimum.
#pragma once

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "algorithms/runtime/packs/transpose.hpp"

namespace refitlab {

struct alignas(32) FlippedBox {
  float of[8];

  void set_all(float to) {  // infinity makes the empty box, -infinity the box of everything
    for (float& x : of) x = to;
  }
  Box<double> box() const { return {{of[0], of[1], of[2]}, {-of[4], -of[5], -of[6]}}; }
};

// Merges boxes, one for each lane. target says by lane which box a lane is merged into.
template <class Pack>
[[gnu::always_inline]] inline void merge_lanes(const Box<Pack>& lanes, const int* target, FlippedBox* boxes) {
  constexpr int width = static_cast<int>(Pack::size());
  alignas(64) float sides[8][width], rows[8 * width];
  for (int i = 0; i < 3; ++i) {
    lanes.low[i].copy_to(sides[i], std::experimental::vector_aligned);
    Pack(-lanes.high[i]).copy_to(sides[4 + i], std::experimental::vector_aligned);
  }
  for (const int unused : {3, 7}) Pack(0.f).copy_to(sides[unused], std::experimental::vector_aligned);
  if constexpr (width >= 8) {
    for (int block = 0; block < width; block += 8) {
      const auto read = [&](int side, int lane, Row<float, 4>& four) { read_row(sides[side] + block + lane, four); };
      transpose_records<8>(read, rows + 8 * block, 8);
    }
  } else {
    for (int i = 0; i < 8 * width; ++i) rows[i] = sides[i % 8][i / 8];
  }
  // Neighbours often have the same target, and then its box stays in a register.
  Row<float, 8> own, merged;
  read_row(boxes[target[0]].of, merged);
  for (int lane = 0; lane < width; ++lane) {
    read_row(rows + 8 * lane, own);
    merged = own < merged ? own : merged;
    if (lane + 1 < width && target[lane + 1] == target[lane]) continue;
    write_row(merged, boxes[target[lane]].of);
    if (lane + 1 < width) read_row(boxes[target[lane + 1]].of, merged);
  }
}

}  // namespace refitlab
