// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/rounded_boxes.hpp"

#include <algorithm>

#include "algorithms/runtime/packs/float_above.hpp"
#include "experiments/engines/box_program.hpp"
#include "experiments/engines/joint_boxes.hpp"
#include "experiments/engines/weighted_radii.hpp"

namespace refitlab {
namespace {

constexpr float lost_of_boxes = 0x1p-16f;
constexpr double share_of_stretch = 1e-5;

// Around all vertices that a joint moves, which is sound with radii of 0.
std::vector<RoundedBox> boxes_around_all(const SkinnedMesh& mesh) {
  std::vector<RoundedBox> boxes;
  const JointBoxes around(mesh);
  for (const Box<double>& box : around.bind())
    boxes.push_back(box.is_empty() ? RoundedBox{} : RoundedBox{box.center(), box.edges() / 2, 0});
  return boxes;
}

// Centers become floats, and radii are raised where a vertex lacks, or lowered where none does.
void make_sound(const SkinnedMesh& mesh, std::vector<RoundedBox>& boxes) {
  std::vector<double> radii;
  for (RoundedBox& box : boxes) {
    box.center = box.center.cast<float>().cast<double>();
    radii.push_back(std::max(0., box.radius));
  }
  std::vector<std::vector<WeightedDistance>> inequalities(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (const Influence& i : mesh.influences[v])
      inequalities[v].push_back({i.joint, i.weight, distance_from_box(boxes[i.joint], mesh.vertices[v])});
  radii = weighted_radii(inequalities, radii);
  for (std::size_t j = 0; j < boxes.size(); ++j)
    if (boxes[j].radius >= 0) boxes[j].radius = radii[j];
}

}  // namespace

RoundedBox ball_around(const RoundedBox& box) { return {box.center, Point3::Zero(), box.radius + norm<double, 3>(box.half)}; }

double distance_from_box(const RoundedBox& box, const Point3& point) {
  return norm<double, 3>(((point - box.center).cwiseAbs() - box.half).cwiseMax(0));
}

std::vector<RoundedBox> fit_rounded_boxes(const SkinnedMesh& mesh, std::span<const Pose> expected) {
  const DefaultFloatEnvironment environment;
  const Pose reference = reference_pose(mesh);
  if (expected.empty()) expected = {&reference, 1};
  BoxProgram program(mesh, expected, boxes_around_all(mesh));
  program.run();
  program.make_balls();
  program.run();
  std::vector<RoundedBox> boxes = program.boxes();
  make_sound(mesh, boxes);
  return boxes;
}

RoundedBoxes::RoundedBoxes(const SkinnedMesh& mesh, const std::vector<RoundedBox>& boxes)
    : numbers_(rounded_box_numbers, mesh.joints.size()),
      are_balls_(static_cast<std::size_t>(numbers_.blocks()), true) {
  const DefaultFloatEnvironment environment;
  for (int j = 0; j < numbers_.padded_count(); ++j) numbers_.at(6, j) = extent_of_nothing;
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    const RoundedBox& b = boxes[j];
    if (b.radius < 0) continue;
    for (int i = 0; i < 3; ++i) {
      numbers_.at(i, static_cast<int>(j)) = static_cast<float>(b.center[i]);
      numbers_.at(3 + i, static_cast<int>(j)) = float_above(b.half[i] * (1 + share_of_stretch));
    }
    if (b.half != Point3::Zero()) are_balls_[j / Lanes<float>::count] = false;
    const double farthest = norm<double, 3>(b.center) + norm<double, 3>(b.half);
    numbers_.at(6, static_cast<int>(j)) = float_above(b.radius * (1 + share_of_stretch) + 2.1 * lost_of_boxes * farthest);
  }
}

Box<float> RoundedBoxes::box(const JointMatrices& matrices, Target target) const {
  const DefaultFloatEnvironment environment;
  float out[6];
  joint_kernels(target).rounded_boxes(matrices.data(), numbers_.data(), are_balls_.data(), numbers_.blocks(), 2 * lost_of_boxes,
                                      out);
  return box_of_numbers(out);
}

}  // namespace refitlab
