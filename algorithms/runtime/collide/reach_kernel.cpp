#include "algorithms/runtime/collide/reach_kernel.hpp"

#include <cstring>

#include "algorithms/runtime/collide/reach_lanes.hpp"
#include "algorithms/runtime/packs/four.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

// What grows with all packs. The fourth rows are the joints': - the largest ||t||^2, and the largest | ||q||^2 - 1 |.
struct Bounds {
  S low[4] = {S(infinity), S(infinity), S(infinity), S(0)};
  S high[4] = {S(-infinity), S(-infinity), S(-infinity), S(0)};
};

// Turns all joints by the placement.
template <bool few>
void place(const Joints<few>& joints, const double* rotation, Bounds& bounds) {
  Transform placement;
  for (int i = 0; i < 4; ++i) placement.rotation[i] = S(static_cast<float>(rotation[i]));
  for (int first = 0; first < joints.count; first += width) {
    const Transform joint = joints.lanes(first);
    const S off = abs(squared_norm(joint.rotation) - S(1)), squared = squared_norm(joint.translation);
    bounds.low[3] = smaller(bounds.low[3], choose(squared < S(1e30f), S(-squared), S(-infinity)));
    bounds.high[3] = larger(bounds.high[3], choose(off <= S(1), off, S(1)));
    joints.put_lanes(first, compose(placement, joint));
  }
}

// The lanes from first on: their bounds, and which of them are unbounded, to merge(low, high, is_unbounded). An
// unbounded one is empty, from infinity to minus infinity. off: the share of A for what is off, see reach_kernel.hpp.
template <int slots, bool strays, bool few, class Merge>
[[gnu::always_inline]] inline void bound_lanes(const ReachPack& pack, int first, const Joints<few>& joints, float off,
                                               const Merge& merge) {
  const Point f = load_point(pack.center, first);
  Images images;
  Rotations<slots> rotations;
#pragma GCC unroll 8
  for (int k = 0; k < slots; ++k) {
    const Transform joint = joints.of_lanes(pack.joint[k] + first);
    const Point at = apply(joint, f);
    images.add(k, at, at, at);
    if constexpr (strays) rotations.add(k, joint.rotation);
  }
  S reach = load(pack.radius + first);
  const auto is_unbounded = rotations.are_far();
  if constexpr (strays) {
    const S a = images.spread(load(pack.joint_count + first)) + load(pack.unsolved + first);
    reach = reach + choose(is_unbounded, S(-infinity), (stray_share(rotations.cosine()) + S(off)) * a);
  }
  Point low, high;
  for (int i = 0; i < 3; ++i) low[i] = images.low()[i] - reach, high[i] = images.high()[i] + reach;
  merge(low, high, is_unbounded);
}

template <bool strays, bool few>
void add_all(const Joints<few>& joints, const ReachPack* packs, int pack_count, std::uint32_t* unbounded,
             Bounds& bounds) {
  for (int p = 0; p < pack_count; ++p) {
    unbounded[p] = 0;
    for (int first = 0; first < reach_lanes; first += width) {
      const auto merge = [&](const Point& low, const Point& high, const typename S::mask_type& is_unbounded) {
        for (int i = 0; i < 3; ++i) {
          bounds.low[i] = smaller(bounds.low[i], low[i]);
          bounds.high[i] = larger(bounds.high[i], high[i]);
        }
        if (any_of(is_unbounded))
          for (int lane = 0; lane < width; ++lane)
            unbounded[p] |= static_cast<std::uint32_t>(is_unbounded[lane]) << (first + lane);
      };
      if (packs[p].slot_count <= 4) bound_lanes<4, strays>(packs[p], first, joints, off_of_reach(1e-6), merge);
      else bound_lanes<most_reach_joints, strays>(packs[p], first, joints, off_of_reach(1e-6), merge);
    }
  }
}

// The least of each row's lanes, or the greatest.
template <bool least>
void fold(const S (&rows)[4], float* out) {
  Four folded[4];
  for (int i = 0; i < 4; ++i) {
    alignas(64) float lanes[width];
    rows[i].copy_to(lanes, std::experimental::vector_aligned);
    std::memcpy(&folded[i], lanes, sizeof(Four));
    for (int lane = 4; lane < width; lane += 4) {
      Four next;
      std::memcpy(&next, lanes + lane, sizeof(Four));
      folded[i] = (least ? next < folded[i] : next > folded[i]) ? next : folded[i];
    }
  }
  transpose(folded);
  for (int i = 1; i < 4; ++i)
    folded[0] = (least ? folded[i] < folded[0] : folded[i] > folded[0]) ? folded[i] : folded[0];
  std::memcpy(out, &folded[0], sizeof(Four));
}

template <bool few>
void bound(const double* posture, const double* rotation, const ReachPack* packs, int pack_count, bool strays,
           const Joints<few>& joints, ReachBounds& out, std::uint32_t* unbounded) {
  joints.read(posture);
  Bounds bounds;
  place(joints, rotation, bounds);
  if (strays) add_all<true>(joints, packs, pack_count, unbounded, bounds);
  else add_all<false>(joints, packs, pack_count, unbounded, bounds);
  fold<true>(bounds.low, out.low);
  fold<false>(bounds.high, out.high);
}

REFITLAB_KERNEL void bound_any(const double* posture, int joint_count, const double* rotation, const ReachPack* packs,
                               int pack_count, bool strays, float* numbers, int joint_room, ReachBounds& out,
                               std::uint32_t* unbounded) {
  if (joint_room == 32)
    bound<true>(posture, rotation, packs, pack_count, strays, {numbers, joint_count, joint_room}, out, unbounded);
  else bound<false>(posture, rotation, packs, pack_count, strays, {numbers, joint_count, joint_room}, out, unbounded);
}

}  // namespace

const ReachKernels reach_kernels{bound_any};

}  // namespace refitlab::REFITLAB_TARGET
