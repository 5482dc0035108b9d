// SPDX-License-Identifier: MIT
// The kernels of ClusterBody. They make boxes around control points, and compare boxes with boxes.
#pragma once

#include <array>

#include "algorithms/runtime/collide/box_block.hpp"
#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/triangle_group.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

// A vertex in the world, and an unused fourth number.
struct alignas(32) PaddedVertex {
  double of[4];
};

// A pair of triangles of two clusters.
struct TrianglePairCandidate {
  std::array<std::uint16_t, 3> a, b;  // the positions of their corners in the cluster
  int first, second;                  // the indices of the triangles in the models
};

struct BoxKernels {
  // Merges the boxes of the packs' pieces, which have so many joints each, into boxes. slots and centers are those of
  // JointFloats. rotation is a 3 x 3 matrix, row by row.
  void (*bound)(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots, const float* centers,
                const float* rotation, FlippedBox* boxes);
  // Writes the positions of the boxes that are not apart from box, among the first count boxes in blocks, in increasing
  // order. Returns their number. A NaN is not apart from anything.
  int (*overlaps)(const BoxBlock<double>* blocks, int count, const Box<double>& box, int* out);
  // Returns the pairs of boxes, one of each block, that are not apart: bit 8 i + j for box i of a and j of b.
  std::uint64_t (*overlapping_pairs)(const BoxBlock<double>& a, int count_a, const BoxBlock<double>& b, int count_b);
  // Writes the result of filter_triangles for each pair to answers.
  void (*filter_pairs)(const PaddedVertex* corners_a, const PaddedVertex* corners_b, const TrianglePairCandidate* pairs,
                       int count, Filtered* answers);
  // Places skinned vertices, block_count times their x, y, z. placement is a quaternion and a translation.
  void (*place)(const Lanes<double>* skinned, int block_count, const double* placement, PaddedVertex* out);
  // Makes the boxes of groups, and the box of all of them, from the corners of their cluster.
  void (*box_groups)(const TriangleGroup* groups, int count, const PaddedVertex* corners, BoxBlock<double>* out,
                     Box<double>& all);
  // Makes the boxes of a group's triangles.
  void (*box_triangles)(const TriangleGroup& group, const PaddedVertex* corners, BoxBlock<double>& out);
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
