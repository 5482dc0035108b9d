// SPDX-License-Identifier: MIT
// These classes are for the kernels of MotionBound and PoseChange. They hold the numbers of all joints, and the bounds of a pack's lanes.
#pragma once

#include <cstddef>
#include <limits>
#include <type_traits>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/collide/motion_bound_kernel.hpp"
#include "algorithms/runtime/packs/look_up.hpp"
#include "algorithms/runtime/packs/transpose.hpp"
#include "lemmas/b7_motion_bound.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
using Point = Vec<S, 3>;
using Transform = RigidTransform<S>;
constexpr int width = static_cast<int>(S::size());
static_assert(motion_bound_lanes % width == 0);

constexpr float infinity = std::numeric_limits<float>::infinity();
// This is more than the error of a dot product.
constexpr float positive = 1e-5f;

S load(const float* lanes) { return S(lanes, std::experimental::vector_aligned); }

// Returns the transforms of records of eight floats, as transpose_records reads them.
template <class Read>
[[gnu::always_inline]] inline Transform of_records(const Read& read) {
  alignas(64) float lanes[8][width];
  transpose_records<width>(read, lanes[0], width);
  Transform out;
  for (int i = 0; i < 4; ++i) out.rotation[i] = load(lanes[i]);
  for (int i = 0; i < 3; ++i) out.translation[i] = load(lanes[4 + i]);
  return out;
}

// Returns joints from first on, of which pose has eight doubles each. Lanes behind the last joint repeat it.
inline Transform joints_of_pose(const double* pose, int count, int first) {
  return of_records([&](int lane, int i, Row<float, 4>& four) {
    const std::ptrdiff_t joint = first + lane < count ? first + lane : count - 1;
    read_floats(pose + 8 * joint + i, four);
  });
}

// Returns ||t||^2 of a joint's translation, or infinity if that is beyond 1e30 or no number.
inline S squared_reach(const Transform& joint) {
  const S squared = squared_norm(joint.translation);
  return choose(squared < S(1e30f), squared, S(infinity));
}
// Returns | ||q||^2 - 1 | of a joint's rotation, or 1 if that is greater or no number.
inline S defect(const Transform& joint) {
  const S off = abs(squared_norm(joint.rotation) - S(1));
  return choose(off <= S(1), off, S(1));
}

template <bool least>
inline Row<float, 4> further(const Row<float, 4>& a, const Row<float, 4>& b) {
  return least ? min_of(a, b) : max_of(a, b);
}
// Writes the least of each row's lanes, or the greatest.
template <bool least>
void fold(const S (&rows)[4], float* out) {
  Row<float, 4> folded[4];
  for (int i = 0; i < 4; ++i) {
    alignas(64) float lanes[width];
    rows[i].copy_to(lanes, std::experimental::vector_aligned);
    read_row(lanes, folded[i]);
    for (int lane = 4; lane < width; lane += 4) {
      Row<float, 4> next;
      read_row(lanes + lane, next);
      folded[i] = further<least>(folded[i], next);
    }
  }
  transpose(folded);
  for (int i = 1; i < 4; ++i) folded[0] = further<least>(folded[0], folded[i]);
  write_row(folded[0], out);
}

// If a register has at most eight numbers, the eight of a joint are side by side, and those of a pack's lanes are transposed. Else
// number i of all joints is at numbers + i * stride(), where each lane looks up its own.
constexpr bool are_by_joint = width <= 8;

// few says that there are at most 32 joints.
template <bool few>
struct Joints {
  float* numbers;
  int count, any_stride;

  void put_lanes(int first, const Transform& t) const {
    if constexpr (are_by_joint) {
      alignas(64) float lanes[8][width];
      put_numbers(t, lanes[0], width);
      S(0).copy_to(lanes[7], std::experimental::vector_aligned);
      for (int lane = 0; lane < width; lane += 4)
        for (int i = 0; i < 8; i += 4) {
          Row<float, 4> rows[4];
          for (int r = 0; r < 4; ++r) read_row(lanes[i + r] + lane, rows[r]);
          transpose(rows);
          for (int r = 0; r < 4; ++r) write_row(rows[r], numbers + 8 * (first + lane + r) + i);
        }
    } else {
      put_numbers(t, numbers + first, stride());
    }
  }
  Transform of_lanes(const std::int32_t* joint) const {
    if constexpr (are_by_joint) {
      return of_records([&](int lane, int i, Row<float, 4>& four) { read_row(numbers + 8 * joint[lane] + i, four); });
    } else {
      constexpr Table table = few ? Table::of_few : Table::in_registers;
      const auto found =
          look_up<table, 7, 1>({number(0), number(1), number(2), number(3), number(4), number(5), number(6)}, count, {joint});
      Transform out;
      for (int i = 0; i < 4; ++i) out.rotation[i] = found[i][0];
      for (int i = 0; i < 3; ++i) out.translation[i] = found[4 + i][0];
      return out;
    }
  }

 private:
  int stride() const { return few ? 32 : any_stride; }
  float* number(int i) const { return numbers + i * stride(); }
  static void put_numbers(const Transform& t, float* out, int out_stride) {
    for (int i = 0; i < 4; ++i) t.rotation[i].copy_to(out + i * out_stride, std::experimental::vector_aligned);
    for (int i = 0; i < 3; ++i) t.translation[i].copy_to(out + (4 + i) * out_stride, std::experimental::vector_aligned);
  }
};

// Calls with(n) with a constant n that is at least slots. Returns what it returns.
template <class With>
[[gnu::always_inline]] inline auto with_slots(int slots, const With& with) {
  return slots <= 1   ? with(std::integral_constant<int, 1>())
         : slots <= 2 ? with(std::integral_constant<int, 2>())
         : slots <= 3 ? with(std::integral_constant<int, 3>())
         : slots <= 4 ? with(std::integral_constant<int, 4>())
                      : with(std::integral_constant<int, most_motion_bound_joints>());
}

inline Point load_point(const float (&numbers)[3][motion_bound_lanes], int first) {
  return {load(numbers[0] + first), load(numbers[1] + first), load(numbers[2] + first)};
}

// Rotations has the rotations of a lane's joints, with the skinning's signs.
template <int slots>
class Rotations {
 public:
  [[gnu::always_inline]] void add(int k, const Quaternion<S>& rotation) {
    of_[k] = rotation;
    if (k == 0) return;
    const S cosine = dot(of_[0], rotation);
    for (int i = 0; i < 4; ++i) of_[k][i] = choose(cosine < S(0), S(-rotation[i]), rotation[i]);
    least_ = min_of(least_, abs(cosine));
#pragma GCC unroll 8
    for (int l = 1; l < k; ++l) least_ = min_of(least_, dot(of_[l], of_[k]));
  }
  // Says whether no bound is known for blends of these rotations.
  auto are_far() const { return !(least_ > S(positive)); }
  // Returns c, or a smaller number. It must not be used if the rotations are far apart.
  S cosine() const { return least_ - S(positive); }

 private:
  Quaternion<S> of_[slots];
  S least_{1};
};

// Returns the most by which a blend deviates, as a share of A.
[[gnu::always_inline]] inline S deviation_share(const S& c) { return root(squared_deviation_share(c)); }

// Images has the images of a point under a lane's joints. It makes a box around them, and A.
class Images {
 public:
  [[gnu::always_inline]] void add(int k, const Point& image) {
    if (k == 0) {
      first_ = image, box_ = {image, image};
      return;
    }
    box_.merge(Box<S>{image, image});
    const Point y = image - first_;
    sum_ = sum_ + y;
    squares_ = squares_ + squared_norm(y);
  }
  const Box<S>& box() const { return box_; }
  S spread(const S& joint_count) const { return root(max_of(squared_spread_of_sums(joint_count, squares_, sum_), S(0))); }

 private:
  Point first_, sum_ = Point::Constant(S(0));
  Box<S> box_;
  S squares_{0};
};

}  // namespace
}  // namespace refitlab::REFITLAB_TARGET
