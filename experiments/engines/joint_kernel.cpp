// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/joint_kernel.hpp"

#include "algorithms/runtime/collide/motion_bound_lanes.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

// A MatrixRow is row `row` of the matrices of some joints, with the translation last.
struct MatrixRow {
  S x, y, z, t;

  [[gnu::always_inline]] MatrixRow(const float* matrices, int row, int stride, int first)
      : x(load(matrices + (4 * row + 0) * stride + first)),
        y(load(matrices + (4 * row + 1) * stride + first)),
        z(load(matrices + (4 * row + 2) * stride + first)),
        t(load(matrices + (4 * row + 3) * stride + first)) {}
  [[gnu::always_inline]] S image(const Point& p) const { return x * p[0] + (y * p[1] + (z * p[2] + t)); }
  [[gnu::always_inline]] S extent(const Point& h, const S& radius) const {
    return abs(x) * h[0] + (abs(y) * h[1] + (abs(z) * h[2] + radius));
  }
  [[gnu::always_inline]] S extent(const Point& h) const { return abs(x) * h[0] + (abs(y) * h[1] + abs(z) * h[2]); }
};

[[gnu::always_inline]] inline Point load_row(const float* numbers, int number, int stride, int first) {
  return {load(numbers + number * stride + first), load(numbers + (number + 1) * stride + first),
          load(numbers + (number + 2) * stride + first)};
}

// Merges what add(first, merge) merges for all joints, three least and three greatest coordinates at a time. If is_grown, the box
// is grown along each axis by lost times the greatest absolute value.
template <bool is_grown, class Add>
[[gnu::always_inline]] inline void merge_joints(int stride, float lost, float* out, const Add& add) {
  S low[3] = {S(infinity), S(infinity), S(infinity)}, high[3] = {S(-infinity), S(-infinity), S(-infinity)};
  for (int first = 0; first < stride; first += width)
    add(first, [&](int axis, const S& least, const S& greatest) {
      low[axis] = min_of(low[axis], least), high[axis] = max_of(high[axis], greatest);
    });
  for (int i = 0; i < 3; ++i) {
    const float least = std::experimental::hmin(low[i]), greatest = std::experimental::hmax(high[i]);
    const float by = is_grown ? lost * max_of(-least, greatest) : 0;
    out[i] = least - by, out[3 + i] = greatest + by;
  }
}

REFITLAB_KERNEL void make_matrices(const double* pose, int joint_count, float* scratch, int stride, float* matrices) {
  const Joints<false> joints{scratch, joint_count, stride};
  joints.read(pose);
  for (int first = 0; first < stride; first += width) {
    const Transform joint = joints.lanes(first);
    const S w = joint.rotation[0], x = joint.rotation[1], y = joint.rotation[2], z = joint.rotation[3];
    const S xx = (x + x) * x, yy = (y + y) * y, zz = (z + z) * z, xy = (x + x) * y, xz = (x + x) * z, yz = (y + y) * z,
            wx = (w + w) * x, wy = (w + w) * y, wz = (w + w) * z, one(1.f);
    const S numbers[matrix_numbers] = {one - yy - zz, xy - wz,       xz + wy,       joint.translation[0],
                                       xy + wz,       one - xx - zz, yz - wx,       joint.translation[1],
                                       xz - wy,       yz + wx,       one - xx - yy, joint.translation[2]};
    for (int i = 0; i < matrix_numbers; ++i) numbers[i].copy_to(matrices + i * stride + first, std::experimental::vector_aligned);
  }
}

REFITLAB_KERNEL void merge_boxes(const float* matrices, const float* boxes, int stride, float* out) {
  merge_joints<false>(stride, 0, out, [&](int first, const auto& merge) {
    const Point center = load_row(boxes, 0, stride, first), half = load_row(boxes, 3, stride, first);
#pragma GCC unroll 3
    for (int axis = 0; axis < 3; ++axis) {
      const MatrixRow row(matrices, axis, stride, first);
      const S middle = row.image(center), extent = row.extent(half);
      merge(axis, middle - extent, middle + extent);
    }
  });
}

REFITLAB_KERNEL void merge_rounded_boxes(const float* matrices, const float* boxes, int stride, float lost, float* out) {
  merge_joints<true>(stride, lost, out, [&](int first, const auto& merge) {
    const Point center = load_row(boxes, 0, stride, first), half = load_row(boxes, 3, stride, first);
    const S radius = load(boxes + 6 * stride + first);
#pragma GCC unroll 3
    for (int axis = 0; axis < 3; ++axis) {
      const MatrixRow row(matrices, axis, stride, first);
      const S middle = row.image(center), extent = row.extent(half, radius);
      merge(axis, middle - extent, middle + extent);
    }
  });
}

REFITLAB_KERNEL void merge_capsules(const float* matrices, const float* capsules, int stride, float lost, float* out) {
  merge_joints<true>(stride, lost, out, [&](int first, const auto& merge) {
    const Point one = load_row(capsules, 0, stride, first), other = load_row(capsules, 3, stride, first);
    const S radius = load(capsules + 6 * stride + first);
#pragma GCC unroll 3
    for (int axis = 0; axis < 3; ++axis) {
      const MatrixRow row(matrices, axis, stride, first);
      const S a = row.image(one), b = row.image(other);
      merge(axis, min_of(a, b) - radius, max_of(a, b) + radius);
    }
  });
}

}  // namespace

const JointKernels joint_kernels = {make_matrices, merge_boxes, merge_rounded_boxes, merge_capsules};

}  // namespace refitlab::REFITLAB_TARGET
