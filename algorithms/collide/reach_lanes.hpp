// For the kernels of Reach: the numbers of all joints, and the bounds of a pack's lanes.
#pragma once

#include <cstddef>
#include <limits>

#include "algorithms/collide/reach_kernel.hpp"
#include "algorithms/packs/look_up.hpp"
#include "algorithms/packs/transpose.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
using Point = Vec<S, 3>;
using Transform = RigidTransform<S>;
constexpr int width = static_cast<int>(S::size());
static_assert(reach_lanes % width == 0);

constexpr float infinity = std::numeric_limits<float>::infinity();
// A dot product that is greater is positive in exact numbers too.
constexpr float positive = 1e-5f;

S load(const float* lanes) { return S(lanes, std::experimental::vector_aligned); }
[[gnu::always_inline]] inline S smaller(const S& a, const S& b) { return std::experimental::min(a, b); }
[[gnu::always_inline]] inline S larger(const S& a, const S& b) { return std::experimental::max(a, b); }

// Number i of all joints is at numbers + i * room(). few: they are at most 32.
template <bool few>
struct Joints {
  float* numbers;
  int count, any_room;

  int room() const { return few ? 32 : any_room; }
  float* number(int i) const { return numbers + i * room(); }

  // From eight doubles a joint. Lanes behind the last joint repeat it.
  void read(const double* posture) const {
    int first = 0;
    for (; first + 8 <= count; first += 8) read_block<true>(posture, first);
    for (; first < (count + 15) / 16 * 16; first += 8) read_block<false>(posture, first);
  }
  Transform lanes(int first) const {
    Transform out;
    for (int i = 0; i < 4; ++i) out.rotation[i] = load(number(i) + first);
    for (int i = 0; i < 3; ++i) out.translation[i] = load(number(4 + i) + first);
    return out;
  }
  void put_lanes(int first, const Transform& t) const {
    for (int i = 0; i < 4; ++i) t.rotation[i].copy_to(number(i) + first, std::experimental::vector_aligned);
    for (int i = 0; i < 3; ++i) t.translation[i].copy_to(number(4 + i) + first, std::experimental::vector_aligned);
  }
  Transform of_lanes(const std::int32_t* joint) const {
    Transform out;
    for (int i = 0; i < 4; ++i) out.rotation[i] = look_up<few>(number(i), count, joint);
    for (int i = 0; i < 3; ++i) out.translation[i] = look_up<few>(number(4 + i), count, joint);
    return out;
  }

 private:
  template <bool whole>
  [[gnu::always_inline]] void read_block(const double* posture, int first) const {
    using Doubles = EightOf<double>::Row;
    using Floats = EightOf<float>::Row;
    Floats rows[8];
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) {
      const std::ptrdiff_t joint = whole || first + i < count ? first + i : count - 1;
      rows[i] = __builtin_convertvector(*reinterpret_cast<const Doubles*>(posture + 8 * joint), Floats);
    }
    transpose<float>(rows, numbers + first, room());
  }
};

// The lanes from first on: their bounds, and which of them are unbounded, to merge(low, high, is_unbounded). An
// unbounded one is empty, from infinity to minus infinity. off: the share of A for what is off, see reach_kernel.hpp.
template <int slots, bool strays, bool few, class Merge>
[[gnu::always_inline]] inline void bound_lanes(const ReachPack& pack, int first, const Joints<few>& joints, float off,
                                               const Merge& merge) {
  const Point f(load(pack.center[0] + first), load(pack.center[1] + first), load(pack.center[2] + first));
  const Transform joint = joints.of_lanes(pack.joint[0] + first);
  const Point image = apply(joint, f);
  Point low = image, high = image, sum = Point::Constant(S(0));
  Quaternion<S> rotations[slots] = {joint.rotation};
  S squares(0), c(1);
#pragma GCC unroll 8
  for (int k = 1; k < slots; ++k) {
    const Transform other = joints.of_lanes(pack.joint[k] + first);
    const Point at = apply(other, f);
    for (int i = 0; i < 3; ++i) low[i] = smaller(low[i], at[i]), high[i] = larger(high[i], at[i]);
    if constexpr (strays) {
      const Point y = at - image;
      sum = sum + y;
      squares = squares + squared_norm(y);
      const S cosine = dot(rotations[0], other.rotation);
      for (int i = 0; i < 4; ++i)  // the skinning's sign
        rotations[k][i] = choose(cosine < S(0), S(-other.rotation[i]), other.rotation[i]);
      c = smaller(c, abs(cosine));
#pragma GCC unroll 8
      for (int l = 1; l < k; ++l) c = smaller(c, dot(rotations[l], rotations[k]));
    }
  }
  S reach = load(pack.radius + first);
  auto is_unbounded = c < c;
  if constexpr (strays) {
    is_unbounded = !(c > S(positive));
    const S squared_a = load(pack.joint_count + first) * squares - squared_norm(sum);
    const S a = root(larger(squared_a, S(0))) + load(pack.unsolved + first);
    const S share = S(0.75f) * root(larger(S(1) - c, S(0))) + S(off);
    reach = reach + choose(is_unbounded, S(-infinity), share * a);
  }
  for (int i = 0; i < 3; ++i) low[i] = low[i] - reach, high[i] = high[i] + reach;
  merge(low, high, is_unbounded);
}

}  // namespace
}  // namespace refitlab::REFITLAB_TARGET
