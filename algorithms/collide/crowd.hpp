// Which of many bodies touch, and where: boxes first, then each pair whose boxes meet.
#pragma once

#include "algorithms/collide/cluster_collide.hpp"

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

// The contacts among bodies that have begun the same frame, by first and second. Nothing is remembered from frame to
// frame. A body in work keeps others from it, so more than one thread pays where bodies have few neighbours; the answer
// is the same. Throws std::invalid_argument if threads is less than 1, or more than 1 where refitlab was built without
// TBB.
std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts,
                                 int threads = 1);

// Whether refitlab was built with TBB.
bool has_threads();

}  // namespace refitlab
