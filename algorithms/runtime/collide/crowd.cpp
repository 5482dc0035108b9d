// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/crowd.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

#include "algorithms/runtime/collide/meeting_boxes.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Throws std::invalid_argument unless all are there, and different.
void check(std::span<ClusterBody* const> bodies) {
  std::vector<std::pair<const ClusterBody*, std::size_t>> order;
  order.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i]) throw std::invalid_argument("collide_all: body " + std::to_string(i) + " is null");
    order.emplace_back(bodies[i], i);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 1; i < order.size(); ++i)
    if (order[i].first == order[i - 1].first)
      throw std::invalid_argument("collide_all: body " + std::to_string(order[i].second) + " is body " +
                                  std::to_string(order[i - 1].second) + " again");
}

}  // namespace

std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts, const Workers& workers) {
  const DefaultFloatEnvironment environment;
  check(bodies);
  std::vector<Box<double>> boxes(bodies.size());
  for_each(workers, bodies.size(), [&](std::size_t i) { boxes[i] = bodies[i]->motion_bound(); });
  const auto pairs = meeting_boxes(boxes);
  counts.pairs_of_boxes += static_cast<long>(pairs.size());

  for (const auto& [a, b] : pairs) bodies[a]->share(), bodies[b]->share();
  std::vector<Contact> found(pairs.size());
  std::vector<QueryCounts> tests(pairs.size());
  std::vector<std::mutex> in_work(bodies.size());
  for_each(workers, pairs.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    const std::scoped_lock both(in_work[a], in_work[b]);
    found[i] = {a, b, collide(*bodies[a], *bodies[b], query, tests[i])};
  });
  for (const QueryCounts& t : tests) counts.queries.ball_tests += t.ball_tests, counts.queries.triangle_tests += t.triangle_tests;
  std::erase_if(found, [](const Contact& c) { return c.pairs.empty(); });
  return found;
}

}  // namespace refitlab
