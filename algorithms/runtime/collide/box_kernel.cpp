// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/box_kernel.hpp"

#include "algorithms/runtime/collide/box_lanes.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

REFITLAB_KERNEL void bound(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots,
                           const float* centers, const float* rotation, FlippedBox* boxes) {
  BoxKernel<refitlab::Pack<float>>::run(packs, count, joints, skinning, slots, centers, rotation, boxes);
}

REFITLAB_KERNEL bool put_grown(const FlippedBox* boxes, int count, double lost, BoxBlock<float>* blocks, Box<float>& whole) {
  Row<float, 8> merged, sum, row;
  read_row(boxes[0].of, merged);
  sum = merged;
  for (const FlippedBox* box = boxes + 1; box < boxes + count; ++box) {
    read_row(box->of, row);
    merged = row < merged ? row : merged;
    sum = sum + row;
  }
  float largest = 0;
  bool are_known = true;
  for (const int i : {0, 1, 2, 4, 5, 6}) {
    largest = max_of(largest, abs(merged[i]));
    are_known = are_known && abs(merged[i]) < largest_box && abs(sum[i]) < infinite;  // or some number is undefined or infinite
  }
  const float off = growth_of_float_box(lost, largest);
  if (!are_known || !(off < largest_box)) return false;
  merged = merged - off;
  for (int i = 0; i < 3; ++i) whole.low[i] = merged[i], whole.high[i] = -merged[4 + i];
  for (int first = 0; first < count; first += 8) {
    const auto read = [&](int i, int side, Row<float, 4>& four) {  // places behind the last box repeat it
      read_row(boxes[first + i < count ? first + i : count - 1].of + side, four);
      four = four - off;
    };
    alignas(64) float sides[8][8];
    transpose_records<8>(read, sides[0], 8);
    for (int i = 0; i < 3; ++i) {
      read_row(sides[i], row);
      write_row(row, blocks[first / 8].side[i]);
      read_row(sides[4 + i], row);
      write_row(Row<float, 8>(-row), blocks[first / 8].side[3 + i]);
    }
  }
  return true;
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

const BoxKernels box_kernels{bound, put_grown, filter_pairs, place};

}  // namespace refitlab::REFITLAB_TARGET
