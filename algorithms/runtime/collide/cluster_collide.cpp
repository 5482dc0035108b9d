// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_collide.hpp"

#include <stdexcept>

#include "algorithms/runtime/collide/cluster_traversal.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Looks into the clusters that touched in earlier frames, up to the first ones that do again, and says whether any do. A memory
// of other bodies may remember clusters that these do not have.
bool touch_again(ClusterPairs& clusters, const ClusterTree& first, const ClusterTree& second, PairMemory& memory) {
  const auto has = [](const ClusterTree& tree, int cluster) {
    return cluster >= 0 && static_cast<std::size_t>(cluster) < tree.clusters().size();
  };
  for (const ClusterPair& pair : memory.pairs()) {
    if (!has(first, pair.first) || !has(second, pair.second)) continue;
    clusters.add(pair.first, pair.second);
    if (!clusters.is_done()) continue;
    memory.remember(pair);
    return true;
  }
  return false;
}

// Returns how much more work was done for a body since begin than is worth while. Queries go through boxes besides. So where bounds
// spare less than a tenth of the work of skinning everything, it is faster to do that in some of the next frames, too, as measured. A
// body that other queries of the frame skinned whole says nothing.
long work_beyond_use(const ClusterBody& body) { return body.is_all_skinned() ? 0 : body.excess_work() + body.work_of_all() / 10; }

}  // namespace

std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts, PairMemory* memory) {
  const DefaultFloatEnvironment environment;
  if (&first == &second)
    throw std::invalid_argument("collide: " + first.tree().character().mesh.name + ": a body is not compared with itself");
  // Near bodies are told apart by their wide nodes, if at all.
  if (!memory || !memory->are_near) {
    ++counts.ball_tests;
    if (are_apart(first.coarse_bound(), second.coarse_bound()) || are_apart(first.motion_bound(), second.motion_bound())) {
      if (memory) memory->are_near = false, memory->count_query(0);
      return {};
    }
  }
  auto& scratch = first.query_scratch();
  ClusterPairs of_clusters(first.clusters(), second.clusters(), query, counts, scratch.pairs);
  if (memory && query == Query::yes_no && touch_again(of_clusters, first.tree(), second.tree(), *memory)) {
    memory->are_near = true;
    memory->count_query(0);
    first.expect(ClusterBody::Need::skin), second.expect(ClusterBody::Need::skin);  // they may touch again
    return of_clusters.take_found();
  }
  const bool are_in_float = first.is_skinned_in_float() && second.is_skinned_in_float();
  const bool is_whole = memory && memory->are_entangled() && are_in_float;
  if (is_whole) first.skin_all(), second.skin_all();
  if (first.is_all_skinned() && second.is_all_skinned()) of_clusters.add_all();
  else ClusterTraversal(first, second, of_clusters, counts, scratch.hits).run();
  std::vector<TrianglePair> pairs = of_clusters.take_found();
  if (memory) {
    memory->are_near = !are_apart(first.box(), of_clusters.moved(second.box()));
    memory->remember(of_clusters.touching());
    if (!memory->are_near) memory->count_query(0);
    else if (is_whole) memory->count_whole_query();
    else memory->count_query(are_in_float ? work_beyond_use(first) + work_beyond_use(second) : 0);
    const auto need = memory->are_entangled() || (query == Query::yes_no && !pairs.empty()) ? ClusterBody::Need::skin
                      : memory->are_near                                                    ? ClusterBody::Need::nodes
                                                                                            : ClusterBody::Need::bound;
    first.expect(need), second.expect(need);
  }
  return pairs;
}

}  // namespace refitlab
