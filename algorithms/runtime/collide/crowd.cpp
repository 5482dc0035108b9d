// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/crowd.hpp"

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "algorithms/runtime/collide/meeting_boxes.hpp"
#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr std::size_t bodies_at_once = 16;  // of a task that makes their motion bounds

// Throws std::invalid_argument unless all are there, and different.
void check(std::span<ClusterBody* const> bodies) {
  bool are_in_order = true;  // of their addresses, and then none is there twice
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i]) throw std::invalid_argument("collide_all: body " + std::to_string(i) + " is null");
    are_in_order = are_in_order && (i == 0 || std::less<>()(bodies[i - 1], bodies[i]));
  }
  if (are_in_order) return;
  std::vector<std::pair<const ClusterBody*, std::size_t>> order;
  order.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) order.emplace_back(bodies[i], i);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 1; i < order.size(); ++i)
    if (order[i].first == order[i - 1].first)
      throw std::invalid_argument("collide_all: body " + std::to_string(order[i].second) + " is body " +
                                  std::to_string(order[i - 1].second) + " again");
}

// Queries the pairs of bodies whose boxes meet. Before each query it calls begin(i) for both of its bodies, on which no other thread
// works meanwhile.
template <class Begin>
std::vector<Contact> contacts_of(std::span<ClusterBody* const> bodies, std::span<const Box<double>> boxes, Query query,
                                 CrowdCounts& counts, const Workers& workers, const Begin& begin) {
  const auto pairs = meeting_boxes(boxes);
  if (pairs.empty()) return {};
  counts.pairs_of_boxes += static_cast<long>(pairs.size());
  std::vector<Contact> found(pairs.size());
  std::vector<QueryCounts> tests(pairs.size());
  std::vector<std::mutex> in_work(bodies.size());
  for_each(workers, pairs.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    const std::scoped_lock both(in_work[a], in_work[b]);
    for (const int body : {a, b}) begin(body), bodies[body]->share();
    found[i] = {a, b, collide(*bodies[a], *bodies[b], query, tests[i])};
  });
  for (const QueryCounts& t : tests) counts.queries.ball_tests += t.ball_tests, counts.queries.triangle_tests += t.triangle_tests;
  std::erase_if(found, [](const Contact& c) { return c.pairs.empty(); });
  return found;
}

// CrowdFrame is what bodies are asked for in a frame, and which of them have begun it.
struct CrowdFrame {
  std::span<ClusterBody* const> bodies;
  std::span<const Pose> poses;
  std::span<const RigidTransform<double>> placements;
  std::vector<char> has_begun = std::vector<char>(bodies.size());

  void begin(std::size_t i) {
    if (!has_begun[i]) bodies[i]->begin(poses[i], placements[i]);
    has_begun[i] = true;
  }
};

// Returns the motion bounds of some bodies. Bodies that met others when they were last asked for begin the frame, since they are
// likely to do so again. The others need no data of their own.
std::vector<Box<double>> motion_bounds(CrowdFrame& frame, const Workers& workers) {
  const auto& bodies = frame.bodies;
  std::vector<Box<double>> out(bodies.size());
  for_each(workers, (bodies.size() + bodies_at_once - 1) / bodies_at_once, [&](std::size_t task) {
    const std::size_t begin = task * bodies_at_once, end = std::min(bodies.size(), begin + bodies_at_once);
    // Bodies are far from each other in memory, and so these are read all together.
    const WayOfSkinning* ways[bodies_at_once];
    for (std::size_t i = begin; i < end; ++i) ways[i - begin] = bodies[i]->has_neighbours() ? nullptr : &bodies[i]->way();
    // Neighbours in the list are often skinned in one way, and then take turns with one motion bound.
    const WayOfSkinning* last = nullptr;
    std::optional<MotionBound> bound;
    for (std::size_t i = begin; i < end; ++i) {
      if (const WayOfSkinning* const way = ways[i - begin]) {
        if (way != last) last = way, bound.emplace(way->motion_bound);
        check_placement(frame.placements[i], bodies[i]->tree().character().mesh.name, "the body's placement");
        out[i] = bound->checked_box(frame.poses[i], frame.placements[i]);
      } else {
        frame.begin(i);
        bodies[i]->set_neighbours(false);
        out[i] = bodies[i]->motion_bound();
      }
    }
  });
  return out;
}

}  // namespace

std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts, const Workers& workers) {
  const DefaultFloatEnvironment environment;
  check(bodies);
  std::vector<Box<double>> boxes(bodies.size());
  for_each(workers, bodies.size(), [&](std::size_t i) { boxes[i] = bodies[i]->motion_bound(); });
  return contacts_of(bodies, boxes, query, counts, workers, [](int) {});
}

std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, std::span<const Pose> poses,
                                 std::span<const RigidTransform<double>> placements, Query query, CrowdCounts& counts,
                                 const Workers& workers) {
  const DefaultFloatEnvironment environment;
  check(bodies);
  const auto require = [&](std::size_t count, const char* what) {
    if (count != bodies.size())
      throw std::invalid_argument("collide_all: " + std::to_string(bodies.size()) + " bodies, but " + std::to_string(count) +
                                  " " + what);
  };
  require(poses.size(), "poses"), require(placements.size(), "placements");
  CrowdFrame frame{bodies, poses, placements};
  const auto boxes = motion_bounds(frame, workers);
  return contacts_of(bodies, boxes, query, counts, workers, [&](int i) {
    frame.begin(i);
    bodies[i]->set_neighbours(true);
  });
}

}  // namespace refitlab
