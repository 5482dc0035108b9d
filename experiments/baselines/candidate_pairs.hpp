// SPDX-License-Identifier: GPL-3.0-or-later
// CandidatePairs decides the pairs of triangles that a detector cannot tell apart by its volumes. It does so many at a time: in
// packs of floats, then in packs of doubles, and exactly where neither decides, as the library's own queries do.
#pragma once

#include <functional>

#include "algorithms/runtime/collide/cluster_pairs.hpp"
#include "algorithms/runtime/refit/frame_stamps.hpp"

namespace refitlab {

class CandidatePairs {
 public:
  // Returns a vertex of one of the two bodies, 0 or 1, in the world.
  using VertexInWorld = std::function<const PaddedVertex&(int side, int vertex)>;

  // mesh must outlive this.
  CandidatePairs(const SkinnedMesh& mesh, VertexInWorld vertex);

  // Begins a frame, whose vertices are seen from origin in floats.
  void begin(const Point3& origin);
  // Begins a query of the frame.
  void ask(Query query);
  // A yes/no query needs no more pairs once one touches.
  bool is_done() const { return query_ == Query::yes_no && !found_.empty(); }
  // Adds a pair of triangles, one of each body. A yes/no query decides a few at a time, so that it may end soon.
  void add(int first, int second);
  // Decides what is left, and returns the pairs that touch.
  std::vector<TrianglePair> found();
  // Returns how many pairs were added since this was made.
  long count() const { return count_; }

 private:
  static constexpr int few = Lanes<float>::count, many = 2 * few;

  struct Side {
    FrameStamps is_made;                 // by triangle
    std::vector<Lanes<float>> vertices;  // a record a triangle: its vertices' coordinates
    Candidates candidates;               // the triangles of the pairs that are open, a pair a lane
    CandidateArrays lists;               // its lists
  };

  void put(int side, int triangle);
  void make(int side, int triangle);
  void filter();

  const SkinnedMesh& mesh_;
  const VertexInWorld vertex_;
  const ClusterPairKernels& kernels_ = cluster_pair_kernels(best_target());
  Side sides_[2];
  Point3 origin_ = Point3::Zero();
  double largest_ = 0;  // of the coordinates in the records
  Query query_ = Query::full;
  std::vector<TrianglePair> open_;
  std::vector<CandidatePair> lanes_, meet_, unknown_;
  DoublePairs doubles_;
  std::vector<TrianglePair> found_;
  long count_ = 0;
};

}  // namespace refitlab
