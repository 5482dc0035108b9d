// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/float_skin_kernel.hpp"

#include "algorithms/runtime/packs/pack.hpp"
#include "lemmas/vocabulary/quaternion.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
using Point = Vec<S, 3>;
constexpr int width = static_cast<int>(S::size());

S load(const Lanes<float>& lanes, int first) { return S(lanes.lane.data() + first, std::experimental::vector_aligned); }

template <int D>
Vec<S, D> broadcast(const float* numbers) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S(numbers[i]);
  return out;
}

// A joint-set in every lane, of so many joints.
template <int N>
struct JointSet {
  Quaternion<S> rotation, rotation_from[N - 1];
  Point center, image, image_from[N - 1];

  explicit JointSet(const FloatPaletteEntry& entry)
      : rotation(broadcast<4>(entry.first)),
        center(broadcast<3>(entry.center)),
        image(broadcast<3>(entry.first + 4)) {
    for (int j = 0; j < N - 1; ++j)
      rotation_from[j] = broadcast<4>(entry.more[j]), image_from[j] = broadcast<3>(entry.more[j] + 4);
  }

  // The formula of float_palette.hpp.
  [[gnu::always_inline]] Point skin(const Point& p, const Lanes<float>* weights, int first) const {
    Quaternion<S> q = rotation;
    Point c = image;
    for (int j = 0; j < N - 1; ++j) {
      const S w = load(weights[j], first);
      for (int i = 0; i < 4; ++i) q[i] = w * rotation_from[j][i] + q[i];
      for (int i = 0; i < 3; ++i) c[i] = w * image_from[j][i] + c[i];
    }
    const Point x = p - center, v = imaginary(q), t = cross(v, x), tt = cross(v, t);
    const S scale = S(2.f) / squared_norm(q);
    Point out;
    for (int i = 0; i < 3; ++i) out[i] = scale * (q[0] * t[i] + tt[i]) + (x[i] + c[i]);
    return out;
  }
};

template <>
struct JointSet<1> {
  Vec<S, 4> row[3];

  explicit JointSet(const FloatPaletteEntry& entry) {
    for (int i = 0; i < 3; ++i) row[i] = broadcast<4>(entry.more[0] + 4 * i);
  }
  [[gnu::always_inline]] Point skin(const Point& p, const Lanes<float>*, int) const {
    Point out;
    for (int i = 0; i < 3; ++i) out[i] = row[i][0] * p[0] + (row[i][1] * p[1] + (row[i][2] * p[2] + row[i][3]));
    return out;
  }
};

template <int N>
void skin_run(const FloatRun& run, const Lanes<float>* data, const FloatPaletteEntry& entry, int stride, Lanes<float>* out,
              Box<S>& box) {
  const JointSet<N> joints(entry);
  for (int block = 0; block < run.block_count; ++block, data += 2 + N, ++out)
    for (int first = 0; first < Lanes<float>::count; first += width) {
      const Point image = joints.skin({load(data[0], first), load(data[1], first), load(data[2], first)}, data + 3, first);
      for (int i = 0; i < 3; ++i) image[i].copy_to(out[i * stride].lane.data() + first, std::experimental::vector_aligned);
      box.merge(image);
    }
}

REFITLAB_KERNEL float skin(const FloatRun* runs, int run_count, const Lanes<float>* data, const FloatPaletteEntry* palette,
                           int stride, Lanes<float>* out, Box<float>& box) {
  Box<S> all = Box<S>::empty();
  float slack = 0;
  for (const FloatRun* run = runs; run != runs + run_count; out += run++->block_count) {
    const FloatPaletteEntry& entry = palette[run->joint_set];
    slack = max_of(slack, entry.slack);
    switch (run->joint_count) {
      case 1: skin_run<1>(*run, data + run->first_data, entry, stride, out, all); break;
      case 2: skin_run<2>(*run, data + run->first_data, entry, stride, out, all); break;
      case 3: skin_run<3>(*run, data + run->first_data, entry, stride, out, all); break;
      default: skin_run<4>(*run, data + run->first_data, entry, stride, out, all);
    }
  }
  for (int i = 0; i < 3; ++i)
    box.low[i] = std::experimental::hmin(all.low[i]), box.high[i] = std::experimental::hmax(all.high[i]);
  return slack;
}

}  // namespace

const FloatSkin float_skin = skin;

}  // namespace refitlab::REFITLAB_TARGET
