#include "algorithms/collide/box_packs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "algorithms/balls/smallest_ball.hpp"
#include "algorithms/collide/box_kernel.hpp"

namespace refitlab {
namespace {

float above(double x) {
  const auto f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

// A ball around the points whose numbers are floats.
Ball3<double> float_ball(const std::vector<Point3>& points) {
  const Point3 center = smallest_ball<double, 3>(points).center.cast<float>().cast<double>();
  double radius = 0;
  for (const Point3& p : points) radius = std::max(radius, (p - center).norm());
  return {center, above(radius * (1 + 1e-15))};
}

class PieceMaker {
 public:
  explicit PieceMaker(const Character& c) : character_(c), first_slot_(JointFloats(c.sets).first_slot) {}

  void add(int target, int joint_set, const std::vector<int>& vertices) {
    const JointSets& sets = character_.sets;
    const int joints = static_cast<int>(sets.joints(joint_set).size());
    std::vector<Point3> points;
    for (const int v : vertices) points.push_back(character_.model.vertices[v]);
    const Ball3<double> reference = float_ball(points);
    if (joints > most_box_joints) return pieces_.others.push_back({joint_set, reference, target});
    std::vector<double> low(sets.weights(vertices[0]).begin(), sets.weights(vertices[0]).end());
    for (const int v : vertices)
      for (int i = 0; i < joints; ++i) low[i] = std::min(low[i], sets.weights(v)[i]);
    double rest = 1;
    for (const double l : low) rest -= l;

    auto& packs = pieces_.packs[joints - 1];
    int& lane = lanes_[joints - 1];
    if (lane == 0) packs.emplace_back();
    BoxPack& pack = packs.back();
    for (int to = lane; to < box_lanes; ++to) {  // the lanes behind are overwritten by the pieces to come
      for (int i = 0; i < joints; ++i)
        pack.slot[i][to] = first_slot_[joint_set] + i, pack.low[i][to] = static_cast<float>(low[i]);
      pack.set[to] = joint_set;
      pack.rest[to] = static_cast<float>(std::max(rest, 0.0));
      for (int i = 0; i < 3; ++i) pack.center[i][to] = static_cast<float>(reference.center[i]);
      pack.radius[to] = static_cast<float>(reference.radius);
      pack.target[to] = target;
    }
    lane = (lane + 1) % box_lanes;
  }

  BoxPieces take() { return std::move(pieces_); }

 private:
  const Character& character_;
  const std::vector<int> first_slot_;
  BoxPieces pieces_;
  int lanes_[most_box_joints] = {};
};

// The hull of the joints' whole images: a vertex is a convex combination of them in linear blending, and within its
// distance to the rotation center of one of the center's images in spherical blending.
void bound_others(const BoxPieces& pieces, Skinning skinning, const SkinningPose<double>& pose,
                  const Quaternion<double>& rotation, std::span<FlippedBox> boxes) {
  for (const ManyJointPiece& piece : pieces.others) {
    const JointSetPose<double>& set = pose[piece.joint_set];
    const Ball3<double>& ball = piece.reference;
    double reach = ball.radius;
    if (skinning == Skinning::dual_quaternion) reach = std::numeric_limits<double>::infinity();
    else if (skinning != Skinning::linear) reach += norm<double, 3>(ball.center - set.rotation_center);
    float* of = boxes[piece.target].of;
    for (std::size_t i = 0; i < set.transforms.size(); ++i) {
      const Point3 image = skinning == Skinning::linear ? apply(set.transforms[i], ball.center) : set.center_images[i];
      const Point3 at = rotate(rotation, image);
      const double by = reach + 1e-12 * (norm(image) + reach);
      for (int c = 0; c < 3; ++c) {
        of[c] = std::min(of[c], -above(by - at[c]));
        of[4 + c] = std::min(of[4 + c], -above(by + at[c]));
      }
    }
  }
}

}  // namespace

BoxPieces make_box_pieces(const Character& c, std::span<const int> nodes) {
  PieceMaker maker(c);
  std::map<int, std::vector<int>> by_set;
  for (std::size_t target = 0; target < nodes.size(); ++target) {
    by_set.clear();
    for (const int v : c.vertices[nodes[target]]) by_set[c.sets.of_vertex(v)].push_back(v);
    for (const auto& [set, vertices] : by_set) maker.add(static_cast<int>(target), set, vertices);
  }
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

void JointFloats::fill(const SkinningPose<double>& pose, Skinning skinning) {
  float* out = slots.data();
  for (std::size_t s = 0; s < pose.size(); ++s) {
    const JointSetPose<double>& set = pose[s];
    for (int i = 0; i < 3; ++i) centers[8 * s + i] = static_cast<float>(set.rotation_center[i]);
    for (std::size_t j = 0; j < set.transforms.size(); ++j, out += 8) {
      for (int i = 0; i < 4; ++i) out[i] = static_cast<float>(set.transforms[j].rotation[i]);
      if (skinning == Skinning::dual_quaternion) {
        for (int i = 0; i < 4; ++i) out[4 + i] = static_cast<float>(set.duals[j][i]);
      } else {
        const Point3& p = skinning == Skinning::linear ? set.transforms[j].translation : set.center_images[j];
        for (int i = 0; i < 3; ++i) out[4 + i] = static_cast<float>(p[i]);
      }
    }
  }
}

void bound_boxes(const BoxPieces& pieces, Skinning skinning, const JointFloats& joints,
                 const SkinningPose<double>& pose, const Quaternion<double>& rotation, std::span<FlippedBox> boxes,
                 Target target) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (FlippedBox& b : boxes) std::fill(std::begin(b.of), std::end(b.of), infinity);
  float matrix[9];
  for (int i = 0; i < 3; ++i) {
    const Point3 column = rotate<double>(rotation, Point3::Unit(i));
    for (int k = 0; k < 3; ++k) matrix[3 * k + i] = static_cast<float>(column[k]);
  }
  const BoxKernels& kernels = box_kernels(target);
  for (int n = 0; n < most_box_joints; ++n)
    kernels.bound(pieces.packs[n].data(), pieces.packs[n].size(), n + 1, skinning, joints.slots.data(),
                  joints.centers.data(), matrix, boxes.data());
  bound_others(pieces, skinning, pose, rotation, boxes);
}

}  // namespace refitlab
