// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/joint_boxes.hpp"

namespace refitlab {

namespace {

std::vector<Box<double>> boxes_of_joints(const SkinnedMesh& mesh) {
  std::vector<Box<double>> out(mesh.joints.size(), Box<double>::empty());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (const Influence& influence : mesh.influences[v]) out[influence.joint].merge(mesh.vertices[v]);
  return out;
}

}  // namespace

JointBoxes::JointBoxes(const SkinnedMesh& mesh) : JointBoxes(boxes_of_joints(mesh)) {}

JointBoxes::JointBoxes(std::vector<Box<double>> bind)
    : bind_(std::move(bind)),
      numbers_(box_numbers, bind_.size(), extent_of_nothing) {
  const DefaultFloatEnvironment environment;
  for (int number = 0; number < 3; ++number)
    for (int j = 0; j < numbers_.padded_count(); ++j) numbers_.at(number, j) = 0;
  for (std::size_t j = 0; j < bind_.size(); ++j) {
    if (bind_[j].is_empty()) continue;
    const Point3 center = bind_[j].center(), half = bind_[j].edges() / 2;
    for (int i = 0; i < 3; ++i) {
      numbers_.at(i, static_cast<int>(j)) = static_cast<float>(center[i]);
      numbers_.at(3 + i, static_cast<int>(j)) = static_cast<float>(half[i]);
    }
  }
}

Box<float> JointBoxes::box(const JointMatrices& matrices, Target target) const {
  const DefaultFloatEnvironment environment;
  float out[6];
  joint_kernels(target).boxes(matrices.data(), numbers_.data(), numbers_.blocks(), out);
  return box_of_numbers(out);
}

}  // namespace refitlab
