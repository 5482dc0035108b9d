// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/rounded_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algorithms/runtime/packs/float_above.hpp"
#include "experiments/engines/weighted_radii.hpp"

namespace refitlab {
namespace {

constexpr float lost_of_boxes = 0x1p-16f;
constexpr double share_of_stretch = 1e-5;
constexpr double least_weights[] = {0.3, 0.6, 0.9, 0.99};
constexpr int insets = 4;                              // that are tried along each axis
constexpr int rounds = 3;                              // of trying all joints
constexpr double first_step = 0.32, last_step = 0.03;  // shares of a box
constexpr double least_cost = 1e-3;                    // of a joint that reaches no wall, where one that reaches a wall has 1

// Returns the absolute values of a joint's rotation matrices in the expected poses, summed over these and over the rows. By
// column, they are how much a half extent counts. A radius counts three times for each pose.
Point3 counts_of(std::span<const Pose> expected, std::size_t joint) {
  Point3 counts = Point3::Zero();
  for (const Pose& pose : expected)
    for (int column = 0; column < 3; ++column)
      counts[column] += rotate<double>(pose[joint].rotation, Point3::Unit(column)).cwiseAbs().sum();
  return counts;
}

// Returns a box around the points, whose axes may be shorter in exchange for a radius. It is the one whose images are the
// smallest.
RoundedBox box_around_points(const std::vector<Point3>& points, const Point3& counts, double poses) {
  auto around = Box<double>::empty();
  for (const Point3& p : points) around.merge(p);
  const Point3 center = around.center().cast<float>().cast<double>();
  const Point3 half = (around.high - center).cwiseMax(center - around.low);
  RoundedBox best;
  double least = infinite;
  const int tried = poses == infinite ? 1 : insets * insets * insets;  // a radius that counts so much is 0
  for (int i = 0; i < tried; ++i) {
    const Point3 share(i % insets, i / insets % insets, i / insets / insets);
    RoundedBox box{center, half - half.cwiseProduct(share / (insets - 1)), 0};
    for (const Point3& p : points) box.radius = std::max(box.radius, distance_from_box(box, p));
    const double size = dot<double, 3>(box.half, counts) + (tried > 1 ? 3 * poses * box.radius : 0);
    if (size < least) least = size, best = box;
  }
  return best;
}

// A Fit finds boxes of a mesh for poses that are expected. It begins with the boxes around all vertices of each joint, which are
// sound with radii of 0. It takes others, of one joint at a time, if the box of the character is then smaller on average.
class Fit {
 public:
  Fit(const SkinnedMesh& mesh, std::span<const Pose> expected)
      : mesh_(mesh),
        expected_(expected),
        costs_(mesh.joints.size(), 1),
        boxes_(mesh.joints.size()),
        distances_(mesh.vertices.size()),
        vertices_(mesh.joints.size()),
        matrices_(expected.size(), JointMatrices(mesh.joints.size())) {
    for (std::size_t p = 0; p < expected.size(); ++p) matrices_[p].set(expected[p]);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      for (const Influence& i : mesh.influences[v]) {
        distances_[v].push_back({i.joint, i.weight, 0});
        vertices_[i.joint].push_back(v);
      }
    for (const double weight : least_weights) own_.push_back(own_vertices(mesh, weight));
    boxes_ = boxes_around(own_vertices(mesh, 0), infinite);
    least_ = size(boxes_);
    for (const auto& own : own_) {
      std::vector<RoundedBox> boxes = boxes_around(own, static_cast<double>(expected.size()));
      take_if_better(boxes, distances_to(boxes));
    }
    for (int round = 0; round < rounds; ++round) improve();
    for (double step = first_step; step > last_step; step /= 2) shift(step);
  }
  const std::vector<RoundedBox>& boxes() const { return boxes_; }

 private:
  std::vector<RoundedBox> boxes_around(const std::vector<std::vector<Point3>>& own, double poses) const {
    std::vector<RoundedBox> boxes(own.size());
    for (std::size_t j = 0; j < own.size(); ++j)
      if (!own[j].empty()) boxes[j] = box_around_points(own[j], counts_of(expected_, j), poses);
    return boxes;
  }

  // Returns the joints that reach a wall, the most frequent first.
  std::vector<std::size_t> reaching_joints() {
    find_costs();
    std::vector<std::size_t> joints;
    for (std::size_t j = 0; j < boxes_.size(); ++j)
      if (boxes_[j].radius >= 0 && costs_[j] >= 1) joints.push_back(j);
    std::stable_sort(joints.begin(), joints.end(), [&](std::size_t a, std::size_t b) { return costs_[a] > costs_[b]; });
    return joints;
  }

  void improve() {
    for (const std::size_t j : reaching_joints()) {
      const Point3 counts = counts_of(expected_, j);
      for (const auto& own : own_)
        for (const double poses : {static_cast<double>(expected_.size()), infinite})
          try_box(j, box_around_points(own[j], counts, poses));
    }
  }

  // Moves the walls of boxes by a share of their longest half extent.
  void shift(double step) {
    for (const std::size_t j : reaching_joints())
      for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1})
          for (const int way : {-1, 1}) {
            RoundedBox box = boxes_[j];
            const double by = way * step * std::max(box.half.maxCoeff(), box.radius);
            box.half[axis] += by / 2;
            if (box.half[axis] < 0) continue;
            box.center[axis] = static_cast<float>(box.center[axis] + side * by / 2);
            try_box(j, box);
          }
  }

  // Tries a box in place of a joint's box.
  void try_box(std::size_t joint, const RoundedBox& box) {
    std::vector<RoundedBox> boxes = boxes_;
    boxes[joint] = box;
    auto distances = distances_;
    for (const std::size_t v : vertices_[joint])
      for (WeightedDistance& d : distances[v])
        if (d.joint == static_cast<int>(joint)) d.distance = distance_from_box(box, mesh_.vertices[v]);
    take_if_better(boxes, std::move(distances));
  }

  std::vector<std::vector<WeightedDistance>> distances_to(const std::vector<RoundedBox>& boxes) const {
    auto distances = distances_;
    for (std::size_t v = 0; v < distances.size(); ++v)
      for (WeightedDistance& d : distances[v]) d.distance = distance_from_box(boxes[d.joint], mesh_.vertices[v]);
    return distances;
  }

  void take_if_better(std::vector<RoundedBox>& boxes, std::vector<std::vector<WeightedDistance>>&& distances) {
    const std::vector<double> radii = weighted_radii(distances, costs_);
    for (std::size_t j = 0; j < boxes.size(); ++j)
      if (boxes[j].radius >= 0) boxes[j].radius = radii[j];
    if (const double found = size(boxes); found < least_)
      least_ = found, boxes_ = std::move(boxes), distances_ = std::move(distances);
  }

  // Returns the sum of the volumes over the poses.
  double size(const std::vector<RoundedBox>& boxes) const {
    const RoundedBoxes rounded(mesh_, boxes);
    double sum = 0;
    for (const JointMatrices& m : matrices_) sum += box_of<double>(rounded.box(m)).edges().prod();
    return sum;
  }

  // Finds in how many poses and walls each joint reaches the farthest.
  void find_costs() {
    std::fill(costs_.begin(), costs_.end(), least_cost);
    for (const Pose& pose : expected_) {
      std::array<std::pair<double, std::size_t>, 6> farthest;
      farthest.fill({-infinite, 0});
      for (std::size_t j = 0; j < boxes_.size(); ++j) {
        if (boxes_[j].radius < 0) continue;
        const Point3 center = apply(pose[j], boxes_[j].center);
        Point3 extent = Point3::Constant(boxes_[j].radius);
        for (int i = 0; i < 3; ++i) extent += rotate<double>(pose[j].rotation, Point3::Unit(i)).cwiseAbs() * boxes_[j].half[i];
        for (int i = 0; i < 3; ++i) {
          farthest[i] = std::max(farthest[i], {extent[i] - center[i], j});
          farthest[3 + i] = std::max(farthest[3 + i], {extent[i] + center[i], j});
        }
      }
      for (const auto& [value, joint] : farthest) costs_[joint] += 1;
    }
  }

  const SkinnedMesh& mesh_;
  const std::span<const Pose> expected_;
  std::vector<double> costs_;
  std::vector<RoundedBox> boxes_;
  std::vector<std::vector<WeightedDistance>> distances_;  // by vertex
  std::vector<std::vector<std::size_t>> vertices_;        // by joint
  std::vector<JointMatrices> matrices_;                   // by pose
  std::vector<std::vector<std::vector<Point3>>> own_;     // by least weight and joint
  double least_ = 0;
};

}  // namespace

double distance_from_box(const RoundedBox& box, const Point3& point) {
  return norm<double, 3>(((point - box.center).cwiseAbs() - box.half).cwiseMax(0));
}

std::vector<RoundedBox> fit_rounded_boxes(const SkinnedMesh& mesh, std::span<const Pose> expected) {
  const DefaultFloatEnvironment environment;
  const Pose reference = reference_pose(mesh);
  if (expected.empty()) expected = {&reference, 1};
  return Fit(mesh, expected).boxes();
}

RoundedBoxes::RoundedBoxes(const SkinnedMesh& mesh, const std::vector<RoundedBox>& boxes)
    : numbers_(rounded_box_numbers, mesh.joints.size()) {
  const DefaultFloatEnvironment environment;
  for (int j = 0; j < numbers_.stride(); ++j) numbers_.at(6, j) = extent_of_nothing;
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    const RoundedBox& b = boxes[j];
    if (b.radius < 0) continue;
    for (int i = 0; i < 3; ++i) {
      numbers_.at(i, static_cast<int>(j)) = static_cast<float>(b.center[i]);
      numbers_.at(3 + i, static_cast<int>(j)) = float_above(b.half[i] * (1 + share_of_stretch));
    }
    const double farthest = norm<double, 3>(b.center) + norm<double, 3>(b.half);
    numbers_.at(6, static_cast<int>(j)) = float_above(b.radius * (1 + share_of_stretch) + 2.1 * lost_of_boxes * farthest);
  }
}

Box<float> RoundedBoxes::box(const JointMatrices& matrices, Target target) const {
  const DefaultFloatEnvironment environment;
  float out[6];
  joint_kernels(target).rounded_boxes(matrices.data(), numbers_.data(), numbers_.stride(), 2 * lost_of_boxes, out);
  return box_of_numbers(out);
}

}  // namespace refitlab
