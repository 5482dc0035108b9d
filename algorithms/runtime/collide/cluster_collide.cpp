// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_collide.hpp"

#include <optional>

#include "algorithms/runtime/collide/cluster_traversal.hpp"
#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// The first of the remembered pairs that still touches.
std::optional<TrianglePair> still_touching(ClusterBody& first, ClusterBody& second, const PairMemory& memory,
                                           QueryCounts& counts) {
  for (const TrianglePair& pair : memory.pairs()) {
    ++counts.triangle_tests;
    if (triangles_meet(first.triangle(pair.first), second.triangle(pair.second))) return pair;
  }
  return {};
}

// Two fifths of the clusters: about there skinning all of them costs as much as bounding them and skinning those.
bool are_entangled(ClusterBody& first, ClusterBody& second) {
  const auto count = [](ClusterBody& body) { return static_cast<long>(body.tree().clusters().size()); };
  return 5 * (first.clusters().clusters_reached() + second.clusters().clusters_reached()) > 2 * (count(first) + count(second));
}

}  // namespace

std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts, PairMemory* memory) {
  const DefaultFloatEnvironment environment;
  if (memory && query == Query::yes_no)
    if (const auto pair = still_touching(first, second, *memory, counts)) {
      memory->remember(*pair);
      return {*pair};
    }
  if (!memory || !memory->are_near) {  // near bodies are told apart by their wide nodes, if at all
    ++counts.ball_tests;
    if (are_apart(first.motion_bound(), second.motion_bound())) {
      if (memory) memory->are_entangled = false;
      return {};
    }
  }
  if (memory && memory->are_entangled && query == Query::full) first.skin_all(), second.skin_all();
  auto& scratch = first.query_scratch();
  ClusterPairs of_clusters(first.clusters(), second.clusters(), counts, scratch.pairs);
  auto pairs = ClusterTraversal(first, second, of_clusters, query, counts, scratch.hits).run();
  if (memory) {
    memory->are_near = !are_apart(first.wide_node_box(0), of_clusters.moved(second.wide_node_box(0)));
    memory->remember(pairs);
    if (query == Query::full) memory->are_entangled = are_entangled(first, second);
  }
  if (query == Query::yes_no && pairs.size() > 1) pairs.resize(1);
  return pairs;
}

}  // namespace refitlab
