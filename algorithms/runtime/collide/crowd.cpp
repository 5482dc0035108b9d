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

// BodyBounds are boxes around whole bodies. Some are coarse: their bodies' motion bounds are tighter.
struct BodyBounds {
  std::vector<Box<double>> boxes;
  std::vector<char> are_coarse;

  explicit BodyBounds(std::size_t count) : boxes(count), are_coarse(count) {}
};

// Returns the pairs of bodies whose bounds meet. motion_bound(i) returns the motion bound of one whose coarse bound meets another one.
template <class MotionBoundOf>
std::vector<std::pair<int, int>> meeting_bodies(BodyBounds& bounds, const Workers& workers, const MotionBoundOf& motion_bound) {
  auto pairs = meeting_boxes(bounds.boxes);
  std::vector<int> coarse;
  for (const auto& [a, b] : pairs)
    for (const int body : {a, b})
      if (bounds.are_coarse[body]) coarse.push_back(body), bounds.are_coarse[body] = false;
  if (coarse.empty()) return pairs;
  for_each(workers, coarse.size(), [&](std::size_t i) { bounds.boxes[coarse[i]] = motion_bound(coarse[i]); });
  std::erase_if(pairs, [&](const auto& pair) { return are_apart(bounds.boxes[pair.first], bounds.boxes[pair.second]); });
  return pairs;
}

// Queries pairs of bodies. Before each query it calls begin(i) for both of its bodies, on which no other thread works meanwhile.
template <class Begin>
std::vector<Contact> contacts_of(std::span<ClusterBody* const> bodies, const std::vector<std::pair<int, int>>& pairs, Query query,
                                 CrowdCounts& counts, const Workers& workers, const Begin& begin) {
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

// Returns the coarse bounds of some bodies. Bodies that met others when they were last asked for begin the frame, since they are
// likely to do so again.
BodyBounds coarse_bounds(CrowdFrame& frame, const Workers& workers) {
  const auto& bodies = frame.bodies;
  BodyBounds out(bodies.size());
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
        bool is_coarse;
        out.boxes[i] = bodies[i]->coarse_bound_of(frame.poses[i], frame.placements[i], *bound, is_coarse);
        out.are_coarse[i] = is_coarse;
      } else {
        frame.begin(i);
        bodies[i]->set_neighbours(false);
        out.boxes[i] = bodies[i]->coarse_bound();
        out.are_coarse[i] = bodies[i]->is_coarse_bound_made();
      }
    }
  });
  return out;
}

}  // namespace

std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts, const Workers& workers) {
  const DefaultFloatEnvironment environment;
  check(bodies);
  BodyBounds bounds(bodies.size());
  for_each(workers, bodies.size(), [&](std::size_t i) {
    bounds.boxes[i] = bodies[i]->coarse_bound();
    bounds.are_coarse[i] = bodies[i]->is_coarse_bound_made();
  });
  const auto pairs = meeting_bodies(bounds, workers, [&](int i) { return bodies[i]->motion_bound(); });
  return contacts_of(bodies, pairs, query, counts, workers, [](int) {});
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
  BodyBounds bounds = coarse_bounds(frame, workers);
  const auto pairs = meeting_bodies(bounds, workers, [&](int i) {
    if (!frame.has_begun[i]) bodies[i]->give_up_coarse_bound();
    frame.begin(i);
    return bodies[i]->motion_bound();
  });
  return contacts_of(bodies, pairs, query, counts, workers, [&](int i) {
    frame.begin(i);
    bodies[i]->set_neighbours(true);
  });
}

}  // namespace refitlab
