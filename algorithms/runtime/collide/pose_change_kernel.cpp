// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/pose_change_kernel.hpp"

#include "algorithms/runtime/collide/motion_bound_lanes.hpp"
#include "lemmas/b9_pose_change.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

Point load_anchor(const float* anchors, int stride, int first) {
  return {load(anchors + first), load(anchors + stride + first), load(anchors + 2 * stride + first)};
}

REFITLAB_KERNEL void keep_pose(const double* pose, int joint_count, int joint_stride, const float* anchors, float* kept) {
  for (int first = 0; first < joint_count; first += width) {
    const Transform joint = joints_of_pose(pose, joint_count, first);
    const Point image = apply(joint, load_anchor(anchors, joint_stride, first));
    for (int i = 0; i < 4; ++i) joint.rotation[i].copy_to(kept + i * joint_stride + first, std::experimental::vector_aligned);
    for (int i = 0; i < 3; ++i) image[i].copy_to(kept + (4 + i) * joint_stride + first, std::experimental::vector_aligned);
  }
}

REFITLAB_KERNEL void compare_pose(const double* pose, int joint_count, int joint_stride, const float* anchors, const float* kept,
                                  JointChange& out) {
  S most[4] = {S(0), S(0), S(0), S(0)};
  for (int first = 0; first < joint_count; first += width) {
    const Transform joint = joints_of_pose(pose, joint_count, first);
    const Point image = apply(joint, load_anchor(anchors, joint_stride, first));
    Transform before;
    for (int i = 0; i < 4; ++i) before.rotation[i] = load(kept + i * joint_stride + first);
    for (int i = 0; i < 3; ++i) before.translation[i] = load(kept + (4 + i) * joint_stride + first);
    const auto is_opposite = dot(joint.rotation, before.rotation) < S(0);
    Quaternion<S> difference;
    for (int i = 0; i < 4; ++i)
      difference[i] = choose(is_opposite, S(-joint.rotation[i]), joint.rotation[i]) - before.rotation[i];
    const S radius = load(anchors + 3 * joint_stride + first), turned = root(squared_norm(difference)),
            moved = moved_at_most(root(squared_norm(Point(image - before.translation))), turned, radius);
    const auto is_looked_at = radius >= S(0);
    most[0] = max_of(most[0], choose(is_looked_at, moved, S(0)));
    most[1] = max_of(most[1], choose(is_looked_at, turned, S(0)));
    most[2] = max_of(most[2], squared_reach(joint));
    most[3] = max_of(most[3], defect(joint));
  }
  float folded[4];
  fold<false>(most, folded);
  out = {folded[0], folded[1], folded[2], folded[3]};
}

}  // namespace

const PoseChangeKernels pose_change_kernels{keep_pose, compare_pose};

}  // namespace refitlab::REFITLAB_TARGET
