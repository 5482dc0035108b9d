#include "algorithms/collide/crowd.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>
#ifdef REFITLAB_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif
#endif

#include "algorithms/packs/float_environment.hpp"

namespace refitlab {
namespace {

// The pairs of boxes that meet, each with the smaller index first, in increasing order [Zomorodian and Edelsbrunner
// 2000].
std::vector<std::pair<int, int>> meeting(const std::vector<Box6>& boxes) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  std::vector<Box> list;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    list.emplace_back(CGAL::Bbox_3(boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3], boxes[i][4], boxes[i][5]),
                      static_cast<int>(i));
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_self_intersection_d(list.begin(), list.end(),
                                [&](const Box& a, const Box& b) { pairs.push_back(std::minmax(a.info(), b.info())); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void for_each(std::size_t count, [[maybe_unused]] int threads, const auto& body) {
#ifdef REFITLAB_TBB
  if (threads > 1) {
#ifdef __SANITIZE_THREAD__
    // ThreadSanitizer does not see how a TBB that it did not instrument begins its tasks and waits for them.
    static char begun, done;
    const auto task = [&](std::size_t i) { __tsan_acquire(&begun), body(i), __tsan_release(&done); };
    __tsan_release(&begun);
    tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::size_t(0), count, task); });
    __tsan_acquire(&done);
#else
    tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::size_t(0), count, body); });
#endif
    return;
  }
#endif
  for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace

bool has_threads() {
#ifdef REFITLAB_TBB
  return true;
#else
  return false;
#endif
}

std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts, int threads) {
  const DefaultFloatEnvironment environment;
  if (threads < 1 || (threads > 1 && !has_threads()))
    throw std::invalid_argument("collide_all: " + std::to_string(threads) + " threads" +
                                (threads < 1 ? "" : ", but refitlab was built without TBB"));
  std::vector<Box6> boxes(bodies.size());
  for_each(bodies.size(), threads, [&](std::size_t i) { boxes[i] = bodies[i]->reach(); });
  const auto pairs = meeting(boxes);
  counts.pairs_of_boxes += static_cast<long>(pairs.size());

  std::vector<Contact> found(pairs.size());
  std::vector<QueryCounts> tests(pairs.size());
  std::vector<std::mutex> in_work(bodies.size());
  for_each(pairs.size(), threads, [&](std::size_t i) {
    const auto [a, b] = pairs[i];
    const std::scoped_lock both(in_work[a], in_work[b]);
    found[i] = {a, b, collide(*bodies[a], *bodies[b], query, tests[i])};
  });
  for (const QueryCounts& t : tests)
    counts.queries.ball_tests += t.ball_tests, counts.queries.triangle_tests += t.triangle_tests;
  std::erase_if(found, [](const Contact& c) { return c.pairs.empty(); });
  return found;
}

}  // namespace refitlab
