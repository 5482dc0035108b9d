// SPDX-License-Identifier: MIT
// These are the kernels of ClusterBody in double, and those that make boxes around control points.
#pragma once

#include <array>

#include "algorithms/runtime/batch/float_palette.hpp"
#include "algorithms/runtime/collide/box_block.hpp"
#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/lanes.hpp"

namespace refitlab {

// Boxes in float have four roundings of their coordinates to spare, each of 2^-24. Growing them rounds, too, and so does a
// conversion to float.
inline constexpr double roundings_of_float_box = 0x1p-21;

// Returns by how much boxes in float grow whose coordinates may be off by lost, and are at most largest.
[[gnu::always_inline]] inline float growth_of_float_box(double lost, double largest) {
  return static_cast<float>(lost + roundings_of_float_box * largest + least_float_slack);
}

// A PaddedVertex is a vertex in the world with an unused fourth number.
struct alignas(32) PaddedVertex {
  double of[4];
};

// A candidate is a pair of triangles of two clusters.
struct TrianglePairCandidate {
  std::array<std::uint16_t, 3> a, b;  // the positions of their vertices in the cluster
  int first, second;                  // the indices of the triangles in the models
};

struct BoxKernels {
  // Merges the boxes of the packs' pieces, which have so many joints each, into boxes. slots and centers are those of
  // JointFloats. rotation is a 3 x 3 matrix, row by row.
  void (*bound)(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots, const float* centers,
                const float* rotation, FlippedBox* boxes);
  // Puts boxes into blocks, each grown by growth_of_float_box of lost and the largest coordinate of all. whole becomes the box
  // around them. Returns false, and nothing else, if a coordinate or what they grow by is undefined or not below largest_box.
  bool (*put_grown)(const FlippedBox* boxes, int count, double lost, BoxBlock<float>* blocks, Box<float>& whole);
  // Writes the result of filter_triangles for each pair to answers.
  void (*filter_pairs)(const PaddedVertex* vertices_a, const PaddedVertex* vertices_b, const TrianglePairCandidate* pairs,
                       int count, Filtered* answers);
  // Places skinned vertices, block_count times their x, y, z. placement is a quaternion and a translation.
  void (*place)(const Lanes<double>* skinned, int block_count, const double* placement, PaddedVertex* out);
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
