// The kernel that bounds nodes from their joints alone: as that of Reach, but by target.
#pragma once

#include "algorithms/collide/flipped_box.hpp"
#include "algorithms/collide/reach_kernel.hpp"

namespace refitlab {

// Merges the bounds of pieces into boxes[target], turned by the placement, not moved. numbers: as ReachKernels::bound
// left them for this posture and placement; off: off_of_reach. False if nothing is known of some lane.
using BoundReachPieces = bool (*)(float* numbers, int joint_count, int joint_room, const ReachPack* packs,
                                  int pack_count, bool strays, float off, FlippedBox* boxes);

namespace baseline {
extern const BoundReachPieces bound_reach_pieces;
}
namespace avx2 {
extern const BoundReachPieces bound_reach_pieces;
}
namespace avx512 {
extern const BoundReachPieces bound_reach_pieces;
}

BoundReachPieces bound_reach_pieces(Target target);

}  // namespace refitlab
