// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/palette_kernel.hpp"

#include <cstring>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "algorithms/runtime/packs/transpose.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<double>;
constexpr int width = static_cast<int>(S::size());
static_assert(palette_lanes % width == 0);

// There is a record of eight numbers for each lane. Column i holds number i of every lane.
struct Columns {
  alignas(64) double of[8][palette_lanes];

  S load(int i, int first) const { return S(of[i] + first, std::experimental::vector_aligned); }
  template <int D>
  void store(int i, int first, const Vec<S, D>& v) {
    for (int k = 0; k < D; ++k) v[k].copy_to(of[i + k] + first, std::experimental::vector_aligned);
  }
  // Clears what is not stored, but transposed with the rest: the columns from `columns` on, and registers behind `lanes`.
  void clear_unused(int columns, int lanes) {
    for (int i = 0; i < 8; ++i)
      for (int first = i < columns ? (lanes + width - 1) / width * width : 0; first < palette_lanes; first += width)
        S(0).copy_to(of[i] + first, std::experimental::vector_aligned);
  }
};

// Writes the lanes' records, one after the other.
void to_rows(const Columns& columns, double* rows) {
  const double* from[8];
  for (int i = 0; i < 8; ++i) from[i] = columns.of[i];
  transpose<width>(from, rows, 8);
}

// Gathers the record that of_lane(lane) points to into each lane.
template <class OfLane>
void gather(const OfLane& of_lane, Columns& out) {
  const double* rows[8];
  for (int lane = 0; lane < 8; ++lane) rows[lane] = of_lane(lane);
  transpose<width>(rows, out.of[0], palette_lanes);
}

// PackLanes has the sources of a pack, and the joints of its lanes as they are posed.
template <int N>
struct PackLanes {
  Columns sources, posed[N];

  PackLanes(const PaletteSource* all, const PalettePack& pack, const double* pose) {
    const auto source = [&](int lane) -> const PaletteSource& { return all[pack.set[lane]]; };
    gather([&](int lane) { return source(lane).numbers; }, sources);
    for (int j = 0; j < N; ++j) gather([&](int lane) { return pose + 8 * source(lane).joint[j]; }, posed[j]);
  }

  Vec<S, 3> prior(int first) const { return {sources.load(0, first), sources.load(1, first), sources.load(2, first)}; }
  Vec<S, 3> middle(int first) const { return {sources.load(3, first), sources.load(4, first), sources.load(5, first)}; }
  S radius(int first) const { return sources.load(6, first); }
};

// JointLanes holds what skinning prepares for the joints of each lane.
template <int N>
struct JointLanes {
  RigidTransform<S> transforms[N];
  Vec<S, 3> center, images[N];

  JointLanes(const PackLanes<N>& of_pack, int first, bool is_center_fixed) {
    for (int j = 0; j < N; ++j) {
      for (int i = 0; i < 4; ++i) transforms[j].rotation[i] = of_pack.posed[j].load(i, first);
      for (int i = 0; i < 3; ++i) transforms[j].translation[i] = of_pack.posed[j].load(4 + i, first);
    }
    make_signs_consistent<S>(transforms);
    center = of_pack.prior(first);
    if (N > 1 && !is_center_fixed) center = rotation_center<S>(transforms, center);
    for (int j = 0; j < N; ++j) images[j] = apply(transforms[j], center);
  }
};

template <int N>
void run_joints(const PaletteSource* sources, const PalettePack& pack, bool are_centers_fixed, const double* pose,
                const PaletteNumbers& out) {
  PackLanes<N> of_pack(sources, pack, pose);
  Columns centers, images[N];  // images: C_j r_c, then the dual part
  for (int first = 0; first < pack.count; first += width) {
    const JointLanes<N> lanes(of_pack, first, are_centers_fixed);
    centers.store(0, first, lanes.center);
    for (int j = 0; j < N; ++j) {
      of_pack.posed[j].store(0, first, lanes.transforms[j].rotation);
      images[j].store(0, first, lanes.images[j]);
      images[j].store(3, first, dual_part(lanes.transforms[j]));
    }
  }
  centers.clear_unused(3, pack.count);
  for (Columns& of_joint : images) of_joint.clear_unused(7, pack.count);
  alignas(64) double rows[palette_lanes][8];
  to_rows(centers, rows[0]);
  for (int lane = 0; lane < pack.count; ++lane)
    std::memcpy(out.rotation_centers + 3 * pack.set[lane], rows[lane], 3 * sizeof(double));
  for (int j = 0; j < N; ++j) {
    to_rows(of_pack.posed[j], rows[0]);
    for (int lane = 0; lane < pack.count; ++lane)
      std::memcpy(out.transforms + 8 * (sources[pack.set[lane]].first_slot + j), rows[lane], 8 * sizeof(double));
    to_rows(images[j], rows[0]);
    for (int lane = 0; lane < pack.count; ++lane) {
      const int slot = sources[pack.set[lane]].first_slot + j;
      std::memcpy(out.center_images + 3 * slot, rows[lane], 3 * sizeof(double));
      std::memcpy(out.duals + 4 * slot, rows[lane] + 3, 4 * sizeof(double));
    }
  }
}

REFITLAB_KERNEL void run(const PaletteSource* sources, const PalettePack& pack, int joints, bool are_centers_fixed,
                         const double* pose, const PaletteNumbers& out) {
  switch (joints) {
    case 1: return run_joints<1>(sources, pack, are_centers_fixed, pose, out);
    case 2: return run_joints<2>(sources, pack, are_centers_fixed, pose, out);
    case 3: return run_joints<3>(sources, pack, are_centers_fixed, pose, out);
    default: return run_joints<4>(sources, pack, are_centers_fixed, pose, out);
  }
}

// Writes the records as floats, with a row of eight for each lane.
void to_float_rows(const Columns& columns, float (*rows)[8]) {
  const auto read = [&](int column, int lane, Row<float, 4>& four) { read_floats(columns.of[column] + lane, four); };
  transpose_records<8>(read, rows[0], 8);
}

// Returns the slack of float_palette.hpp. offset is r, and squared_image is T^2.
template <int N>
S float_slack(const JointLanes<N>& lanes, const Vec<S, 3>& offset, const S& radius, const S& squared_image,
              const FloatPlacement& at) {
  constexpr double u = 0x1p-24 * float_slack_and_more;
  const S length = radius + norm(offset), image = root(squared_image);
  const S slack = (length * S(float_slack_per_length(N) * u) + image * S(float_slack_per_image(N) * u)) +
                  length * S(error_of_rotate(at.defect)) + S(at.lost + least_float_slack);
  const S squared_blend = least_squared_blend<S>(std::span(lanes.transforms));
  const auto holds =
      squared_blend > S(1.000001 / (largest_float_kappa * largest_float_kappa)) && length + image <= S(largest_float_length);
  return choose(holds, slack, S(infinite));
}

template <int N>
void run_float_joints(const PaletteSource* sources, const PalettePack& pack, bool are_centers_fixed, const double* pose,
                      const FloatPlacement& at, FloatPaletteEntry* out) {
  const PackLanes<N> of_pack(sources, pack, pose);
  RigidTransform<S> placement;
  for (int i = 0; i < 4; ++i) placement.rotation[i] = S(at.rotation[i]);
  for (int i = 0; i < 3; ++i) placement.translation[i] = S(at.translation[i]);
  Columns centers, placed[N];  // centers: r and the slack
  Columns rest;                // of one joint: the last row of the matrix
  for (int first = 0; first < pack.count; first += width) {
    const JointLanes<N> lanes(of_pack, first, are_centers_fixed);
    const Vec<S, 3> offset = lanes.center - of_pack.middle(first);
    RigidTransform<S> of_first;  // q_0 and c_0
    S squared_image;
    for (int j = 0; j < N; ++j) {
      const Quaternion<S> turn = multiply(placement.rotation, lanes.transforms[j].rotation);
      const Vec<S, 3> image = apply(placement, lanes.images[j]);
      const S squared = squared_norm(image);
      if (j == 0) of_first = {turn, image}, squared_image = squared;
      else squared_image = max_of(squared_image, squared);
      const Quaternion<S> turn_from = turn - of_first.rotation;
      const Vec<S, 3> image_from = image - of_first.translation;
      placed[j].store(0, first, j == 0 ? turn : turn_from);
      placed[j].store(4, first, j == 0 ? image : image_from);
    }
    if constexpr (N == 1) {
      const S scale = S(1) / squared_norm(of_first.rotation);
      Vec<S, 3> column[3];
      for (int k = 0; k < 3; ++k) {
        Vec<S, 3> unit = Vec<S, 3>::Constant(S(0));
        unit[k] = S(1);
        column[k] = rotate_scaled(of_first.rotation, unit) * scale;
      }
      const Vec<S, 3> end = of_first.translation - (column[0] * offset[0] + column[1] * offset[1] + column[2] * offset[2]);
      for (int i = 0; i < 2; ++i) {
        for (int k = 0; k < 3; ++k) column[k][i].copy_to(placed[0].of[4 * i + k] + first, std::experimental::vector_aligned);
        end[i].copy_to(placed[0].of[4 * i + 3] + first, std::experimental::vector_aligned);
      }
      for (int k = 0; k < 3; ++k) column[k][2].copy_to(rest.of[k] + first, std::experimental::vector_aligned);
      end[2].copy_to(rest.of[3] + first, std::experimental::vector_aligned);
    }
    centers.store(0, first, offset);
    float_slack(lanes, offset, of_pack.radius(first), squared_image, at)
        .copy_to(centers.of[3] + first, std::experimental::vector_aligned);
  }
  centers.clear_unused(4, pack.count);
  for (Columns& of_joint : placed) of_joint.clear_unused(N == 1 ? 8 : 7, pack.count);
  alignas(64) float rows[palette_lanes][8];
  to_float_rows(centers, rows);
  for (int lane = 0; lane < pack.count; ++lane) std::memcpy(out[pack.set[lane]].center, rows[lane], 4 * sizeof(float));
  for (int j = 0; j < N; ++j) {
    to_float_rows(placed[j], rows);
    for (int lane = 0; lane < pack.count; ++lane) {
      FloatPaletteEntry& entry = out[pack.set[lane]];
      std::memcpy(N == 1 ? entry.more[0] : j == 0 ? entry.first : entry.more[j - 1], rows[lane], sizeof rows[lane]);
    }
  }
  if constexpr (N == 1) {
    rest.clear_unused(4, pack.count);
    to_float_rows(rest, rows);
    for (int lane = 0; lane < pack.count; ++lane) std::memcpy(out[pack.set[lane]].more[1], rows[lane], sizeof rows[lane]);
  }
}

REFITLAB_KERNEL void run_float(const PaletteSource* sources, const PalettePack& pack, int joints, bool are_centers_fixed,
                               const double* pose, const FloatPlacement& at, FloatPaletteEntry* out) {
  switch (joints) {
    case 1: return run_float_joints<1>(sources, pack, are_centers_fixed, pose, at, out);
    case 2: return run_float_joints<2>(sources, pack, are_centers_fixed, pose, at, out);
    case 3: return run_float_joints<3>(sources, pack, are_centers_fixed, pose, at, out);
    default: return run_float_joints<4>(sources, pack, are_centers_fixed, pose, at, out);
  }
}

}  // namespace

const PaletteKernels palette_kernels{run, run_float};

}  // namespace refitlab::REFITLAB_TARGET
