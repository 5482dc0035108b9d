#include "algorithms/batch/skin_kernel.hpp"

#include "algorithms/packs/pack.hpp"
#include "algorithms/skinning/blend.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<double>;
constexpr int pack_size = static_cast<int>(S::size());

template <int D>
Vec<S, D> broadcast(const double* numbers) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S(numbers[i]);
  return out;
}

S load(const Lanes<double>& lanes, int first) { return S(lanes.lane.data() + first, std::experimental::element_aligned); }

// The joint-set in every lane, in storage that is used again.
const JointSetPose<S>& broadcast_pose(const JointSetNumbers& joints) {
  thread_local JointSetPose<S> pose;
  pose.transforms.clear(), pose.center_images.clear(), pose.duals.clear();
  pose.rotation_center = broadcast<3>(joints.rotation_center);
  for (int i = 0; i < joints.joint_count; ++i) {
    const double* transform = joints.transforms + i * joints.transform_stride;
    pose.transforms.push_back({broadcast<4>(transform), broadcast<3>(transform + 4)});
    pose.center_images.push_back(broadcast<3>(joints.center_images + 3 * i));
    pose.duals.push_back(broadcast<4>(joints.duals + 4 * i));
  }
  return pose;
}

template <Skinning skinning>
REFITLAB_KERNEL void skin_run(const JointSetNumbers& joints, const Lanes<double>* data, int block_count, Lanes<double>* out) {
  const JointSetPose<S>& pose = broadcast_pose(joints);
  thread_local std::vector<S> w;
  w.resize(joints.joint_count);
  for (int block = 0; block < block_count; ++block) {
    for (int first = 0; first < Lanes<double>::count; first += pack_size) {
      const Vec<S, 3> v(load(data[0], first), load(data[1], first), load(data[2], first));
      for (int i = 0; i < joints.joint_count; ++i) w[i] = load(data[3 + i], first);
      const Vec<S, 3> image = blend<S>(skinning, pose, w, v);
      for (int i = 0; i < 3; ++i) image[i].copy_to(out[i].lane.data() + first, std::experimental::element_aligned);
    }
    data += 3 + joints.joint_count;
    out += 3;
  }
}

}  // namespace

const SkinKernels skin_kernels{skin_run<Skinning::linear>, skin_run<Skinning::spherical>, skin_run<Skinning::dual_quaternion>};

}  // namespace refitlab::REFITLAB_TARGET
