// SPDX-License-Identifier: MIT
// PairMemory: the state of two bodies in earlier frames. Bodies move little from one frame to the next. If a few pairs of
// triangles touched, some of them often touch again, and bodies whose bounds met meet again.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/runtime/collide/collide.hpp"

namespace refitlab {

class PairMemory {
 public:
  static constexpr std::size_t most = 8;

  // The pairs that touched, the latest first.
  const std::vector<TrianglePair>& pairs() const { return pairs_; }

  // Adds one of the pairs found in a frame. If it is known, it moves to the front.
  void remember(const TrianglePair& pair) {
    std::erase(pairs_, pair);
    if (pairs_.size() == most) pairs_.pop_back();
    pairs_.insert(pairs_.begin(), pair);
  }
  // Adds as many of the pairs found in a frame as there is room for, spread over all of them.
  void remember(const std::vector<TrianglePair>& pairs) {
    const std::size_t count = std::min(most, pairs.size());
    for (std::size_t i = 0; i < count; ++i) remember(pairs[i * pairs.size() / count]);
  }

  // Whether the bounds of the two bodies met when they were last compared.
  bool are_near = false;
  // Whether the last full query reached most of their clusters. Then bounding them costs more than it saves.
  bool are_entangled = false;

 private:
  std::vector<TrianglePair> pairs_;
};

}  // namespace refitlab
