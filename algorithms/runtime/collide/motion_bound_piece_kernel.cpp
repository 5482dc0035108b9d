// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_bound_piece_kernel.hpp"

#include "algorithms/runtime/collide/motion_bound_lanes.hpp"
#include "lemmas/a1_affine_image.hpp"
#include "lemmas/b7_motion_bound.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

// Calls merge(box) with the common part of a ball's and a box's bounds, for the lanes from first on. Returns whether all are
// known.
template <int slots, bool deviates, bool few, class Merge>
[[gnu::always_inline]] inline bool bound_lanes(const MotionBoundPiecePack& pack, int first, const Joints<few>& joints, float off,
                                               const Merge& merge) {
  const Point f = load_point(pack.ball.center, first), middle = load_point(pack.box_center, first),
              half = load_point(pack.half, first);
  Images images;
  Point at_least = Point::Constant(S(0));  // the sum of the least weights times the images of f
  Box<S> box, box_at_least{at_least, at_least};
  Rotations<slots> rotations;
#pragma GCC unroll 8
  for (int k = 0; k < slots; ++k) {
    const Transform joint = joints.of_lanes(pack.ball.joint[k] + first);
    const std::array<Point, 3> turn = rotation_rows(joint.rotation);
    Point at_f;
    Box<S> around;
    for (int i = 0; i < 3; ++i) {
      const S about = image_half_extent(turn[i], half);
      const S at_middle = dot(turn[i], middle) + joint.translation[i];
      at_f[i] = dot(turn[i], f) + joint.translation[i];
      around.low[i] = at_middle - about, around.high[i] = at_middle + about;
    }
    images.add(k, at_f);
    if constexpr (slots > 1) {
      const S least = load(pack.least[k] + first);
      for (int i = 0; i < 3; ++i) {
        at_least[i] = at_least[i] + least * at_f[i];
        box_at_least.low[i] = box_at_least.low[i] + least * around.low[i];
        box_at_least.high[i] = box_at_least.high[i] + least * around.high[i];
      }
    }
    if (k == 0) box = around;
    else box.merge(around);
    if constexpr (deviates) rotations.add(k, joint.rotation);
  }
  S radius = load(pack.ball.radius + first), margin = load(pack.lost + first);
  bool is_known = true;
  if constexpr (deviates) {
    is_known = none_of(rotations.are_far());
    const S c = rotations.cosine(), n = load(pack.ball.joint_count + first);
    const S of_weights = squared_share_of_products(c, load(pack.products + first), load(pack.squared_products + first));
    const S share = root(min_of(squared_deviation_share(c), of_weights)) + S(off);
    const S of_f = images.spread(n) + load(pack.ball.unsolved + first);
    radius = radius + share * of_f;
    // A of a vertex is at most A of f plus what the rotations add.
    const S turned = load(pack.spin + first) * root(max_of(squared_turn_of_cosine(c), S(0)));
    margin = margin + share * (of_f + (turned + load(pack.unsolved_more + first)));
  }
  Box<S> cut = images.box();
  if constexpr (slots > 1) {  // the hull of a single image is the image
    const S rest = load(pack.rest + first);
    for (int i = 0; i < 3; ++i) {
      cut.low[i] = shrunk_by_least(at_least[i], rest, cut.low[i]), cut.high[i] = shrunk_by_least(at_least[i], rest, cut.high[i]);
      box.low[i] = shrunk_by_least(box_at_least.low[i], rest, box.low[i]);
      box.high[i] = shrunk_by_least(box_at_least.high[i], rest, box.high[i]);
    }
  }
  cut.grow(radius), box.grow(margin);
  for (int i = 0; i < 3; ++i) cut.low[i] = max_of(cut.low[i], box.low[i]), cut.high[i] = min_of(cut.high[i], box.high[i]);
  merge(cut);
  return is_known;
}

// Returns false if some lane has no known bound.
template <bool deviates, bool few>
bool merge_all(const Joints<few>& joints, const MotionBoundPiecePack* packs, int pack_count, float off, FlippedBox* boxes) {
  for (const MotionBoundPiecePack* pack = packs; pack != packs + pack_count; ++pack)
    for (int first = 0; first < motion_bound_lanes && pack->ball.slots_from(first) > 0; first += width) {
      const auto merge = [&](const Box<S>& box) { merge_lanes(box, pack->ball.target + first, boxes); };
      if (!with_slots(
              pack->ball.slots_from(first), [&](auto slots) __attribute__((always_inline)) {
                return bound_lanes<slots(), deviates>(*pack, first, joints, off, merge);
              }))
        return false;
    }
  return true;
}

template <bool few>
bool merge(const Joints<few>& joints, const MotionBoundPiecePack* packs, int pack_count, bool deviates, float off,
           FlippedBox* boxes) {
  return deviates ? merge_all<true>(joints, packs, pack_count, off, boxes)
                  : merge_all<false>(joints, packs, pack_count, off, boxes);
}

REFITLAB_KERNEL bool bound_pieces(float* numbers, int joint_count, int joint_stride, const MotionBoundPiecePack* packs,
                                  int pack_count, bool deviates, float off, FlippedBox* boxes) {
  if (joint_stride == 32) return merge<true>({numbers, joint_count, joint_stride}, packs, pack_count, deviates, off, boxes);
  return merge<false>({numbers, joint_count, joint_stride}, packs, pack_count, deviates, off, boxes);
}

}  // namespace

const BoundMotionPieces bound_motion_pieces = bound_pieces;

}  // namespace refitlab::REFITLAB_TARGET
