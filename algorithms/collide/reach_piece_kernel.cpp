#include "algorithms/collide/reach_piece_kernel.hpp"

#include "algorithms/collide/reach_lanes.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

// False if nothing is known of some lane.
template <bool strays, bool few>
bool merge_all(const Joints<few>& joints, const ReachPack* packs, int pack_count, float off, FlippedBox* boxes) {
  for (const ReachPack* pack = packs; pack != packs + pack_count; ++pack)
    for (int first = 0; first < reach_lanes; first += width) {
      bool is_bounded = true;
      const auto merge = [&](const Point& low, const Point& high, const typename S::mask_type& is_unbounded) {
        alignas(64) float sides[8][width] = {};
        for (int i = 0; i < 3; ++i) {
          low[i].copy_to(sides[i], std::experimental::vector_aligned);
          S(-high[i]).copy_to(sides[4 + i], std::experimental::vector_aligned);
        }
        merge_lanes(sides, pack->target + first, boxes);
        is_bounded = none_of(is_unbounded);
      };
      if (pack->slot_count <= 2) bound_lanes<2, strays>(*pack, first, joints, off, merge);
      else if (pack->slot_count <= 4) bound_lanes<4, strays>(*pack, first, joints, off, merge);
      else bound_lanes<most_reach_joints, strays>(*pack, first, joints, off, merge);
      if (!is_bounded) return false;
    }
  return true;
}

template <bool few>
bool merge(const Joints<few>& joints, const ReachPack* packs, int pack_count, bool strays, float off,
           FlippedBox* boxes) {
  return strays ? merge_all<true>(joints, packs, pack_count, off, boxes)
                : merge_all<false>(joints, packs, pack_count, off, boxes);
}

REFITLAB_KERNEL bool bound_pieces(float* numbers, int joint_count, int joint_room, const ReachPack* packs,
                                  int pack_count, bool strays, float off, FlippedBox* boxes) {
  if (joint_room == 32) return merge<true>({numbers, joint_count, joint_room}, packs, pack_count, strays, off, boxes);
  return merge<false>({numbers, joint_count, joint_room}, packs, pack_count, strays, off, boxes);
}

}  // namespace

const BoundReachPieces bound_reach_pieces = bound_pieces;

}  // namespace refitlab::REFITLAB_TARGET
