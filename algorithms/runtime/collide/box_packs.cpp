// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/box_packs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

class PieceMaker {
 public:
  explicit PieceMaker(const Character& c) : first_slot_(JointFloats(c.sets).first_slot) {}

  void add(const SimplexPiece& piece) {
    const int joints = static_cast<int>(piece.low.size());
    if (joints > most_box_joints) return pieces_.others.push_back(piece);
    auto& packs = pieces_.packs[joints - 1];
    int& lane = lanes_[joints - 1];
    if (lane == 0) packs.emplace_back();
    BoxPack& pack = packs.back();
    const bool is_in_range = upper_norm(piece.reference.center) + piece.reference.radius < largest_box;
    for (int to = lane; to < box_lanes; ++to) {  // the lanes behind are overwritten by the pieces to come
      for (int i = 0; i < joints; ++i)
        pack.slot[i][to] = first_slot_[piece.joint_set] + i, pack.low[i][to] = static_cast<float>(piece.low[i]);
      pack.set[to] = piece.joint_set;
      pack.rest[to] = static_cast<float>(piece.rest);
      for (int i = 0; i < 3; ++i) pack.center[i][to] = static_cast<float>(piece.reference.center[i]);
      pack.radius[to] = is_in_range ? static_cast<float>(piece.reference.radius) + least_box : infinity;
      pack.target[to] = piece.target;
    }
    lane = (lane + 1) % box_lanes;
  }

  BoxPieces take() { return std::move(pieces_); }

 private:
  const std::vector<int> first_slot_;
  BoxPieces pieces_;
  int lanes_[most_box_joints] = {};
};

// Merges a number into a side of a FlippedBox. If coordinates beyond the range of float make it undefined, the side becomes
// infinite.
void merge(float& side, double outside) { side = std::min(side, std::isnan(outside) ? -infinity : -float_above(outside)); }

// Bounds pieces by the hull of the joints' whole images. A vertex is a convex combination of them in linear blending, and within
// its distance to the rotation center of one of the center's images in spherical blending. Quaternions with ||q||^2 = 1 + e
// stretch by at most 2 |e|. In linear blending the joint's quaternion does so, and the placement's always.
void bound_others(const BoxPieces& pieces, Skinning skinning, const SkinningPalette<double>& palette,
                  const Quaternion<double>& rotation, std::span<FlippedBox> boxes) {
  for (const SimplexPiece& piece : pieces.others) {
    const PaletteEntry<double>& set = palette[piece.joint_set];
    const double rounding = lost_of_hull(static_cast<int>(set.transforms.size()));
    const Ball3<double>& ball = piece.reference;
    double reach = ball.radius, size = norm(ball.center);
    if (skinning == Skinning::dual_quaternion) reach = std::numeric_limits<double>::infinity();
    else if (skinning != Skinning::linear)
      reach += norm<double, 3>(ball.center - set.rotation_center), size += norm(set.rotation_center);
    float* of = boxes[piece.target].of;
    for (std::size_t i = 0; i < set.transforms.size(); ++i) {
      const Point3 image = skinning == Skinning::linear ? apply(set.transforms[i], ball.center) : set.center_images[i];
      const Point3 at = rotate(rotation, image);
      // The image may be much shorter than its summands.
      const double parts = size + norm(skinning == Skinning::linear ? set.transforms[i].translation : image);
      const double by = stretch_of_hull * reach + rounding * (parts + reach) + least_box;
      for (int c = 0; c < 3; ++c) merge(of[c], by - at[c]), merge(of[4 + c], by + at[c]);
    }
  }
}

}  // namespace

BoxPieces make_box_pieces(const Character& c, std::span<const SimplexPiece> pieces) {
  const DefaultFloatEnvironment environment;
  PieceMaker maker(c);
  for (const SimplexPiece& piece : pieces) maker.add(piece);
  return maker.take();
}

JointFloats::JointFloats(const JointSets& sets) : centers(8 * sets.count()) {
  int slot = 0;
  for (int s = 0; s < sets.count(); ++s) {
    first_slot.push_back(slot);
    slot += static_cast<int>(sets.joints(s).size());
  }
  slots.resize(8 * slot);
}

void JointFloats::fill(const SkinningPalette<double>& palette, Skinning skinning) {
  const DefaultFloatEnvironment environment;
  float* out = slots.data();
  double most = 0;
  const auto add = [&](double length) { most = std::max(most, std::abs(length)); };
  for (std::size_t s = 0; s < palette.size(); ++s) {
    const PaletteEntry<double>& set = palette[s];
    for (int i = 0; i < 3; ++i) centers[8 * s + i] = static_cast<float>(set.rotation_center[i]);
    if (skinning == Skinning::spherical || skinning == Skinning::hejl)
      for (int i = 0; i < 3; ++i) add(set.rotation_center[i]);
    for (std::size_t j = 0; j < set.transforms.size(); ++j, out += 8) {
      for (int i = 0; i < 4; ++i) out[i] = static_cast<float>(set.transforms[j].rotation[i]);
      if (skinning == Skinning::dual_quaternion) {
        for (int i = 0; i < 4; ++i) out[4 + i] = static_cast<float>(set.duals[j][i]), add(set.duals[j][i]);
      } else {
        const Point3& p = skinning == Skinning::linear ? set.transforms[j].translation : set.center_images[j];
        for (int i = 0; i < 3; ++i) out[4 + i] = static_cast<float>(p[i]), add(p[i]);
      }
    }
  }
  largest = static_cast<float>(most);
}

void bound_boxes(const BoxPieces& pieces, Skinning skinning, const JointFloats& joints, const SkinningPalette<double>& palette,
                 const Quaternion<double>& rotation, std::span<FlippedBox> boxes, Target target) {
  const DefaultFloatEnvironment environment;
  const bool is_in_range = joints.largest < largest_box;
  for (FlippedBox& b : boxes) b.set_all(is_in_range ? infinity : -infinity);
  if (!is_in_range) return;
  float matrix[9];
  const auto rows = rotation_rows(rotation);
  for (int i = 0; i < 9; ++i) matrix[i] = static_cast<float>(rows[i / 3][i % 3]);
  const BoxKernels& kernels = box_kernels(target);
  for (int n = 0; n < most_box_joints; ++n)
    kernels.bound(pieces.packs[n].data(), pieces.packs[n].size(), n + 1, skinning, joints.slots.data(), joints.centers.data(),
                  matrix, boxes.data());
  bound_others(pieces, skinning, palette, rotation, boxes);
}

}  // namespace refitlab
