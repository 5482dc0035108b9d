// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/float_skin_kernel.hpp"

#include <algorithm>

#include "algorithms/runtime/batch/float_skin_joints.hpp"
#include "algorithms/runtime/packs/pack.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
using Point = Vec<S, 3>;
constexpr int width = static_cast<int>(S::size());

S load(const Lanes<float>& lanes, int first) { return S(lanes.lane.data() + first, std::experimental::vector_aligned); }

template <int N>
void skin_run(const FloatRun& run, const Lanes<float>* data, const FloatPaletteEntry& entry, int room, float* out) {
  for (int v = 0; v < run.vertex_count; v += width, out += width) {
    const Lanes<float>* const block = data + (2 + N) * (v / Lanes<float>::count);
    const int first = v % Lanes<float>::count;
    const FloatJointSet<S, N> joints(entry);  // for each pack, since most runs have few, and registers do not hold it
    const Point image = joints.skin({load(block[0], first), load(block[1], first), load(block[2], first)},
                                    [&](int j) { return load(block[3 + j], first); });
    for (int i = 0; i < 3; ++i) image[i].copy_to(out + i * room, std::experimental::element_aligned);
  }
}

REFITLAB_KERNEL float skin(const FloatRun* runs, int run_count, const Lanes<float>* data, const FloatPaletteEntry* palette,
                           int room, float* out, Box<float>& box) {
  float slack = 0;
  float* const begin = out;
  // Each run is written over the padding of the one before.
  for (const FloatRun* run = runs; run != runs + run_count; out += run++->vertex_count) {
    const FloatPaletteEntry& entry = palette[run->joint_set];
    slack = max_of(slack, entry.slack);
    switch (run->joint_count) {
      case 1: skin_run<1>(*run, data + run->first_data, entry, room, out); break;
      case 2: skin_run<2>(*run, data + run->first_data, entry, room, out); break;
      case 3: skin_run<3>(*run, data + run->first_data, entry, room, out); break;
      default: skin_run<4>(*run, data + run->first_data, entry, room, out);
    }
  }
  // While this skins, no register is left for a box. The last pack goes back over the one before, and if it is the only one, padding
  // follows.
  Box<S> all = Box<S>::empty();
  const int count = static_cast<int>(out - begin);
  for (int v = 0; v < count; v += width) {
    const int at = std::max(0, std::min(v, count - width));
    const auto coordinate = [&](int i) { return S(begin + i * room + at, std::experimental::element_aligned); };
    all.merge({coordinate(0), coordinate(1), coordinate(2)});
  }
  for (int i = 0; i < 3; ++i)
    box.low[i] = std::experimental::hmin(all.low[i]), box.high[i] = std::experimental::hmax(all.high[i]);
  return slack;
}

}  // namespace

const FloatSkin float_skin = skin;

}  // namespace refitlab::REFITLAB_TARGET
