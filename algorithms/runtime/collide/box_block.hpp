// SPDX-License-Identifier: MIT
// A BoxBlock has eight boxes side by side, in the layout in which packs compare them with one box.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/packs/pack.hpp"

namespace refitlab {

inline constexpr int boxes_of_block = 8;

template <class S>
struct alignas(64) BoxBlock {
  S side[6][boxes_of_block];  // low x, y, z, high x, y, z, by lane

  template <class Point>
  void put(int lane, const Box<S, Point>& box) {
    for (int i = 0; i < 3; ++i) side[i][lane] = box.low[i], side[3 + i][lane] = box.high[i];
  }
  Box<S> get(int lane) const {
    return {{side[0][lane], side[1][lane], side[2][lane]}, {side[3][lane], side[4][lane], side[5][lane]}};
  }
};

// Returns how many blocks so many boxes take.
inline int blocks_of(int boxes) { return (boxes + boxes_of_block - 1) / boxes_of_block; }

// put_box writes box i of the boxes in blocks, and get_box reads it.
template <class S>
void put_box(BoxBlock<S>* blocks, int i, const Box<S>& box) {
  blocks[i / boxes_of_block].put(i % boxes_of_block, box);
}
template <class S>
Box<S> get_box(const BoxBlock<S>* blocks, int i) {
  return blocks[i / boxes_of_block].get(i % boxes_of_block);
}

// Says which boxes of a block are not apart from a box. The result has a byte for each lane, the first lowest, with the
// value 1 or 0.
template <class S>
[[gnu::always_inline]] inline std::uint64_t meeting(const BoxBlock<S>& block, const Box<S>& box) {
  using P = Pack<S>;
  constexpr int width = std::min(static_cast<int>(P::size()), boxes_of_block);
  using Lanes = Pack<S, width>;
  Box<Lanes> all;
  for (int i = 0; i < 3; ++i) all.low[i] = Lanes(box.low[i]), all.high[i] = Lanes(box.high[i]);
  alignas(64) bool meets[boxes_of_block];
  for (int first = 0; first < boxes_of_block; first += width) {
    Box<Lanes> own;
    for (int i = 0; i < 3; ++i) {
      own.low[i] = Lanes(block.side[i] + first, std::experimental::vector_aligned);
      own.high[i] = Lanes(block.side[3 + i] + first, std::experimental::vector_aligned);
    }
    (!are_apart(own, all)).copy_to(meets + first, std::experimental::element_aligned);
  }
  return std::bit_cast<std::uint64_t>(meets);
}

// Returns the bytes of the first count lanes, of at most boxes_of_block.
inline std::uint64_t first_bytes(std::uint64_t lanes, int count) {
  return count < boxes_of_block ? lanes & ((1ull << 8 * count) - 1) : lanes;
}

// Writes the positions of the boxes that are not apart from box, among the first count boxes in blocks, in increasing order.
// Returns their number. A NaN is not apart from anything.
template <class S>
[[gnu::always_inline]] inline int find_meeting(const BoxBlock<S>* blocks, int count, const Box<S>& box, int* out) {
  int found = 0;
  for (int first = 0; first < count; first += boxes_of_block)
    for (std::uint64_t lanes = first_bytes(meeting(blocks[first / boxes_of_block], box), count - first); lanes;
         lanes &= lanes - 1)
      out[found++] = first + std::countr_zero(lanes) / 8;
  return found;
}

}  // namespace refitlab
