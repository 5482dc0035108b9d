// SPDX-License-Identifier: MIT
// The kernel of spherical skinning in float takes a cluster's vertices, a vertex a lane, and makes the box around all of them.
#pragma once

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/batch/float_palette.hpp"
#include "algorithms/runtime/packs/lanes.hpp"
#include "algorithms/runtime/packs/targets.hpp"

namespace refitlab {

// A FloatRun is the vertices of one joint-set, padded to whole blocks of Lanes.
struct FloatRun {
  int joint_set, joint_count, vertex_count;
  int first_data;  // in data: of each block x, y, z of v - m, and the weights of all joints but the first
};

// out gets the x of all the runs' vertices, one run after the other without the padding, then y, then z, room apart. Padding of the
// last run may be written, too, and room is for it. box becomes the box around all of them. Returns the largest slack of the runs'
// palettes, which must be finite.
using FloatSkin = float (*)(const FloatRun* runs, int run_count, const Lanes<float>* data, const FloatPaletteEntry* palette,
                            int room, float* out, Box<float>& box);

namespace baseline {
extern const FloatSkin float_skin;
}
namespace avx2 {
extern const FloatSkin float_skin;
}
namespace avx512 {
extern const FloatSkin float_skin;
}

FloatSkin float_skin(Target target);

}  // namespace refitlab
