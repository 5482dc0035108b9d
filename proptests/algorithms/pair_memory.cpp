// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/pair_memory.hpp"

#include "proptests/harness/harness.hpp"

namespace proptests::suite_pair_memory {
namespace {

using namespace refitlab;
using Pairs = std::vector<ClusterPair>;

// Returns the pairs (first, first + 100) and so on, as many as count says, in steps.
Pairs pairs_from(int first, int count, int step = 1) {
  Pairs out;
  for (int i = 0; i < count; ++i) out.push_back({first + i * step, first + i * step + 100});
  return out;
}

}  // namespace

PROPTEST(pair_memory) {
  t.example("the latest pairs are kept, the latest first, and the oldest is forgotten", {}, [] {
    PairMemory memory;
    bool ok = memory.pairs().empty();
    for (int i = 0; i < 20; ++i) {
      memory.remember(ClusterPair{i, i + 100});
      const int known = std::min(i + 1, static_cast<int>(PairMemory::most));
      ok = ok && memory.pairs() == pairs_from(i, known, -1);
    }
    return Checked(ok, 20);
  });
  t.example("a pair that is known moves to the front, and no other is forgotten for it", {}, [] {
    PairMemory memory;
    for (const ClusterPair& pair : pairs_from(0, PairMemory::most)) memory.remember(pair);
    memory.remember(ClusterPair{0, 100});  // This is the oldest pair.
    Pairs expected = pairs_from(PairMemory::most - 1, PairMemory::most - 1, -1);
    expected.insert(expected.begin(), {0, 100});
    return memory.pairs() == expected;
  });
  t.example("a remembered pair may be remembered again by what pairs() returns", {}, [] {
    bool ok = true;
    for (std::size_t k = 0; k < PairMemory::most; ++k) {
      PairMemory memory;
      for (const ClusterPair& pair : pairs_from(0, PairMemory::most)) memory.remember(pair);
      const ClusterPair again = memory.pairs()[k];
      memory.remember(memory.pairs()[k]);
      ok = ok && memory.pairs()[0] == again && memory.pairs().size() == PairMemory::most;
    }
    return Checked(ok, static_cast<long>(PairMemory::most));
  });
  t.example("of many pairs, as many as there is room for are kept, spread over all of them", {}, [] {
    bool ok = true;
    for (const int count : {0, 1, 3, 4, 5, 7, 80}) {
      PairMemory memory;
      memory.remember(pairs_from(0, count));
      const int kept = std::min(count, static_cast<int>(PairMemory::most));
      Pairs expected;
      for (int i = kept; i-- > 0;) expected.push_back({i * count / kept, i * count / kept + 100});
      ok = ok && memory.pairs() == expected;
    }
    return Checked(ok, 7);
  });
  t.example("bodies are skinned whole in 16, 32 and then 64 queries, for as long as the one after them does more work", {}, [] {
    PairMemory memory;
    std::string found;
    const auto count_whole = [&] {
      int count = 0;
      for (; memory.are_entangled() && count < 1000; ++count) memory.count_whole_query();
      found += std::to_string(count) + " ";
    };
    for (const long excess : {1L, 1000L, 5L, 1L, 1L, 0L, 1L, 1L, -7L, 3L}) memory.count_query(excess), count_whole();
    // The bodies are apart before all of them are through.
    memory.count_query(1), memory.count_query(0), count_whole();
    return Checked(found == "16 32 64 64 64 0 16 32 0 16 0 ", 11, found);
  });
}

}  // namespace proptests::suite_pair_memory
