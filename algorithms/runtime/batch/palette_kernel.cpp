// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/palette_kernel.hpp"

#include <cstring>

#include "algorithms/runtime/packs/pack.hpp"
#include "algorithms/runtime/packs/transpose.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"
#include "algorithms/runtime/skinning/skinning_palette.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<double>;
constexpr int width = static_cast<int>(S::size());
static_assert(palette_lanes % width == 0);

// Eight packs' worth of a record of eight numbers a lane: column i holds number i of every lane.
struct Columns {
  alignas(64) double of[8][palette_lanes];

  S load(int i, int first) const { return S(of[i] + first, std::experimental::vector_aligned); }
  void clear(int i) {
    for (double& x : of[i]) x = 0;
  }
  template <int D>
  void store(int i, int first, const Vec<S, D>& v) {
    for (int k = 0; k < D; ++k) v[k].copy_to(of[i + k] + first, std::experimental::vector_aligned);
  }
};

// From record index[lane] of an array.
void gather(const double* records, const std::int32_t* index, Columns& out) {
  const double* rows[8];
  for (int lane = 0; lane < 8; ++lane) rows[lane] = records + 8 * index[lane];
  transpose<double>(rows, out.of[0], palette_lanes);
}
// The lanes' records, one after the other.
void to_rows(const Columns& columns, double* rows) {
  const double* from[8];
  for (int i = 0; i < 8; ++i) from[i] = columns.of[i];
  transpose<double>(from, rows, 8);
}

template <int N>
void run_joints(const PalettePack* packs, int count, bool are_centers_fixed, const double* pose, const PaletteNumbers& out) {
  Columns posed[N], centers, images[N];  // images: C_j r_c, an unused one, then the dual part
  for (int j = 0; j < N; ++j) images[j].clear(3);
  for (int i = 3; i < 8; ++i) centers.clear(i);
  for (const PalettePack* pack = packs; pack != packs + count; ++pack) {
    for (int j = 0; j < N; ++j) gather(pose, pack->joint[j], posed[j]);
    for (int first = 0; first < palette_lanes; first += width) {
      RigidTransform<S> transforms[N];
      for (int j = 0; j < N; ++j) {
        for (int i = 0; i < 4; ++i) transforms[j].rotation[i] = posed[j].load(i, first);
        for (int i = 0; i < 3; ++i) transforms[j].translation[i] = posed[j].load(4 + i, first);
      }
      make_signs_consistent<S>(transforms);
      Vec<S, 3> center;
      for (int i = 0; i < 3; ++i) center[i] = S(pack->prior[i] + first, std::experimental::vector_aligned);
      if (N > 1 && !are_centers_fixed) center = rotation_center<S>(transforms, center);
      centers.store(0, first, center);
      for (int j = 0; j < N; ++j) {
        posed[j].store(0, first, transforms[j].rotation);
        images[j].store(0, first, apply(transforms[j], center));
        images[j].store(4, first, dual_part(transforms[j]));
      }
    }
    alignas(64) double rows[palette_lanes][8];
    to_rows(centers, rows[0]);
    for (int lane = 0; lane < palette_lanes; ++lane)
      std::memcpy(out.rotation_centers + 3 * pack->set[lane], rows[lane], 3 * sizeof(double));
    for (int j = 0; j < N; ++j) {
      to_rows(posed[j], rows[0]);
      for (int lane = 0; lane < palette_lanes; ++lane)
        std::memcpy(out.transforms + 8 * (pack->first_slot[lane] + j), rows[lane], 8 * sizeof(double));
      to_rows(images[j], rows[0]);
      for (int lane = 0; lane < palette_lanes; ++lane) {
        const int slot = pack->first_slot[lane] + j;
        std::memcpy(out.center_images + 3 * slot, rows[lane], 3 * sizeof(double));
        std::memcpy(out.duals + 4 * slot, rows[lane] + 4, 4 * sizeof(double));
      }
    }
  }
}

REFITLAB_KERNEL void run(const PalettePack* packs, int count, int joints, bool are_centers_fixed, const double* pose,
                         const PaletteNumbers& out) {
  switch (joints) {
    case 1: return run_joints<1>(packs, count, are_centers_fixed, pose, out);
    case 2: return run_joints<2>(packs, count, are_centers_fixed, pose, out);
    case 3: return run_joints<3>(packs, count, are_centers_fixed, pose, out);
    default: return run_joints<4>(packs, count, are_centers_fixed, pose, out);
  }
}

}  // namespace

const PaletteRun palette_run = run;

}  // namespace refitlab::REFITLAB_TARGET
