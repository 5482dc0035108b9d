// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_bound_kernel.hpp"

#include "algorithms/runtime/collide/motion_bound_lanes.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

// Bounds grow with all packs. The fourth rows are those of the joints: minus the largest ||t||^2, and the largest | ||q||^2 - 1
// |. cosine and spread are the least c and the largest A.
struct Bounds {
  S low[4] = {S(infinity), S(infinity), S(infinity), S(0)};
  S high[4] = {S(-infinity), S(-infinity), S(-infinity), S(0)};
  S cosine{1}, spread{0};
};

// Turns all joints by the placement.
template <bool few>
void place(const Joints<few>& joints, const double* pose, const double* rotation, Bounds& bounds) {
  Transform placement;
  for (int i = 0; i < 4; ++i) placement.rotation[i] = S(static_cast<float>(rotation[i]));
  for (int first = 0; first < joints.count; first += width) {
    const Transform joint = joints_of_pose(pose, joints.count, first);
    bounds.low[3] = min_of(bounds.low[3], S(-squared_reach(joint)));
    bounds.high[3] = max_of(bounds.high[3], defect(joint));
    joints.put_lanes(first, compose(placement, joint));
  }
}

// Calls merge(box, is_unbounded, c, A) with the bounds of the lanes from first on. The box of an unbounded lane is empty, from
// infinity to minus infinity. off is the share of A that allows for errors; see error_share of motion_bound_kernel.hpp.
template <int slots, bool deviates, bool few, class Merge>
[[gnu::always_inline]] inline void bound_lanes(const MotionBoundPack& pack, int first, const Joints<few>& joints, float off,
                                               const Merge& merge) {
  const Point f = load_point(pack.center, first);
  Images images;
  Rotations<slots> rotations;
#pragma GCC unroll 8
  for (int k = 0; k < slots; ++k) {
    const Transform joint = joints.of_lanes(pack.joint[k] + first);
    const Point at = apply(joint, f);
    images.add(k, at);
    if constexpr (deviates) rotations.add(k, joint.rotation);
  }
  S radius = load(pack.radius + first), spread(0);
  const auto is_unbounded = rotations.are_far();
  if constexpr (deviates) {
    spread = images.spread(load(pack.joint_count + first)) + load(pack.unsolved + first);
    radius = radius + choose(is_unbounded, S(-infinity), (deviation_share(rotations.cosine()) + S(off)) * spread);
  }
  Box<S> box = images.box();
  box.grow(radius);
  merge(box, is_unbounded, rotations.cosine(), spread);
}

template <bool deviates, bool few>
void add_all(const Joints<few>& joints, const MotionBoundPack* packs, int pack_count, std::uint32_t* unbounded, Bounds& bounds) {
  for (int p = 0; p < pack_count; ++p) {
    unbounded[p] = 0;
    for (int first = 0; first < motion_bound_lanes && packs[p].slots_from(first) > 0; first += width) {
      const auto merge = [&](const Box<S>& box, const typename S::mask_type& is_unbounded, const S& cosine, const S& spread) {
        bounds.cosine = min_of(bounds.cosine, cosine), bounds.spread = max_of(bounds.spread, spread);
        for (int i = 0; i < 3; ++i) {
          bounds.low[i] = min_of(bounds.low[i], box.low[i]);
          bounds.high[i] = max_of(bounds.high[i], box.high[i]);
        }
        if (any_of(is_unbounded))
          for (int lane = 0; lane < width; ++lane)
            unbounded[p] |= static_cast<std::uint32_t>(is_unbounded[lane]) << (first + lane);
      };
      with_slots(
          packs[p].slots_from(first), [&](auto slots) __attribute__((always_inline)) {
            bound_lanes<slots(), deviates>(packs[p], first, joints, error_share(1e-6), merge);
          });
    }
  }
}

template <bool few>
void bound(const double* pose, const double* rotation, const MotionBoundPack* packs, int pack_count, bool deviates,
           const Joints<few>& joints, MotionBoundBox& out, std::uint32_t* unbounded) {
  Bounds bounds;
  place(joints, pose, rotation, bounds);
  if (deviates) add_all<true>(joints, packs, pack_count, unbounded, bounds);
  else add_all<false>(joints, packs, pack_count, unbounded, bounds);
  fold<true>(bounds.low, out.low);
  fold<false>(bounds.high, out.high);
  for (int lane = 0; lane < motion_bound_lanes; lane += width) {
    bounds.cosine.copy_to(out.cosine + lane, std::experimental::vector_aligned);
    bounds.spread.copy_to(out.spread + lane, std::experimental::vector_aligned);
  }
}

REFITLAB_KERNEL void bound_any(const double* pose, int joint_count, const double* rotation, const MotionBoundPack* packs,
                               int pack_count, bool deviates, float* numbers, int joint_stride, MotionBoundBox& out,
                               std::uint32_t* unbounded) {
  if (joint_stride == 32)
    bound<true>(pose, rotation, packs, pack_count, deviates, {numbers, joint_count, joint_stride}, out, unbounded);
  else bound<false>(pose, rotation, packs, pack_count, deviates, {numbers, joint_count, joint_stride}, out, unbounded);
}

}  // namespace

const MotionBoundKernels motion_bound_kernels{bound_any};

}  // namespace refitlab::REFITLAB_TARGET
