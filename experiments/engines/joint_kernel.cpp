// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/joint_kernel.hpp"

#include "algorithms/runtime/collide/motion_bound_lanes.hpp"
#include "lemmas/a1_affine_image.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

constexpr int block_lanes = motion_bound_lanes;  // joints of a block

// Returns numbers that are read once. A compiler that finds them in memory reads them anew for each use, which costs more.
[[gnu::always_inline]] inline S load_once(const float* numbers) {
  auto row = __builtin_bit_cast(Row<float, width>, load(numbers));
#ifdef __x86_64__
  asm("" : "+v"(row));
#endif
  return __builtin_bit_cast(S, row);
}

[[gnu::always_inline]] inline Point load_row(const float* numbers, int number) {
  return {load_once(numbers + number * block_lanes), load_once(numbers + (number + 1) * block_lanes),
          load_once(numbers + (number + 2) * block_lanes)};
}

// MatrixRow is row i of the matrices of some joints of a block, with the translation behind. matrices are the block's numbers from
// that of the first of these joints on.
struct MatrixRow {
  Point row;
  S translation;

  [[gnu::always_inline]] MatrixRow(const float* matrices, int i)
      : row(load_row(matrices, 4 * i)),
        translation(load(matrices + (4 * i + 3) * block_lanes)) {}
  [[gnu::always_inline]] S image(const Point& p) const { return row[0] * p[0] + (row[1] * p[1] + (row[2] * p[2] + translation)); }
  [[gnu::always_inline]] S extent(const Point& half) const { return image_half_extent(row, half); }
};

using Four = Row<float, 4>;

inline Four greater_of(const Four& a, const Four& b) { return a < b ? b : a; }

// These return the greatest of every fourth lane, in four lanes. Which of them are used depends on the target.
[[maybe_unused, gnu::always_inline]] inline Four in_four_lanes(const Four& x) { return x; }
[[maybe_unused, gnu::always_inline]] inline Four in_four_lanes(const Row<float, 8>& x) {
  return greater_of(__builtin_shufflevector(x, x, 0, 1, 2, 3), __builtin_shufflevector(x, x, 4, 5, 6, 7));
}
[[maybe_unused, gnu::always_inline]] inline Four in_four_lanes(const Row<float, 16>& x) {
  const Row<float, 8> one = __builtin_shufflevector(x, x, 0, 1, 2, 3, 4, 5, 6, 7),
                      other = __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15);
  return in_four_lanes(one < other ? other : one);
}
[[gnu::always_inline]] inline Four in_four_lanes(const S& x) { return in_four_lanes(__builtin_bit_cast(Row<float, width>, x)); }

// Returns the greatest of each of three packs, and that of the last once more.
[[gnu::always_inline]] inline Four greatest_of(const S (&packs)[3]) {
  const Four a = in_four_lanes(packs[0]), b = in_four_lanes(packs[1]), c = in_four_lanes(packs[2]);
  const Four two = greater_of(__builtin_shufflevector(a, b, 0, 4, 1, 5), __builtin_shufflevector(a, b, 2, 6, 3, 7)),
             one = greater_of(c, __builtin_shufflevector(c, c, 2, 3, 0, 1));
  return greater_of(__builtin_shufflevector(two, one, 0, 1, 4, 4), __builtin_shufflevector(two, one, 2, 3, 5, 5));
}

// Merges what add(block, matrices, volumes, merge) merges for some joints of a block: by axis, how far they reach against it and
// along it. A joint has volume_numbers numbers. With is_grown, the box grows along each axis by lost times the greatest absolute
// value.
template <int volume_numbers, bool is_grown, class Add>
[[gnu::always_inline]] inline void merge_joints(const float* matrices, const float* volumes, int blocks, float lost, float* out,
                                                const Add& add) {
  S against[3] = {S(-infinity), S(-infinity), S(-infinity)}, along[3] = {S(-infinity), S(-infinity), S(-infinity)};
  for (int block = 0; block < blocks; ++block)
    for (int first = 0; first < block_lanes; first += width)
      add(
          block, matrices + block * matrix_numbers * block_lanes + first, volumes + block * volume_numbers * block_lanes + first,
          [&](int axis, const S& reach_against, const S& reach_along) __attribute__((always_inline)) {
            against[axis] = max_of(against[axis], reach_against), along[axis] = max_of(along[axis], reach_along);
          });
  Four low = greatest_of(against), high = greatest_of(along);
  if constexpr (is_grown) {
    const Four by = greater_of(low, high) * lost;
    low += by, high += by;
  }
  low = -low;
  for (int i = 0; i < 3; ++i) out[i] = low[i], out[3 + i] = high[i];
}

REFITLAB_KERNEL void make_matrices(const double* pose, int joint_count, int blocks, float* matrices) {
  for (int first = 0; first < blocks * block_lanes; first += width) {
    const Transform joint = joints_of_pose(pose, joint_count, first);
    const std::array<Point, 3> rows = rotation_rows(joint.rotation);
    float* to = matrices + first / block_lanes * matrix_numbers * block_lanes + first % block_lanes;
    const auto put = [&](const S& number) { number.copy_to(to, std::experimental::vector_aligned), to += block_lanes; };
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) put(rows[i][k]);
      put(joint.translation[i]);
    }
  }
}

// Merges what is about these centers: extent(row) by row of their joints' matrices.
template <class Merge, class Extent>
[[gnu::always_inline]] inline void merge_about(const float* matrices, const float* centers, const Merge& merge,
                                               const Extent& extent) {
  const Point center = load_row(centers, 0);
#pragma GCC unroll 3
  for (int axis = 0; axis < 3; ++axis) {
    const MatrixRow row(matrices, axis);
    const S middle = row.image(center), reach = extent(row);
    merge(axis, reach - middle, reach + middle);
  }
}

REFITLAB_KERNEL void merge_boxes(const float* matrices, const float* boxes, int blocks, float* out) {
  merge_joints<box_numbers, false>(
      matrices, boxes, blocks, 0, out,
      [](int, const float* some, const float* box, const auto& merge) __attribute__((always_inline)) {
        const Point half = load_row(box, 3);
        merge_about(
            some, box, merge, [&](const MatrixRow& row) __attribute__((always_inline)) { return row.extent(half); });
      });
}

REFITLAB_KERNEL void merge_rounded_boxes(const float* matrices, const float* boxes, const unsigned char* are_balls, int blocks,
                                         float lost, float* out) {
  merge_joints<rounded_box_numbers, true>(
      matrices, boxes, blocks, lost,
      out, [are_balls](int block, const float* some, const float* box, const auto& merge) __attribute__((always_inline)) {
        const S radius = load_once(box + 6 * block_lanes);
        if (are_balls[block]) {
          merge_about(
              some, box, merge, [&](const MatrixRow&) __attribute__((always_inline)) { return radius; });
        } else {
          const Point half = load_row(box, 3);
          merge_about(
              some, box, merge, [&](const MatrixRow& row) __attribute__((always_inline)) { return row.extent(half) + radius; });
        }
      });
}

REFITLAB_KERNEL void merge_capsules(const float* matrices, const float* capsules, int blocks, float lost, float* out) {
  merge_joints<capsule_numbers, true>(
      matrices, capsules, blocks, lost, out,
      [](int, const float* some, const float* capsule, const auto& merge) __attribute__((always_inline)) {
        const Point one = load_row(capsule, 0), other = load_row(capsule, 3);
        const S radius = load(capsule + 6 * block_lanes);
#pragma GCC unroll 3
        for (int axis = 0; axis < 3; ++axis) {
          const MatrixRow row(some, axis);
          const S a = row.image(one), b = row.image(other);
          merge(axis, radius - min_of(a, b), max_of(a, b) + radius);
        }
      });
}

}  // namespace

const JointKernels joint_kernels = {make_matrices, merge_boxes, merge_capsules, merge_rounded_boxes};

}  // namespace refitlab::REFITLAB_TARGET
