// SPDX-License-Identifier: MIT
// BoxKernel makes the boxes around control points, a piece a lane. It is for the kernel, and for what derives its rounding errors
// (proptests/algorithms/float_budgets.cpp), which runs it in another number type.
#pragma once

#include <cstddef>
#include <limits>

#include "algorithms/runtime/collide/box_packs.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "algorithms/runtime/packs/transpose.hpp"
#include "lemmas/b1_rational_bezier_simplex.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

template <class Pack>
class BoxKernel {
  using Mask = typename Pack::mask_type;
  using Point = Vec<Pack, 3>;
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static constexpr int width = static_cast<int>(Pack::size());
  static_assert(box_lanes % width == 0);

 public:
  // Does what BoxKernels::bound says. rotation is a 3 x 3 matrix, row by row.
  static void run(const BoxPack* packs, std::size_t count, int joints, Skinning skinning, const float* slots,
                  const float* centers, const float* rotation, FlippedBox* boxes) {
    switch (joints) {
      case 1: return run_joints<1>(packs, count, skinning, slots, centers, rotation, boxes);
      case 2: return run_joints<2>(packs, count, skinning, slots, centers, rotation, boxes);
      case 3: return run_joints<3>(packs, count, skinning, slots, centers, rotation, boxes);
      default: return run_joints<4>(packs, count, skinning, slots, centers, rotation, boxes);
    }
  }

 private:
  template <int N>
  static void run_joints(const BoxPack* packs, std::size_t count, Skinning skinning, const float* slots, const float* centers,
                         const float* rotation, FlippedBox* boxes) {
    for (const BoxPack* pack = packs; pack != packs + count; ++pack)
      for (int first = 0; first < box_lanes; first += width) {
        const BoxKernel lanes{*pack, first, slots, centers, rotation};
        switch (skinning) {
          case Skinning::linear: merge(lanes.template linear<N>(), *pack, first, boxes); break;
          case Skinning::dual_quaternion: merge(lanes.template dual_quaternion<N>(), *pack, first, boxes); break;
          default: merge(lanes.template spherical<N>(), *pack, first, boxes);
        }
      }
  }

  static void merge(Box<Pack> box, const BoxPack& pack, int first, FlippedBox* boxes) {
    for (int i = 0; i < 3; ++i) {
      // If coordinates beyond the range of float make a side undefined, the vertices may be anywhere.
      const Mask is_undefined = !(box.low[i] <= box.high[i]);
      box.low[i] = choose(is_undefined, Pack(-infinity), box.low[i]);
      box.high[i] = choose(is_undefined, Pack(infinity), box.high[i]);
    }
    merge_lanes(box, pack.target + first, boxes);
  }

  Pack load(const float* lanes) const { return Pack(lanes + first, std::experimental::element_aligned); }
  // Each lane has the eight floats of record index[lane] of an array.
  struct Records {
    alignas(64) float of[8][width];
    Pack operator[](int i) const { return Pack(of[i], std::experimental::vector_aligned); }
    Quaternion<Pack> quaternion(int i) const { return {(*this)[i], (*this)[i + 1], (*this)[i + 2], (*this)[i + 3]}; }
    Point point(int i) const { return {(*this)[i], (*this)[i + 1], (*this)[i + 2]}; }
  };
  Records gather(const float* from, const std::int32_t* index) const {
    Records out;
    const auto read = [&](int lane, int i, Row<float, 4>& four) { read_row(from + 8 * index[first + lane] + i, four); };
    transpose_records<width>(read, out.of[0], width);
    return out;
  }
  Records slot(int joint) const { return gather(slots, pack.slot[joint]); }
  Point reference_center() const { return {load(pack.center[0]), load(pack.center[1]), load(pack.center[2])}; }
  Point turned(const Point& p) const {
    const auto coordinate = [&](const float* row) { return dot(p, Point(Pack(row[0]), Pack(row[1]), Pack(row[2]))); };
    return {coordinate(rotation), coordinate(rotation + 3), coordinate(rotation + 6)};
  }
  static Pack size(const Point& p) { return abs(p[0]) + abs(p[1]) + abs(p[2]); }

  // Replaces x_k by sum low_i x_i + rest x_k for each weight vertex k.
  template <int N, class Value>
  void blend_at_weight_vertices(Value (&x)[N]) const {
    Value low = x[0] * load(pack.low[0]);
    for (int i = 1; i < N; ++i) low = low + x[i] * load(pack.low[i]);
    const Pack rest = load(pack.rest);
    for (int k = 0; k < N; ++k) x[k] = low + x[k] * rest;
  }

  template <int N>
  Box<Pack> spherical() const {
    Quaternion<Pack> q[N];
    Point r[N];
    Pack sizes(0.f);
    for (int i = 0; i < N; ++i) {
      const Records joint = slot(i);
      q[i] = joint.quaternion(0), r[i] = joint.point(4);
      sizes = max(sizes, size(r[i]));
    }
    blend_at_weight_vertices<N>(q), blend_at_weight_vertices<N>(r);
    const Point p0 = reference_center(), x = p0 - gather(centers, pack.set).point(0);
    MixedPair<Pack> mixed[N][N];
    for (int k = 0; k < N; ++k)
      for (int l = 0; l <= k; ++l) mixed[k][l] = mix_rotations(q[k], q[l], x);
    const Mask near = are_all_near<N>(mixed, near_of_degree_three);
    Box<Pack> box = Box<Pack>::empty(), anyhow = box;
    for (int j = 0; j < N; ++j) {
      anyhow.merge(turned(r[j]));
      for (int k = j; k < N; ++k)
        for (int l = k; l < N; ++l) {
          const ScaledPoint<Pack> point = spherical_control_point(mixed[k][j], mixed[l][k], mixed[l][j], r[j], r[k], r[l]);
          const Pack scale = Pack(1.f) / point.denominator;
          box.merge(turned(point.numerator * scale));
        }
    }
    const Pack radius = load(pack.radius);
    const Pack lost = (sizes + size(x) + size(p0) + radius) * lost_of_box;
    box.grow(radius + lost);
    anyhow.grow(size(x) + radius + lost);
    return choose(near, box, anyhow);
  }

  template <int N>
  Box<Pack> linear() const {
    const Point p = reference_center();
    Point r[N];
    Pack sizes = size(p);
    for (int i = 0; i < N; ++i) {
      const Records joint = slot(i);
      const Point at = joint.point(4);
      r[i] = rotate(joint.quaternion(0), p) + at;
      sizes = max(sizes, size(p) + size(at));
    }
    blend_at_weight_vertices<N>(r);
    Box<Pack> box = Box<Pack>::empty();
    for (int k = 0; k < N; ++k) box.merge(turned(r[k]));
    const Pack radius = load(pack.radius);
    box.grow(radius + (sizes + radius) * lost_of_box);
    return box;
  }

  template <int N>
  Box<Pack> dual_quaternion() const {
    const Point point = reference_center();
    Quaternion<Pack> q[N], d[N];
    Pack sizes = size(point);
    for (int i = 0; i < N; ++i) {
      const Records joint = slot(i);
      q[i] = joint.quaternion(0), d[i] = joint.quaternion(4);
      sizes = max(sizes, size(point) + (abs(d[i][0]) + abs(d[i][1]) + abs(d[i][2]) + abs(d[i][3])) * 2);
    }
    blend_at_weight_vertices<N>(q), blend_at_weight_vertices<N>(d);
    MixedPair<Pack> mixed[N][N];
    for (int k = 0; k < N; ++k)
      for (int l = 0; l <= k; ++l) mixed[k][l] = mix_motions<Pack>({q[k], d[k]}, {q[l], d[l]}, point);
    const Mask near = are_all_near<N>(mixed, near_of_degree_two);
    Box<Pack> box = Box<Pack>::empty();
    for (int k = 0; k < N; ++k)
      for (int l = 0; l <= k; ++l) box.merge(turned(mixed[k][l].numerator * (Pack(1.f) / mixed[k][l].weight)));
    const Pack radius = load(pack.radius);
    box.grow(radius + (sizes + radius) * lost_of_box);
    return choose(near, box, Box<Pack>::everything());
  }

  // Returns true in lanes where the weight vertices of every pair are near, and none is short.
  template <int N>
  static Mask are_all_near(const MixedPair<Pack> (&mixed)[N][N], double near) {
    Mask all(true);
    for (int k = 0; k < N; ++k) {
      const Pack& own = mixed[k][k].weight;
      all = all && own > 0.25f;
      for (int l = 0; l < k; ++l) all = all && are_near(mixed[k][l].weight, own, mixed[l][l].weight, near);
    }
    return all;
  }

  BoxKernel(const BoxPack& p, int f, const float* s, const float* c, const float* r)
      : pack(p),
        first(f),
        slots(s),
        centers(c),
        rotation(r) {}

  const BoxPack& pack;
  const int first;
  const float *slots, *centers, *rotation;
};

}  // namespace
}  // namespace refitlab::REFITLAB_TARGET
