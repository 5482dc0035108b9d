// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/skin_kernel.hpp"

#include "algorithms/runtime/packs/by_joint.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "algorithms/runtime/skinning/blend.hpp"

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

// Calls image(v, w) for the vertices and their weights, a pack of them at a time.
template <int joints, class Image>
void skin_packs(int n, const Lanes<double>* data, int block_count, Lanes<double>* out, const Image& image_of) {
  ByJoint<S, joints> w(n);
  for (int block = 0; block < block_count; ++block) {
    for (int first = 0; first < Lanes<double>::count; first += pack_size) {
      const Vec<S, 3> v(load(data[0], first), load(data[1], first), load(data[2], first));
      for (int i = 0; i < n; ++i) w[i] = load(data[3 + i], first);
      const Vec<S, 3> image = image_of(v, std::span<const S>(w.data(), n));
      for (int i = 0; i < 3; ++i) image[i].copy_to(out[i].lane.data() + first, std::experimental::element_aligned);
    }
    data += 3 + n;
    out += 3;
  }
}

// Every lane has the same joint-set. joints is how many joints it has, or 0 if that is only known at run time.
template <Skinning skinning, int joints>
void skin_blocks(const JointSetNumbers& numbers, const Lanes<double>* data, int block_count, Lanes<double>* out) {
  const int n = joints ? joints : numbers.joint_count;
  ByJoint<RigidTransform<S>, joints> transforms(n);
  ByJoint<Vec<S, 3>, joints> center_images(n);
  ByJoint<Quaternion<S>, joints> duals(n);
  for (int i = 0; i < n; ++i) {
    const double* transform = numbers.transforms + i * numbers.transform_stride;
    transforms[i] = {broadcast<4>(transform), broadcast<3>(transform + 4)};
    center_images[i] = broadcast<3>(numbers.center_images + 3 * i);
    duals[i] = broadcast<4>(numbers.duals + 4 * i);
  }
  const PaletteEntry<S> palette{transforms, broadcast<3>(numbers.rotation_center), center_images, duals, {}, {}};
  skin_packs<joints>(n, data, block_count, out,
                     [&](const Vec<S, 3>& v, std::span<const S> w) { return blend<S>(skinning, palette, w, v); });
}

template <int joints>
void skin_affine_blocks(const JointSetNumbers& numbers, const Lanes<double>* data, int block_count, Lanes<double>* out) {
  const int n = joints ? joints : numbers.joint_count;
  ByJoint<AffineMap<S>, joints> maps(n);
  for (int i = 0; i < n; ++i) {
    const double* map = numbers.maps + 12 * i;
    maps[i] = {{broadcast<3>(map), broadcast<3>(map + 3), broadcast<3>(map + 6)}, broadcast<3>(map + 9)};
  }
  skin_packs<joints>(n, data, block_count, out, [&](const Vec<S, 3>& v, std::span<const S> w) {
    return linear_blend<S>(std::span<const AffineMap<S>>(maps), w, v);
  });
}

template <Skinning skinning>
REFITLAB_KERNEL void skin_run(const JointSetNumbers& joints, const Lanes<double>* data, int block_count, Lanes<double>* out) {
  switch (joints.joint_count) {
    case 1: return skin_blocks<skinning, 1>(joints, data, block_count, out);
    case 2: return skin_blocks<skinning, 2>(joints, data, block_count, out);
    case 3: return skin_blocks<skinning, 3>(joints, data, block_count, out);
    case 4: return skin_blocks<skinning, 4>(joints, data, block_count, out);
    default: return skin_blocks<skinning, 0>(joints, data, block_count, out);
  }
}

REFITLAB_KERNEL void skin_affine_run(const JointSetNumbers& joints, const Lanes<double>* data, int block_count,
                                     Lanes<double>* out) {
  switch (joints.joint_count) {
    case 1: return skin_affine_blocks<1>(joints, data, block_count, out);
    case 2: return skin_affine_blocks<2>(joints, data, block_count, out);
    case 3: return skin_affine_blocks<3>(joints, data, block_count, out);
    case 4: return skin_affine_blocks<4>(joints, data, block_count, out);
    default: return skin_affine_blocks<0>(joints, data, block_count, out);
  }
}

}  // namespace

const SkinKernels skin_kernels{skin_run<Skinning::linear>, skin_run<Skinning::spherical>, skin_run<Skinning::dual_quaternion>,
                               skin_affine_run};

}  // namespace refitlab::REFITLAB_TARGET
