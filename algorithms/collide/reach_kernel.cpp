#include "algorithms/collide/reach_kernel.hpp"

#include <cstddef>
#include <cstring>
#include <limits>

#include "algorithms/packs/four.hpp"
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
// Where rotation_center takes a direction as undetermined, A lacks up to 2e-3 of f's distance from the prior for each
// joint. And the center itself may be 3e4 A away, where 2e-6 of it are the most of this share of A.
constexpr float off_unit = 0x1p-4f;
// A dot product that is greater is positive in exact numbers too.
constexpr float positive = 1e-5f;

S load(const float* lanes) { return S(lanes, std::experimental::vector_aligned); }
S smaller(const S& a, const S& b) { return std::experimental::min(a, b); }
S larger(const S& a, const S& b) { return std::experimental::max(a, b); }

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

// What grows with all packs. The fourth rows are the joints': - the largest ||t||^2, and the largest | ||q||^2 - 1 |.
struct Bounds {
  S low[4] = {S(infinity), S(infinity), S(infinity), S(0)};
  S high[4] = {S(-infinity), S(-infinity), S(-infinity), S(0)};
};

// Turns all joints by the placement.
template <bool few>
void place(const Joints<few>& joints, const double* rotation, Bounds& bounds) {
  Transform placement;
  for (int i = 0; i < 4; ++i) placement.rotation[i] = S(static_cast<float>(rotation[i]));
  for (int first = 0; first < joints.count; first += width) {
    const Transform joint = joints.lanes(first);
    const S off = abs(squared_norm(joint.rotation) - S(1)), squared = squared_norm(joint.translation);
    bounds.low[3] = smaller(bounds.low[3], choose(squared < S(1e30f), S(-squared), S(-infinity)));
    bounds.high[3] = larger(bounds.high[3], choose(off <= S(1), off, S(1)));
    joints.put_lanes(first, compose(placement, joint));
  }
}

// The lanes from first on; which of them are unbounded.
template <int slots, bool strays, bool few>
typename S::mask_type add(const ReachPack& pack, int first, const Joints<few>& joints, Bounds& bounds) {
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
    const S share = S(0.75f) * root(larger(S(1) - c, S(0))) + S(off_unit);
    reach = reach + choose(is_unbounded, S(-infinity), share * a);
  }
  for (int i = 0; i < 3; ++i) {
    bounds.low[i] = smaller(bounds.low[i], low[i] - reach);
    bounds.high[i] = larger(bounds.high[i], high[i] + reach);
  }
  return is_unbounded;
}

template <bool strays, bool few>
void add_all(const Joints<few>& joints, const ReachPack* packs, int pack_count, std::uint32_t* unbounded,
             Bounds& bounds) {
  for (int p = 0; p < pack_count; ++p) {
    unbounded[p] = 0;
    for (int first = 0; first < reach_lanes; first += width) {
      const auto lanes = packs[p].slot_count <= 4 ? add<4, strays>(packs[p], first, joints, bounds)
                                                  : add<most_reach_joints, strays>(packs[p], first, joints, bounds);
      if (any_of(lanes))
        for (int lane = 0; lane < width; ++lane)
          unbounded[p] |= static_cast<std::uint32_t>(lanes[lane]) << (first + lane);
    }
  }
}

// The least of each row's lanes, or the greatest.
template <bool least>
void fold(const S (&rows)[4], float* out) {
  Four folded[4];
  for (int i = 0; i < 4; ++i) {
    alignas(64) float lanes[width];
    rows[i].copy_to(lanes, std::experimental::vector_aligned);
    std::memcpy(&folded[i], lanes, sizeof(Four));
    for (int lane = 4; lane < width; lane += 4) {
      Four next;
      std::memcpy(&next, lanes + lane, sizeof(Four));
      folded[i] = (least ? next < folded[i] : next > folded[i]) ? next : folded[i];
    }
  }
  transpose(folded);
  for (int i = 1; i < 4; ++i)
    folded[0] = (least ? folded[i] < folded[0] : folded[i] > folded[0]) ? folded[i] : folded[0];
  std::memcpy(out, &folded[0], sizeof(Four));
}

template <bool few>
void bound(const double* posture, const double* rotation, const ReachPack* packs, int pack_count, bool strays,
           const Joints<few>& joints, ReachBounds& out, std::uint32_t* unbounded) {
  joints.read(posture);
  Bounds bounds;
  place(joints, rotation, bounds);
  if (strays) add_all<true>(joints, packs, pack_count, unbounded, bounds);
  else add_all<false>(joints, packs, pack_count, unbounded, bounds);
  fold<true>(bounds.low, out.low);
  fold<false>(bounds.high, out.high);
}

REFITLAB_KERNEL void bound_any(const double* posture, int joint_count, const double* rotation, const ReachPack* packs,
                               int pack_count, bool strays, float* numbers, int joint_room, ReachBounds& out,
                               std::uint32_t* unbounded) {
  if (joint_room == 32)
    bound<true>(posture, rotation, packs, pack_count, strays, {numbers, joint_count, joint_room}, out, unbounded);
  else bound<false>(posture, rotation, packs, pack_count, strays, {numbers, joint_count, joint_room}, out, unbounded);
}

}  // namespace

const ReachKernels reach_kernels{bound_any};

}  // namespace refitlab::REFITLAB_TARGET
