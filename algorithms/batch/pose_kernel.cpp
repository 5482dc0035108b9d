#include "algorithms/batch/pose_kernel.hpp"

#include "algorithms/packs/pack.hpp"
#include "algorithms/skinning/rotation_center.hpp"
#include "algorithms/skinning/skinning_pose.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<double>;
constexpr int width = static_cast<int>(S::size());
static_assert(pose_lanes % width == 0);

template <int D>
Vec<S, D> gather(const double* from, const std::int32_t* index, int stride) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S([&](auto lane) { return from[index[lane] * stride + i]; });
  return out;
}

// Component i of lane l to to[(index[l] + offset) * stride + i].
template <int D>
void scatter(const Vec<S, D>& v, double* to, const std::int32_t* index, int offset, int stride) {
  alignas(64) double lanes[D][width];
  for (int i = 0; i < D; ++i) v[i].copy_to(lanes[i], std::experimental::vector_aligned);
  for (int lane = 0; lane < width; ++lane)
    for (int i = 0; i < D; ++i) to[(index[lane] + offset) * stride + i] = lanes[i][lane];
}

template <int N>
void run_joints(const PosePack* packs, int count, bool are_centers_fixed, const double* posture, int stride, const PoseNumbers& out) {
  for (const PosePack* pack = packs; pack != packs + count; ++pack)
    for (int first = 0; first < pose_lanes; first += width) {
      const std::int32_t *set = pack->set + first, *slot = pack->first_slot + first;
      RigidTransform<S> transforms[N];
      for (int j = 0; j < N; ++j) {
        const std::int32_t* joint = pack->joint[j] + first;
        transforms[j] = {gather<4>(posture, joint, stride), gather<3>(posture + 4, joint, stride)};
      }
      make_signs_consistent<S>(transforms);
      Vec<S, 3> center;
      for (int i = 0; i < 3; ++i) center[i] = S(pack->prior[i] + first, std::experimental::element_aligned);
      if (N > 1 && !are_centers_fixed) center = rotation_center<S>(transforms, center);
      scatter<3>(center, out.rotation_centers, set, 0, 3);
      for (int j = 0; j < N; ++j) {
        scatter<4>(transforms[j].rotation, out.transforms, slot, j, stride);
        scatter<3>(transforms[j].translation, out.transforms + 4, slot, j, stride);
        scatter<3>(apply(transforms[j], center), out.center_images, slot, j, 3);
        scatter<4>(dual_part(transforms[j]), out.duals, slot, j, 4);
      }
    }
}

REFITLAB_KERNEL void run(const PosePack* packs, int count, int joints, bool are_centers_fixed, const double* posture, int stride,
                         const PoseNumbers& out) {
  switch (joints) {
    case 1: return run_joints<1>(packs, count, are_centers_fixed, posture, stride, out);
    case 2: return run_joints<2>(packs, count, are_centers_fixed, posture, stride, out);
    case 3: return run_joints<3>(packs, count, are_centers_fixed, posture, stride, out);
    default: return run_joints<4>(packs, count, are_centers_fixed, posture, stride, out);
  }
}

}  // namespace

const PoseRun pose_run = run;

}  // namespace refitlab::REFITLAB_TARGET
