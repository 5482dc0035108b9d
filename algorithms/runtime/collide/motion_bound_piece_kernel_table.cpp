// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_bound_piece_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

BoundMotionPieces bound_motion_pieces(Target target) { return REFITLAB_OF_TARGET(target, bound_motion_pieces); }

}  // namespace refitlab
