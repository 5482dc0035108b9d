// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_collide.hpp"

#include <optional>
#include <stdexcept>

#include "algorithms/runtime/collide/cluster_traversal.hpp"
#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns the first of the remembered pairs that still touches. A memory of other bodies may remember triangles that these do not have.
std::optional<TrianglePair> still_touching(ClusterBody& first, ClusterBody& second, const PairMemory& memory,
                                           QueryCounts& counts) {
  const auto has = [](const ClusterBody& body, int triangle) {
    return triangle >= 0 && static_cast<std::size_t>(triangle) < body.tree().character().mesh.triangles.size();
  };
  for (const TrianglePair& pair : memory.pairs()) {
    if (!has(first, pair.first) || !has(second, pair.second)) continue;
    ++counts.triangle_tests;
    if (triangles_meet(first.triangle(pair.first), second.triangle(pair.second))) return pair;
  }
  return {};
}

}  // namespace

std::vector<TrianglePair> collide(ClusterBody& first, ClusterBody& second, Query query, QueryCounts& counts, PairMemory* memory) {
  const DefaultFloatEnvironment environment;
  if (&first == &second)
    throw std::invalid_argument("collide: " + first.tree().character().mesh.name + ": a body is not compared with itself");
  if (memory && query == Query::yes_no)
    if (const auto pair = still_touching(first, second, *memory, counts)) {
      memory->remember(*pair);
      memory->are_near = true;
      return {*pair};
    }
  // Near bodies are told apart by their wide nodes, if at all.
  if (!memory || !memory->are_near) {
    ++counts.ball_tests;
    if (are_apart(first.motion_bound(), second.motion_bound())) {
      if (memory) memory->are_near = false, memory->count_query(0);
      return {};
    }
  }
  const bool are_in_float = first.is_skinned_in_float() && second.is_skinned_in_float();
  const bool is_whole = memory && memory->are_entangled() && are_in_float;
  if (is_whole) first.skin_all(), second.skin_all();
  auto& scratch = first.query_scratch();
  ClusterPairs of_clusters(first.clusters(), second.clusters(), counts, scratch.pairs);
  auto pairs = ClusterTraversal(first, second, of_clusters, query, counts, scratch.hits).run();
  if (memory) {
    memory->are_near = !are_apart(first.wide_node_box(0), of_clusters.moved(second.wide_node_box(0)));
    memory->remember(pairs);
    if (!memory->are_near) memory->count_query(0);
    else if (is_whole) memory->count_whole_query();
    else memory->count_query(are_in_float ? first.excess_work() + second.excess_work() : 0);
    first.expect_whole(memory->are_entangled()), second.expect_whole(memory->are_entangled());
  }
  if (query == Query::yes_no && pairs.size() > 1) pairs.resize(1);
  return pairs;
}

}  // namespace refitlab
