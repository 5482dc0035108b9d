// SPDX-License-Identifier: MIT
// These kernels look for pairs of triangles of two clusters that were skinned in float.
//
// Triangles of each cluster are culled against the box that both have in common, those of one of them also against the box
// around what is left of the other. Those left are candidates, whose boxes are compared all with all, and pairs whose boxes meet
// are filtered (triangles_filter.hpp); those that this leaves open are filtered once more, by slopes. Floats are off by a slack; so
// a box that is compared is grown by it first. Nothing is culled or told apart that is not apart for certain, and a NaN never is.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/runtime/collide/box_block.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/lanes.hpp"
#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// The triangles of a cluster have their vertices by position in it. short_look_up_size(count) of vertex[i] can be read.
struct ClusterTriangles {
  int count;
  const std::uint16_t* vertex[3];
};

// CandidateArrays are the lists of Candidates as plain numbers, for kernels.
struct CandidateArrays {
  std::int32_t* triangle;
  std::uint8_t* outcodes;
  float* box[6];
  float* vertices[9];
};

// Candidates are the triangles of a cluster that are left. The lists have room for all triangles of the cluster, in whole
// packs, and that of triangles for one block more.
struct Candidates {
  std::vector<std::int32_t> triangle;     // in the cluster
  std::vector<std::uint8_t> outcodes;     // by position, while culling
  std::vector<Lanes<float>> box[6];       // low x, y, z, high x, y, z
  std::vector<Lanes<float>> vertices[9];  // x, y, z of the first vertex, then of the second and third one

  // Makes room for so many triangles and positions. Returns whether it had to, which moves the lists.
  bool reserve(int triangles, int positions);
  CandidateArrays arrays();
};

// A CandidatePair has a place of each of two lists of candidates.
inline constexpr int most_candidates = 1 << 15;  // of a list
using CandidatePair = std::int32_t;
constexpr CandidatePair pair_of(int first, int second) { return (first << 16) + second; }
constexpr int first_of(CandidatePair pair) { return pair >> 16; }
constexpr int second_of(CandidatePair pair) { return pair & 0xffff; }

// A TrianglePairBlock has sixteen pairs of triangles: x, y, z of the first vertex of each, then of the second and third one, and what
// they are off by at most.
struct TrianglePairBlock {
  Lanes<float> first[9], second[9], slack;
};

struct ClusterPairKernels {
  // Calls find_meeting.
  int (*overlaps)(const BoxBlock<float>* blocks, int count, const Box<float>& box, int* out);
  // Lists the triangles whose vertices are not all beyond one side of box. xyz has the x of all positions, then y, then z,
  // and room (whole blocks) for each. Returns their number. A pack behind them in the list repeats the last one.
  int (*cull)(const ClusterTriangles& triangles, const float* xyz, int room, const Box<float>& box, const CandidateArrays& out);
  // Fills the vertices, moved by offset, and the boxes of count candidates, listed as by cull. all becomes the box around them. One
  // block behind xyz can be read.
  void (*place)(const ClusterTriangles& triangles, const float* xyz, int room, const float* offset, int count,
                const CandidateArrays& out, Box<float>& all);
  // Keeps the candidates whose boxes are not apart from box. Returns their number.
  int (*keep)(int count, const Box<float>& box, const CandidateArrays& candidates);
  // Lists the pairs of candidates whose boxes are apart by no more than margin. The pairs are of all first ones and of the second
  // ones in [begin, end), where begin is a multiple of 16. Returns their number. The list has room for one block more than all
  // pairs, and a pack behind them repeats the last one.
  int (*meeting)(const CandidateArrays& a, int count_a, const CandidateArrays& b, int begin, int end, float margin,
                 CandidatePair* pairs);
  // Filters so many pairs of candidates, with a pack of any behind them, whose vertices are off by at most slack. Those that certainly
  // meet are written to meet, and unknown ones to unknown; each has room for all, and for one block more.
  void (*filter)(const CandidateArrays& a, int count_a, const CandidateArrays& b, int count_b, const CandidatePair* pairs,
                 int count, float slack, CandidatePair* meet, int& meet_count, CandidatePair* unknown, int& unknown_count);
  // Filters so many pairs by slopes.
  void (*filter_by_slopes)(const TrianglePairBlock* blocks, int count, Filtered* answers);
};

namespace baseline {
extern const ClusterPairKernels cluster_pair_kernels;
}
namespace avx2 {
extern const ClusterPairKernels cluster_pair_kernels;
}
namespace avx512 {
extern const ClusterPairKernels cluster_pair_kernels;
}

const ClusterPairKernels& cluster_pair_kernels(Target target);

}  // namespace refitlab
