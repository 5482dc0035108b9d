// SPDX-License-Identifier: MIT
// The kernels of ClusterBody: boxes around control points, and boxes against boxes.
#pragma once

#include <array>

#include "algorithms/runtime/collide/box_block.hpp"
#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/triangle_group.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

// A vertex in the world, and an unused fourth.
struct alignas(32) Corner {
  double of[4];
};

// Two triangles of a pair of clusters.
struct TrianglePairCandidate {
  std::array<std::uint16_t, 3> a, b;  // the places of their corners
  int first, second;                  // the triangles, of the models
};

struct BoxKernels {
  // Merges the boxes of the packs' pieces, of so many joints each, into boxes. slots, centers: of JointFloats;
  // rotation: 3 x 3, row by row.
  void (*bound)(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots, const float* centers,
                const float* rotation, FlippedBox* boxes);
  // The positions of those of the first count boxes in blocks that are not apart from box, in increasing order; their
  // number is returned. A NaN is not apart from anything.
  int (*overlaps)(const BoxBlock<double>* blocks, int count, const Box<double>& box, int* out);
  // The pairs of boxes, one of each block, that are not apart: bit 8 i + j for box i of a and j of b.
  std::uint64_t (*overlapping_pairs)(const BoxBlock<double>& a, int count_a, const BoxBlock<double>& b, int count_b);
  // What filter_triangles says of each pair, to answers.
  void (*filter_pairs)(const Corner* corners_a, const Corner* corners_b, const TrianglePairCandidate* pairs, int count,
                       Filtered* answers);
  // Places skinned vertices, block_count times their x, y, z; placement: a quaternion and a translation.
  void (*place)(const Lanes<double>* skinned, int block_count, const double* placement, Corner* out);
  // The boxes of groups, and of all of them, from the corners of their cluster.
  void (*box_groups)(const TriangleGroup* groups, int count, const Corner* corners, BoxBlock<double>* out, Box<double>& all);
  // The boxes of a group's triangles.
  void (*box_triangles)(const TriangleGroup& group, const Corner* corners, BoxBlock<double>& out);
};

namespace baseline {
extern const BoxKernels box_kernels;
}
namespace avx2 {
extern const BoxKernels box_kernels;
}
namespace avx512 {
extern const BoxKernels box_kernels;
}

const BoxKernels& box_kernels(Target target);

}  // namespace refitlab
