// PairMemory: pairs of triangles of two bodies that touched in earlier frames. Bodies in contact move little from one
// frame to the next, and some pair of a few often touches again.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/collide/collide.hpp"

namespace refitlab {

class PairMemory {
 public:
  static constexpr std::size_t most = 8;

  // The latest first.
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

 private:
  std::vector<TrianglePair> pairs_;
};

}  // namespace refitlab
