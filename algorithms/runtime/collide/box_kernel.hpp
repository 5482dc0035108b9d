// The kernels of ClusterBody: boxes around control points, and boxes against boxes.
#pragma once

#include <array>
#include <limits>

#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/triangle_group.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

// low x, y, z, high x, y, z.
using Box6 = std::array<double, 6>;
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr Box6 no_box{infinite, infinite, infinite, -infinite, -infinite, -infinite};

// Eight boxes in world space: low x, y, z, high x, y, z, by lane.
struct alignas(64) BoxBlock {
  double side[6][8];
};
inline void put_box(BoxBlock* blocks, int i, const Box6& box) {
  for (int k = 0; k < 6; ++k) blocks[i / 8].side[k][i % 8] = box[k];
}
inline Box6 get_box(const BoxBlock* blocks, int i) {
  Box6 box;
  for (int k = 0; k < 6; ++k) box[k] = blocks[i / 8].side[k][i % 8];
  return box;
}

// A vertex in the world, and an unused fourth.
struct alignas(32) Corner {
  double of[4];
};

// Two triangles of a pair of clusters.
struct CornerPair {
  std::array<std::uint16_t, 3> a, b;  // the places of their corners
  int first, second;                  // the triangles, of the models
};

struct BoxKernels {
  // Merges the boxes of the packs' pieces, of so many joints each, into boxes. slots, centers: of JointFloats;
  // rotation: 3 x 3, row by row.
  void (*bound)(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots,
                const float* centers, const float* rotation, FlippedBox* boxes);
  // The positions of those of the first count boxes in blocks that are not apart from box (low, high), in increasing
  // order; their number is returned. A NaN is not apart from anything.
  int (*overlaps)(const BoxBlock* blocks, int count, const double* box, int* out);
  // The pairs of boxes, one of each block, that are not apart: bit 8 i + j for box i of a and j of b.
  std::uint64_t (*overlapping_pairs)(const BoxBlock& a, int count_a, const BoxBlock& b, int count_b);
  // What filter_triangles says of each pair, to answers.
  void (*filter_pairs)(const Corner* corners_a, const Corner* corners_b, const CornerPair* pairs, int count,
                       Filtered* answers);
  // Places skinned vertices, block_count times their x, y, z; placement: a quaternion and a translation.
  void (*place)(const Lanes<double>* skinned, int block_count, const double* placement, Corner* out);
  // The boxes of groups, and of all of them (low, high), from the corners of their cluster.
  void (*box_groups)(const TriangleGroup* groups, int count, const Corner* corners, BoxBlock* out, double* all);
  // The boxes of a group's triangles.
  void (*box_triangles)(const TriangleGroup& group, const Corner* corners, BoxBlock& out);
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
