// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"

#include <algorithm>
#include <array>
#include <limits>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "algorithms/runtime/collide/triangles_filter.hpp"
#include "algorithms/runtime/packs/common_bit.hpp"
#include "algorithms/runtime/packs/lane_bits.hpp"
#include "algorithms/runtime/packs/look_up.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
constexpr int width = static_cast<int>(S::size());
static_assert(Lanes<float>::count % width == 0);
constexpr float infinity = std::numeric_limits<float>::infinity();

S load(const float* numbers) { return S(numbers, std::experimental::vector_aligned); }
void store(const S& numbers, float* out) { numbers.copy_to(out, std::experimental::vector_aligned); }

void fill_pack(std::int32_t with, std::int32_t* out) {
  for (int lane = 0; lane < width; ++lane) out[lane] = with;
}

// Returns the bits of the lanes in front of count.
std::uint32_t first_lanes(int count) { return (1u << (count < width ? count : width)) - 1; }

REFITLAB_KERNEL int overlaps(const BoxBlock<float>* blocks, int count, const Box<float>& box, int* out) {
  return find_meeting(blocks, count, box, out);
}

// Sets, by position, a bit for each side of the box that the vertex is beyond.
#ifdef __AVX512F__
void find_outcodes(const float* xyz, int room, const Box<float>& box, std::uint8_t* outcodes) {
  for (int first = 0; first < room; first += width) {
    __m512i code = _mm512_setzero_si512();
    for (int i = 0; i < 3; ++i) {
      const __m512 x = _mm512_load_ps(xyz + i * room + first);
      const __mmask16 below = _mm512_cmp_ps_mask(x, _mm512_set1_ps(box.low[i]), _CMP_LT_OQ);
      const __mmask16 above = _mm512_cmp_ps_mask(x, _mm512_set1_ps(box.high[i]), _CMP_GT_OQ);
      code = _mm512_mask_or_epi32(code, below, code, _mm512_set1_epi32(1 << i));
      code = _mm512_mask_or_epi32(code, above, code, _mm512_set1_epi32(8 << i));
    }
    _mm_storeu_si128(reinterpret_cast<__m128i*>(outcodes + first), _mm512_cvtepi32_epi8(code));
  }
}
#else
// Bits are added up as floats, which is exact. A block of sums is wider than registers, and becomes bytes by way of short integers, as
// GCC takes the lanes one by one otherwise.
void find_outcodes(const float* xyz, int room, const Box<float>& box, std::uint8_t* outcodes) {
  constexpr int block = Lanes<float>::count;
  for (int first = 0; first < room; first += block) {
    alignas(64) float sums[block];
    for (int lane = 0; lane < block; lane += width) {
      S code(0);
      for (int i = 0; i < 3; ++i) {
        const S x = load(xyz + i * room + first + lane);
        code = code + choose(x < S(box.low[i]), S(static_cast<float>(1 << i)), S(0)) +
               choose(x > S(box.high[i]), S(static_cast<float>(8 << i)), S(0));
      }
      store(code, sums + lane);
    }
    Row<float, block> row;
    read_row(sums, row);
    const auto whole = __builtin_convertvector(__builtin_convertvector(row, Row<std::int32_t, block>), Row<std::int16_t, block>);
    write_row(__builtin_convertvector(whole, Row<std::uint8_t, block>), outcodes + first);
  }
}
#endif

REFITLAB_KERNEL int cull(const ClusterTriangles& triangles, const float* xyz, int room, const Box<float>& box,
                         const CandidateArrays& out) {
  find_outcodes(xyz, room, box, out.outcodes);
  int found = 0;
  for (int t = 0; t < triangles.count; t += byte_lanes) {
    const int lanes = std::min(byte_lanes, triangles.count - t);
    const std::uint32_t near =
        have_no_common_bit(out.outcodes, room, triangles.vertex[0] + t, triangles.vertex[1] + t, triangles.vertex[2] + t, lanes);
    for (int first = 0; first < lanes; first += width) {
      const std::uint32_t bits = near >> first & first_lanes(lanes - first);
      found += write_lanes(bits, t + first, out.triangle + found);
    }
  }
  if (found > 0) fill_pack(out.triangle[found - 1], out.triangle + found);
  return found;
}

template <Table kind>
void place_all(const ClusterTriangles& triangles, const float* xyz, int room, const float* offset, int count,
               const CandidateArrays& out, Box<float>& all) {
  Box<S> whole = Box<S>::empty();
  for (int k = 0; k < count; k += width) {
    TriangleOf<S> vertices;
    alignas(64) std::int32_t at[3][width];
    for (int c = 0; c < 3; ++c) look_up<kind>(triangles.vertex[c], triangles.count, out.triangle + k, at[c]);
    const auto found = look_up<kind, 3, 3>({xyz, xyz + room, xyz + 2 * room}, room, {at[0], at[1], at[2]});
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c) store(vertices[c][i] = found[i][c] + S(offset[i]), out.vertices[3 * c + i] + k);
    Box<S> box;
    for (int i = 0; i < 3; ++i) {
      const S &x = vertices[0][i], &y = vertices[1][i], &z = vertices[2][i];
      store(box.low[i] = min_of(min_of(x, y), z), out.box[i] + k);
      store(box.high[i] = max_of(max_of(x, y), z), out.box[3 + i] + k);
    }
    whole.merge(box);
  }
  for (int i = 0; i < 3; ++i)
    all.low[i] = std::experimental::hmin(whole.low[i]), all.high[i] = std::experimental::hmax(whole.high[i]);
}

REFITLAB_KERNEL void place(const ClusterTriangles& triangles, const float* xyz, int room, const float* offset, int count,
                           const CandidateArrays& out, Box<float>& all) {
  if (std::max(room, triangles.count) <= most_in_registers)
    place_all<Table::in_registers>(triangles, xyz, room, offset, count, out, all);
  else place_all<Table::in_memory>(triangles, xyz, room, offset, count, out, all);
}

// The sides of candidates' boxes. Where kernels hold a copy of these pointers, they need not load them again after each store.
using Sides = std::array<const float*, 6>;

Sides sides_of(const CandidateArrays& candidates) {
  Sides out;
  for (int i = 0; i < 6; ++i) out[i] = candidates.box[i];
  return out;
}

// Returns the lanes in which two boxes are not apart.
std::uint32_t meeting_lanes(const Box<S>& a, const Box<S>& b) {
#ifdef __AVX512F__
  // A comparison that is made in the lanes that the last one left needs no further operation on masks.
  __mmask16 lanes = 0xffff;
  for (int i = 0; i < 3; ++i) {
    lanes = _mm512_mask_cmp_ps_mask(lanes, static_cast<__m512>(a.high[i]), static_cast<__m512>(b.low[i]), _CMP_NLT_UQ);
    lanes = _mm512_mask_cmp_ps_mask(lanes, static_cast<__m512>(b.high[i]), static_cast<__m512>(a.low[i]), _CMP_NLT_UQ);
  }
  return lanes;
#else
  return lane_bits(!are_apart(a, b));
#endif
}

// Returns the lanes whose boxes are not apart from the given one.
std::uint32_t meeting_lanes(const Sides& sides, int first, const Box<S>& box) {
  const auto side = [&](int i) { return load(sides[i] + first); };
  return meeting_lanes(Box<S>{{side(0), side(1), side(2)}, {side(3), side(4), side(5)}}, box);
}

Box<S> broadcast(const Box<float>& box) {
  Box<S> out;
  for (int i = 0; i < 3; ++i) out.low[i] = S(box.low[i]), out.high[i] = S(box.high[i]);
  return out;
}

REFITLAB_KERNEL int keep(int count, const Box<float>& box, const CandidateArrays& candidates) {
  const Sides sides = sides_of(candidates);
  const Box<S> all = broadcast(box);
  int kept = 0;
  for (int first = 0; first < count; first += width) {
    const std::uint32_t lanes = meeting_lanes(sides, first, all) & first_lanes(count - first);
    for (float* side : candidates.box) keep_lanes(lanes, side + first, side + kept);
    for (float* coordinate : candidates.vertices) keep_lanes(lanes, coordinate + first, coordinate + kept);
    kept += keep_lanes(lanes, candidates.triangle + first, candidates.triangle + kept);
  }
  return kept;
}

// Calls with(k) for the candidates whose boxes meet the given one.
template <class With>
void for_each_near(const Sides& sides, int count, const Box<S>& box, const With& with) {
  constexpr int at_once = 32 * width;
  std::int32_t near[at_once];
  for (int begin = 0; begin < count; begin += at_once) {
    const int end = std::min(count, begin + at_once);
    int found = 0;
    for (int first = begin; first < end; first += width)
      found += write_lanes(meeting_lanes(sides, first, box) & first_lanes(end - first), first, near + found);
    for (int n = 0; n < found; ++n) with(near[n]);
  }
}

REFITLAB_KERNEL int meeting(const CandidateArrays& a, int count_a, const CandidateArrays& b, int begin, int end, float margin,
                            CandidatePair* pairs) {
  const Sides sides = sides_of(a);
  int found = 0;
  for (int block = begin; block < end; block += width) {
    Box<S> own, all;
    for (int i = 0; i < 3; ++i) {
      own.low[i] = load(b.box[i] + block) - S(margin), own.high[i] = load(b.box[3 + i] + block) + S(margin);
      const auto is_ordered = own.low[i] <= own.high[i];  // a NaN is not
      all.low[i] = S(std::experimental::hmin(choose(is_ordered, own.low[i], S(-infinity))));
      all.high[i] = S(std::experimental::hmax(choose(is_ordered, own.high[i], S(infinity))));
    }
    const std::uint32_t valid = first_lanes(end - block);
    for_each_near(sides, count_a, all, [&](int k) {
      const Box<S> other{{S(sides[0][k]), S(sides[1][k]), S(sides[2][k])}, {S(sides[3][k]), S(sides[4][k]), S(sides[5][k])}};
      found += write_lanes(meeting_lanes(own, other) & valid, pair_of(k, block), pairs + found);
    });
  }
  if (found > 0) fill_pack(pairs[found - 1], pairs + found);
  return found;
}

// Returns the vertices of one candidate in each lane.
template <Table kind>
TriangleOf<S> vertices_of(const CandidateArrays& candidates, int count, const std::int32_t* which) {
  std::array<const float*, 9> coordinates;
  for (int i = 0; i < 9; ++i) coordinates[i] = candidates.vertices[i];
  const auto found = look_up<kind, 9, 1>(coordinates, count, {which});
  TriangleOf<S> out;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) out[c][i] = found[3 * c + i][0];
  return out;
}

template <Table kind>
void filter_all(const CandidateArrays& a, int count_a, const CandidateArrays& b, int count_b, const CandidatePair* pairs,
                int count, float slack, CandidatePair* meet, int& meet_count, CandidatePair* unknown, int& unknown_count) {
  const NearVertices<S> vertices{S(2 * slack)};
  for (int from = 0; from < count; from += width) {
    alignas(64) std::int32_t first[width], second[width];
    for (int lane = 0; lane < width; ++lane)
      first[lane] = first_of(pairs[from + lane]), second[lane] = second_of(pairs[from + lane]);
    const auto filtered =
        filter_lanes<S, NearVertices<S>>(vertices_of<kind>(a, count_a, first), vertices_of<kind>(b, count_b, second), vertices);
    const std::uint32_t valid = first_lanes(count - from), apart = lane_bits(filtered.are_apart);
    const std::uint32_t meeting = lane_bits(filtered.meet) & ~apart & valid, open = ~(meeting | apart) & valid;
    meet_count += keep_lanes(meeting, pairs + from, meet + meet_count);
    unknown_count += keep_lanes(open, pairs + from, unknown + unknown_count);
  }
}

REFITLAB_KERNEL void filter(const CandidateArrays& a, int count_a, const CandidateArrays& b, int count_b,
                            const CandidatePair* pairs, int count, float slack, CandidatePair* meet, int& meet_count,
                            CandidatePair* unknown, int& unknown_count) {
  if (std::max(count_a, count_b) <= most_in_registers)
    filter_all<Table::in_registers>(a, count_a, b, count_b, pairs, count, slack, meet, meet_count, unknown, unknown_count);
  else filter_all<Table::in_memory>(a, count_a, b, count_b, pairs, count, slack, meet, meet_count, unknown, unknown_count);
}

REFITLAB_KERNEL void filter_by_slopes(const TrianglePairBlock* blocks, int count, Filtered* answers) {
  for (int from = 0; from < count; from += width) {
    const TrianglePairBlock& block = blocks[from / Lanes<float>::count];
    const auto of_block = [&](const Lanes<float>& lanes) { return load(lanes.lane.data() + from % Lanes<float>::count); };
    TriangleOf<S> first, second;
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < 3; ++i)
        first[c][i] = of_block(block.first[3 * c + i]), second[c][i] = of_block(block.second[3 * c + i]);
    const NearVerticesBySlopes<S> vertices{{S(2) * of_block(block.slack)}};
    const auto filtered = filter_lanes<S, NearVerticesBySlopes<S>>(first, second, vertices);
    const std::uint32_t apart = lane_bits(filtered.are_apart), meet = lane_bits(filtered.meet);
    for (int lane = 0; lane < std::min(width, count - from); ++lane)
      answers[from + lane] = apart >> lane & 1 ? Filtered::apart : meet >> lane & 1 ? Filtered::meet : Filtered::unknown;
  }
}

}  // namespace

const ClusterPairKernels cluster_pair_kernels{overlaps, cull, place, keep, meeting, filter, filter_by_slopes};

}  // namespace refitlab::REFITLAB_TARGET
