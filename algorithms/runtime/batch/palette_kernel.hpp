// SPDX-License-Identifier: MIT
// The kernel of PalettePacks makes the frame's data of eight joint-sets at a time, which have the same number of joints.
#pragma once

#include <cstdint>

#include "algorithms/runtime/batch/float_palette.hpp"
#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

inline constexpr int palette_lanes = 8;
inline constexpr int most_palette_joints = 4;  // of a joint-set in a pack

// A PaletteSource is what the data of a joint-set are made from, besides the pose.
struct alignas(64) PaletteSource {
  // These are the prior of the rotation center, m of the joint-set, the largest |v - m| of its vertices (float_palette.hpp), and
  // an unused one.
  double numbers[8];
  std::int32_t joint[most_palette_joints], joint_count;  // 0 if it has more than a pack takes
  std::int32_t first_slot;                               // where its joints' data go
};

// A PalettePack has the joint-sets of its lanes. Lanes beyond the last joint-set repeat it, and nothing is written for them.
struct PalettePack {
  std::int32_t set[palette_lanes];
  int count;  // of joint-sets
};

// PaletteNumbers has the arrays of a SkinningPalette as numbers.
struct PaletteNumbers {
  double* rotation_centers;  // 3 each
  double* transforms;        // 8 each: a quaternion, a translation, an unused one
  double* center_images;     // 3 each
  double* duals;             // 4 each
};

// sources are by joint-set. pose is by joint, in the layout of the transforms. If are_centers_fixed, the priors are the rotation
// centers.
using PaletteRun = void (*)(const PaletteSource* sources, const PalettePack& pack, int joints, bool are_centers_fixed,
                            const double* pose, const PaletteNumbers& out);

// Does the same for skinning in float. out is by joint-set.
using FloatPaletteRun = void (*)(const PaletteSource* sources, const PalettePack& pack, int joints, bool are_centers_fixed,
                                 const double* pose, const FloatPlacement& at, FloatPaletteEntry* out);

struct PaletteKernels {
  PaletteRun run;
  FloatPaletteRun run_float;
};

namespace baseline {
extern const PaletteKernels palette_kernels;
}
namespace avx2 {
extern const PaletteKernels palette_kernels;
}
namespace avx512 {
extern const PaletteKernels palette_kernels;
}

const PaletteKernels& palette_kernels(Target target);

}  // namespace refitlab
