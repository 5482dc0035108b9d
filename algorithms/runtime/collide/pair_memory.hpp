// SPDX-License-Identifier: MIT
// PairMemory remembers two bodies from earlier frames. Bodies move little from one frame to the next. Clusters that touched often
// touch again, and bodies whose bounds met meet again.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/runtime/collide/cluster_tree.hpp"

namespace refitlab {

class PairMemory {
 public:
  static constexpr std::size_t most = 4;

  // Returns the clusters that touched. The latest pair comes first.
  const std::vector<ClusterPair>& pairs() const { return pairs_; }

  // Adds a pair that was found in a frame. If it is known, it moves to the front. It may be one of pairs().
  void remember(ClusterPair pair) {
    std::erase(pairs_, pair);
    if (pairs_.size() == most) pairs_.pop_back();
    pairs_.insert(pairs_.begin(), pair);
  }
  // Adds some of the pairs found in a frame, spread over all of them: at most as many as there is room for.
  void remember(const std::vector<ClusterPair>& pairs) {
    const std::size_t count = std::min(most, pairs.size());
    for (std::size_t i = 0; i < count; ++i) remember(pairs[i * pairs.size() / count]);
  }

  // This says whether the bounds of the two bodies met when they were last compared.
  bool are_near = false;
  // Returns whether the next query skins both bodies whole.
  bool are_entangled() const { return whole_queries_ > 0; }
  // These remember that a query skinned both bodies whole, or else how much more work it did than is worth while. If it did more,
  // some of the next queries skin them whole, and then one bounds them again. Each time, more queries skin them whole.
  void count_whole_query() { --whole_queries_; }
  void count_query(long excess_work) {
    whole_queries_ = excess_work > 0 ? next_whole_queries_ : 0;
    next_whole_queries_ = excess_work > 0 ? std::min(2 * next_whole_queries_, most_whole_queries) : least_whole_queries;
  }

 private:
  static constexpr int least_whole_queries = 16, most_whole_queries = 64;
  int whole_queries_ = 0, next_whole_queries_ = least_whole_queries;
  std::vector<ClusterPair> pairs_;
};

}  // namespace refitlab
