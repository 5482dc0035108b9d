// SPDX-License-Identifier: MIT
// PairMemory: what two bodies were to each other in earlier frames. Bodies move little from one frame to the next: of a
// few pairs of triangles that touched some pair often touches again, and bodies whose bounds met meet again.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/runtime/collide/collide.hpp"

namespace refitlab {

class PairMemory {
 public:
  static constexpr std::size_t most = 8;

  // Pairs that touched, the latest first.
  const std::vector<TrianglePair>& pairs() const { return pairs_; }

  // One of the pairs found in a frame; it moves to the front if it is known.
  void remember(const TrianglePair& pair) {
    std::erase(pairs_, pair);
    if (pairs_.size() == most) pairs_.pop_back();
    pairs_.insert(pairs_.begin(), pair);
  }
  // Of many pairs found in a frame, as many as there is room for, spread over them.
  void remember(const std::vector<TrianglePair>& pairs) {
    const std::size_t count = std::min(most, pairs.size());
    for (std::size_t i = 0; i < count; ++i) remember(pairs[i * pairs.size() / count]);
  }

  // Whether bounds of the two met when they were last compared.
  bool are_near = false;

 private:
  std::vector<TrianglePair> pairs_;
};

}  // namespace refitlab
