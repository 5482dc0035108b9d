// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"

#include <algorithm>
#include <bit>

#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/lane_bits.hpp"
#include "algorithms/runtime/packs/transpose.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
constexpr int width = static_cast<int>(S::size());
constexpr int record = Lanes<float>::count;  // of a candidate's vertices
static_assert(Lanes<float>::count % width == 0);

S load(const float* numbers) { return S(numbers, std::experimental::vector_aligned); }

// Returns the bits of the lanes in front of count.
std::uint32_t first_lanes(int count) { return (1u << (count < width ? count : width)) - 1; }

REFITLAB_KERNEL int overlaps(const BoxBlock<float>* blocks, int count, const Box<float>& box, int* out) {
  return find_meeting(blocks, count, box, out);
}

// Sets, by place, a bit for each side of the box that the place is beyond. Bits are added up as floats, which is exact, because
// Clang 14 cannot compile masks of sixteen integers.
void find_outcodes(const float* xyz, int place_count, const Box<float>& box, std::uint8_t* outcodes) {
  using Floats = Row<float, width>;
  using Whole = Row<std::int32_t, width>;
  using Bytes = Row<std::uint8_t, width>;
  for (int place = 0; place < place_count; place += width) {
    S code(0);
    for (int i = 0; i < 3; ++i) {
      const S x = load(xyz + i * place_count + place);
      code = code + choose(x < S(box.low[i]), S(static_cast<float>(1 << i)), S(0)) +
             choose(x > S(box.high[i]), S(static_cast<float>(8 << i)), S(0));
    }
    alignas(64) float numbers[width];
    code.copy_to(numbers, std::experimental::vector_aligned);
    Floats sums;
    read_row(numbers, sums);
    write_row(__builtin_convertvector(__builtin_convertvector(sums, Whole), Bytes), outcodes + place);
  }
}

REFITLAB_KERNEL int cull(const ClusterTriangles& triangles, const float* xyz, int place_count, const Box<float>& box,
                         const CandidateArrays& out) {
  find_outcodes(xyz, place_count, box, out.outcodes);
  const std::uint8_t* const codes = out.outcodes;
  int found = 0;
  for (int t = 0; t < triangles.count; ++t) {
    out.triangle[found] = t;
    found += (codes[triangles.vertex[0][t]] & codes[triangles.vertex[1][t]] & codes[triangles.vertex[2][t]]) == 0;
  }
  return found;
}

REFITLAB_KERNEL void place(const ClusterTriangles& triangles, const float* xyz, int place_count, const float* offset, int count,
                           const CandidateArrays& out, Box<float>& all) {
  for (int k = 0; k < count; ++k) {
    float* const vertices = out.vertices + record * k;
    for (int c = 0; c < 3; ++c) {
      const int at = triangles.vertex[c][out.triangle[k]];
      for (int i = 0; i < 3; ++i) vertices[3 * c + i] = xyz[i * place_count + at] + offset[i];
    }
    for (int i = 0; i < 3; ++i) {
      const float a = vertices[i], b = vertices[3 + i], c = vertices[6 + i];
      out.box[i][k] = min_of(min_of(a, b), c), out.box[3 + i][k] = max_of(max_of(a, b), c);
    }
  }
  Box<S> whole = Box<S>::empty();
  for (int end = (count + width - 1) / width * width, k = count; k < end; ++k)  // the last pack's other lanes repeat the first
    for (int i = 0; i < 6; ++i) out.box[i][k] = out.box[i][0];
  for (int k = 0; k < count; k += width) {
    const auto side = [&](int i) { return load(out.box[i] + k); };
    whole.merge(Box<S>{{side(0), side(1), side(2)}, {side(3), side(4), side(5)}});
  }
  for (int i = 0; i < 3; ++i)
    all.low[i] = std::experimental::hmin(whole.low[i]), all.high[i] = std::experimental::hmax(whole.high[i]);
}

// Returns the lanes whose boxes are not apart from the given one.
std::uint32_t meeting_lanes(const float* const (&sides)[6], int first, const Box<S>& box) {
  const auto side = [&](int i) { return load(sides[i] + first); };
  return lane_bits(!are_apart(Box<S>{{side(0), side(1), side(2)}, {side(3), side(4), side(5)}}, box));
}

Box<S> broadcast(const Box<float>& box) {
  Box<S> out;
  for (int i = 0; i < 3; ++i) out.low[i] = S(box.low[i]), out.high[i] = S(box.high[i]);
  return out;
}

REFITLAB_KERNEL int keep(int count, const Box<float>& box, const CandidateArrays& candidates) {
  const float* const sides[6] = {candidates.box[0], candidates.box[1], candidates.box[2],
                                 candidates.box[3], candidates.box[4], candidates.box[5]};
  const Box<S> all = broadcast(box);
  int kept = 0;
  for (int first = 0; first < count; first += width)
    for (std::uint32_t lanes = meeting_lanes(sides, first, all) & first_lanes(count - first); lanes; lanes &= lanes - 1) {
      const int from = first + std::countr_zero(lanes);
      if (from != kept) {
        candidates.triangle[kept] = candidates.triangle[from];
        for (float* side : candidates.box) side[kept] = side[from];
        Row<float, 8> vertices;
        read_row(candidates.vertices + record * from, vertices);
        write_row(vertices, candidates.vertices + record * kept);
        candidates.vertices[record * kept + 8] = candidates.vertices[record * from + 8];
      }
      ++kept;
    }
  return kept;
}

REFITLAB_KERNEL int meeting(const CandidateArrays& a, int count_a, const CandidateArrays& b, int begin, int end, float margin,
                            std::int32_t* first, std::int32_t* second) {
  int found = 0;
  for (int block = begin; block < end; block += width) {
    Box<S> own;
    for (int i = 0; i < 3; ++i)
      own.low[i] = load(b.box[i] + block) - S(margin), own.high[i] = load(b.box[3 + i] + block) + S(margin);
    const std::uint32_t valid = first_lanes(end - block);
    for (int k = 0; k < count_a; ++k) {
      const Box<S> other{{S(a.box[0][k]), S(a.box[1][k]), S(a.box[2][k])}, {S(a.box[3][k]), S(a.box[4][k]), S(a.box[5][k])}};
      for (int lane = 0; lane < width; ++lane) first[found + lane] = k;
      found += write_lanes(lane_bits(!are_apart(own, other)) & valid, block, second + found);
    }
  }
  return found;
}

// Returns the vertices of one candidate in each lane. Lanes behind the last pair repeat it. They are read eight at a time,
// however few lanes there are.
TriangleOf<S> vertices_of(const CandidateArrays& candidates, const std::int32_t* which, int count) {
  constexpr int read = std::max(width, 8);
  alignas(64) float numbers[9][read];
  const float* rows[8];
  for (int block = 0; block < read; block += 8) {
    for (int i = 0; i < 8; ++i) {
      const int lane = block + i < count ? block + i : count - 1;
      rows[i] = candidates.vertices + record * which[lane];
      numbers[8][block + i] = rows[i][8];
    }
    transpose<float>(rows, numbers[0] + block, read);
  }
  TriangleOf<S> out;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) out[c][i] = load(numbers[3 * c + i]);
  return out;
}

REFITLAB_KERNEL void filter(const CandidateArrays& a, const CandidateArrays& b, const std::int32_t* first,
                            const std::int32_t* second, int count, float slack, std::int32_t* meet, int& meet_count,
                            std::int32_t* unknown, int& unknown_count) {
  const NearVertices<S> vertices{S(2 * slack)};
  for (int from = 0; from < count; from += width) {
    const auto filtered = filter_lanes<S, NearVertices<S>>(vertices_of(a, first + from, count - from),
                                                           vertices_of(b, second + from, count - from), vertices);
    const std::uint32_t valid = first_lanes(count - from), apart = lane_bits(filtered.are_apart);
    const std::uint32_t meeting = lane_bits(filtered.meet) & ~apart & valid, open = ~(meeting | apart) & valid;
    meet_count += write_lanes(meeting, from, meet + meet_count);
    unknown_count += write_lanes(open, from, unknown + unknown_count);
  }
}

}  // namespace

const ClusterPairKernels cluster_pair_kernels{overlaps, cull, place, keep, meeting, filter};

}  // namespace refitlab::REFITLAB_TARGET
