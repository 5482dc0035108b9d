// SPDX-License-Identifier: MIT
// This is the query for touching pairs among many bodies. It compares boxes first, and then looks into each pair whose boxes
// meet.
#pragma once

#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "algorithms/runtime/collide/workers.hpp"

namespace refitlab {

// A Contact is two bodies that touch, by position in the list. first < second.
struct Contact {
  int first, second;
  std::vector<TrianglePair> pairs;  // never empty; one for Query::yes_no
};

struct CrowdCounts {
  long pairs_of_boxes = 0;  // the pairs of bodies whose boxes meet
  QueryCounts queries;
};

// Returns the contacts among bodies that have begun the same frame, sorted by first and second. Nothing is remembered from
// frame to frame. Only one thread works on a body at a time, so more threads pay where bodies have few neighbours. Neither the
// contacts nor the sets of their pairs depend on the threads; the order of pairs, and which pair a yes/no query finds, do for
// bodies that collide() has compared in this frame before. If a task throws, the exception is thrown again once all tasks
// have ended. Throws std::invalid_argument for a body that is listed twice, and for a null pointer, and std::logic_error for a
// body that has begun no frame.
std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, Query query, CrowdCounts& counts,
                                 const Workers& workers = one_worker());

// Does the same from a pose and a placement of each body, by their places in the list. A body begins the frame if its bound meets that
// of another one, or did when this was last called. All others stay in the frame before, and cost little more than a box by
// PoseChange, or by MotionBound now and then. So this is the way for crowds of which many are far from each other. Throws the same,
// also what ClusterBody::begin throws, after which some of the bodies may have begun the frame, and std::invalid_argument if there are
// not as many poses or placements as bodies.
std::vector<Contact> collide_all(std::span<ClusterBody* const> bodies, std::span<const Pose> poses,
                                 std::span<const RigidTransform<double>> placements, Query query, CrowdCounts& counts,
                                 const Workers& workers = one_worker());

}  // namespace refitlab
