// SPDX-License-Identifier: MIT
// Which of many bodies touch, and where: boxes first, then each pair whose boxes meet.
#pragma once

#include <cstddef>

#include "algorithms/runtime/collide/cluster_collide.hpp"

namespace refitlab {

// Two bodies that touch, by position in the list, first < second.
struct Contact {
  int first, second;
  std::vector<TrianglePair> pairs;  // never empty; one for Query::yes_no
};

struct CrowdCounts {
  long pairs_of_boxes = 0;  // that meet
  QueryCounts queries;
};

// Who works on many bodies at once: for_each(self, count, task, data) calls task(data, i) once for each i < count, in any
// order and on any threads, and returns when all calls have. task throws nothing.
struct Workers {
  void (*for_each)(void* self, std::size_t count, void (*task)(void* data, std::size_t i), void* data);
  void* self = nullptr;
};
// The thread that calls, alone.
Workers one_worker();

// The contacts among bodies that have begun the same frame, by first and second. Nothing is remembered from frame to
// frame. A body in work keeps others from it, so more than one thread pays where bodies have few neighbours; the answer
// is the same. What a task throws is thrown once all have ended.
std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts,
                                 const Workers& workers = one_worker());

}  // namespace refitlab
