// The kernels of ClusterBody: boxes around control points, and boxes against boxes.
#pragma once

#include "algorithms/collide/box_packs.hpp"
#include "algorithms/packs/targets.hpp"

namespace refitlab {

// Eight boxes in world space: low x, y, z, high x, y, z, by lane. Lanes without a box have low = inf, high = -inf.
struct alignas(64) BoxBlock {
  double side[6][8];
};

struct BoxKernels {
  // Merges the boxes of the packs' pieces, of so many joints each, into boxes. slots, centers: of JointFloats; rotation: 3 x 3,
  // row by row.
  void (*bound)(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots,
                const float* centers, const float* rotation, FlippedBox* boxes);
  // The positions of those of the first count boxes in blocks that are not apart from box (low, high), in increasing order;
  // their number is returned. A NaN is not apart from anything.
  int (*overlaps)(const BoxBlock* blocks, int count, const double* box, int* out);
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
