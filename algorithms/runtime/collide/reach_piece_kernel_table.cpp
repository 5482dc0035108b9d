#include "algorithms/runtime/collide/reach_piece_kernel.hpp"
#include "algorithms/runtime/packs/kernel_table.hpp"

namespace refitlab {

BoundReachPieces bound_reach_pieces(Target target) { return REFITLAB_OF_TARGET(target, bound_reach_pieces); }

}  // namespace refitlab
