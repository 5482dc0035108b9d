// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which triangles touch, by testing all pairs of triangles whose vertices are all skinned beforehand.
#pragma once

#include "algorithms/runtime/collide/cluster_tree.hpp"
#include "algorithms/runtime/collide/collide.hpp"

namespace proptests::oracle {

// Holds a character in a pose and a place.
struct Posed {
  const refitlab::Character& character;
  const refitlab::Pose& pose;
  const refitlab::RigidTransform<double>& at;

  // Returns all of its vertices in the world.
  std::vector<refitlab::Point3> vertices(refitlab::Skinning skinning) const;
};

// Returns a query's pairs in increasing order.
std::vector<refitlab::TrianglePair> sorted(std::vector<refitlab::TrianglePair> pairs);

// Returns the pairs in increasing order, of triangles whose vertices are among the points.
using Triangles = std::vector<refitlab::Triangle>;
std::vector<refitlab::TrianglePair> all_pairs(const Triangles& a, const std::vector<refitlab::Point3>& p, const Triangles& b,
                                              const std::vector<refitlab::Point3>& q);
std::vector<refitlab::TrianglePair> all_pairs(const Posed& a, const Posed& b, refitlab::Skinning skinning);

// Says whether a cluster has a triangle of the model.
bool has_triangle(const refitlab::ClusterTree& tree, int cluster, int triangle);

}  // namespace proptests::oracle
