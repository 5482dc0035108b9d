// SPDX-License-Identifier: MIT
// ClusterPairs finds the pairs of triangles that touch in pairs of clusters. Floats decide what they can
// (cluster_pair_kernel.hpp), and the vertices in double decide the rest.
#pragma once

#include <utility>

#include "algorithms/runtime/collide/collide.hpp"
#include "algorithms/runtime/collide/skinned_clusters.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

// DoublePairs decides pairs of triangles on vertices in the world: in packs of doubles, and exactly what these leave unknown.
class DoublePairs {
 public:
  static constexpr std::size_t most = 1 << 12;

  bool is_full() const { return pairs_.size() >= most; }
  // Requires that it is not full.
  void add(const std::array<PaddedVertex, 3>& a, const std::array<PaddedVertex, 3>& b, TrianglePair pair);
  // Appends to found the pairs that touch, and forgets all.
  void decide(std::vector<TrianglePair>& found);
  void clear();

 private:
  std::vector<PaddedVertex> vertices_a_, vertices_b_;
  std::vector<TrianglePairCandidate> pairs_;
  std::vector<Filtered> answers_;
};

// ClusterPairScratch is working storage of one ClusterPairs at a time, which may be used again for any bodies.
struct ClusterPairScratch {
  struct Open {  // a pair that floats leave unknown: its vertices by position in their clusters, and triangles of the models
    int cluster_a, cluster_b;
    std::array<int, 3> a, b;
    TrianglePair pair;
  };
  // Makes room for candidates of any clusters of two trees.
  void reserve(const ClusterTree& first_tree, const ClusterTree& second_tree);
  CandidatePair* pairs() { return room_for_pairs_.data() + first_pair_; }
  // Appends a pair to open. Both candidates have their vertices, which are off by at most slack.
  void leave_open(const Open& pair, const CandidateArrays& of_first, int i, const CandidateArrays& of_second, int j, float slack);

  Candidates first, second;
  std::vector<CandidatePair> meet, unknown;
  std::vector<Open> open;
  std::vector<TrianglePairBlock> open_vertices;  // of these, in order
  std::vector<Filtered> answers;                 // likewise
  DoublePairs doubles;
  std::vector<int> near_blocks, near_clusters;
  std::vector<ClusterPair> near, touching;

 private:
  void place_pairs();

  std::vector<CandidatePair> room_for_pairs_;
  std::size_t first_pair_ = 0;
};

// While it lives, the thread has the default floating-point environment.
class ClusterPairs {
 public:
  // All of these must outlive this.
  ClusterPairs(SkinnedClusters& first, SkinnedClusters& second, Query query, QueryCounts& counts, ClusterPairScratch& scratch);

  // moved() returns a box of the second body as seen from the first one's origin, and moved_back() the other way round. The boxes
  // have four roundings of their coordinates to spare, of which this takes two.
  Box<float> moved(const Box<float>& of_second) const { return moved(of_second, 1); }
  Box<float> moved_back(const Box<float>& of_first) const { return moved(of_first, -1); }

  // Says whether both clusters are skinned already.
  bool are_skinned(int a, int b) const { return first_.is_skinned(a) && second_.is_skinned(b); }
  // Looks into a pair of clusters. Their pairs are found at once, or, in a full query, by decide().
  void add(int a, int b);
  // Looks into all clusters of two bodies that are skinned whole, first into those whose boxes reach deepest into each other, and
  // decides what it finds.
  void add_all();
  // Decides what is still open.
  void decide();

  // These are the pairs that were found. take_found() forgets them, and returns one at most to a yes/no query.
  const std::vector<TrianglePair>& found() const { return found_; }
  std::vector<TrianglePair> take_found() {
    if (query_ == Query::yes_no && found_.size() > 1) found_.resize(1);
    return std::exchange(found_, {});
  }
  Query query() const { return query_; }
  // Says whether a yes/no query has what it asks for. It looks no further in the clusters where it is found.
  bool is_done() const { return query_ == Query::yes_no && !found_.empty(); }
  // Returns the clusters in which triangles that touch were found. A pair of clusters may be listed twice.
  const std::vector<ClusterPair>& touching() const { return scratch_.touching; }

 private:
  Box<float> moved(const Box<float>& box, float sign) const {
    Box<float> out;
    for (int i = 0; i < 3; ++i)
      out.low[i] = box.low[i] + sign * offset_[i] - lost_, out.high[i] = box.high[i] + sign * offset_[i] + lost_;
    return out;
  }
  // A Side is a cluster of one of the bodies, with its candidates and the box around them, seen from the first body's origin.
  struct Side {
    SkinnedClusters& body;
    int cluster;
    bool is_second;
    const CandidateArrays& candidates;
    int count = 0;
    Box<float> all{};

    ClusterTriangles triangles() const { return body.tree().cluster_triangles(cluster); }
  };
  // Finds the triangles of a side that are not outside common, and the box around them, grown by margin. Returns whether there
  // are any.
  bool find_candidates(Side& side, const Box<float>& common, float margin);
  void list_near(int a);
  void filter(const Side& single, const Side& in_blocks, int count, float slack);
  void list_touching(ClusterPair pair);
  void decide_by_slopes();

  const DefaultFloatEnvironment environment_;
  SkinnedClusters &first_, &second_;
  const Query query_;
  QueryCounts& counts_;
  ClusterPairScratch& scratch_;
  CandidateArrays candidates_[2];
  const ClusterPairKernels& kernels_ = cluster_pair_kernels(best_target());
  float offset_[3], lost_;  // from the first origin to the second one, and four roundings of it
  std::vector<TrianglePair> found_;
};

}  // namespace refitlab
