// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/box_kernel.hpp"

#include "algorithms/runtime/collide/box_lanes.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

REFITLAB_KERNEL void bound(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots,
                           const float* centers, const float* rotation, FlippedBox* boxes) {
  BoxKernel<refitlab::Pack<float>>::run(packs, count, joints, skinning, slots, centers, rotation, boxes);
}

REFITLAB_KERNEL void filter_pairs(const PaddedVertex* vertices_a, const PaddedVertex* vertices_b,
                                  const TrianglePairCandidate* pairs, int count, Filtered* answers) {
  using S = refitlab::Pack<double>;
  constexpr int width = static_cast<int>(S::size());
  for (int first = 0; first < count; first += width) {
    const int lanes = count - first < width ? count - first : width;
    const auto load = [&](const PaddedVertex* vertices, auto places, TriangleOf<S>& out) {
      alignas(64) double numbers[9][width];
      for (int lane = 0; lane < width; ++lane) {  // those behind the last repeat it
        const TrianglePairCandidate& pair = pairs[first + (lane < lanes ? lane : lanes - 1)];
        for (int c = 0; c < 3; ++c)
          for (int i = 0; i < 3; ++i) numbers[3 * c + i][lane] = vertices[places(pair)[c]].of[i];
      }
      for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 3; ++i) out[c][i] = S(numbers[3 * c + i], std::experimental::vector_aligned);
    };
    TriangleOf<S> a, b;
    load(
        vertices_a, [](const TrianglePairCandidate& p) { return p.a; }, a);
    load(
        vertices_b, [](const TrianglePairCandidate& p) { return p.b; }, b);
    const auto filtered = filter_lanes<S>(a, b);
    bool apart[width], meet[width];
    filtered.are_apart.copy_to(apart, std::experimental::element_aligned);
    filtered.meet.copy_to(meet, std::experimental::element_aligned);
    for (int lane = 0; lane < lanes; ++lane)
      answers[first + lane] = apart[lane] ? Filtered::apart : meet[lane] ? Filtered::meet : Filtered::unknown;
  }
}

REFITLAB_KERNEL void place(const Lanes<double>* skinned, int block_count, const double* placement, PaddedVertex* out) {
  using S = refitlab::Pack<double>;
  constexpr int width = static_cast<int>(S::size());
  RigidTransform<S> at;
  for (int i = 0; i < 4; ++i) at.rotation[i] = S(placement[i]);
  for (int i = 0; i < 3; ++i) at.translation[i] = S(placement[4 + i]);
  for (int block = 0; block < block_count; ++block, skinned += 3)
    for (int first = 0; first < Lanes<double>::count; first += width, out += width) {
      const auto load = [&](int i) { return S(skinned[i].lane.data() + first, std::experimental::element_aligned); };
      const Vec<S, 3> p = apply(at, Vec<S, 3>(load(0), load(1), load(2)));
      for (int lane = 0; lane < width; ++lane) out[lane] = {p[0][lane], p[1][lane], p[2][lane], 0};
    }
}

}  // namespace

const BoxKernels box_kernels{bound, filter_pairs, place};

}  // namespace refitlab::REFITLAB_TARGET
