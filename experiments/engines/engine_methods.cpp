// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/engine_methods.hpp"

#include "algorithms/bake/over_time/model_bounds.hpp"
#include "experiments/engines/bind_box.hpp"
#include "experiments/over_time/sampled_boxes.hpp"

namespace refitlab {
namespace {

constexpr double guessed_scale = 2, seconds_a_step = 1. / 6;  // as Babylon.js has it by default
constexpr int expected_times = 12;                            // of a clip

enum PoseMethodIndex { of_joint_boxes, of_padded_pivots, of_all_skinned, of_joint_capsules, of_rounded_boxes, of_motion_bound };

std::vector<Point3> origins_of(const SkinnedMesh& mesh) {
  std::vector<Point3> origins;
  for (const Joint& joint : mesh.joints) origins.push_back(joint.origin);
  return origins;
}

}  // namespace

std::vector<Pose> expected_poses(const Model& model) {
  std::vector<Pose> poses;
  for (const Clip& clip : model.clips) try {
      for (int i = 0; i < expected_times; ++i) poses.push_back(clip.sample(clip.duration * i / (expected_times - 1)));
    } catch (const ModelError&) {
    }
  return poses;
}

Box<double> with_room(Box<double> box) {
  box.grow(ModelBoundsOptions{}.renderer_rounding * 2 * box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff());
  return box_of<double>(rounded_outward(box));
}

void place_pivots(const SkinnedMesh& mesh, const Pose& pose, std::vector<Point3>& pivots) {
  pivots.resize(pose.size());
  for (std::size_t j = 0; j < pose.size(); ++j) pivots[j] = apply(pose[j], mesh.joints[j].origin);
}

const std::vector<EngineMethod>& PoseMethods::methods() {
  static const std::vector<EngineMethod> all = {{"joint_boxes", false},   {"padded_pivots", false}, {"all_skinned", false},
                                                {"joint_capsules", true}, {"rounded_boxes", true},  {"motion_bound", true}};
  return all;
}

JointVolumes::JointVolumes(const Model& model) : boxes(model), capsules(model), rounded_boxes(model, expected_poses(model)) {}

PoseMethods::PoseMethods(const Model& model, const JointSets& sets, const JointVolumes& volumes, Skinning skinning)
    : model_(model),
      volumes_(volumes),
      skinning_(skinning),
      matrices_(model.joints.size()),
      motion_bound_(model, sets, skinning),
      all_(model, sets),
      padding_(pivot_padding(box_around<double>(origins_of(model)), bind_box(model))) {}

Box<double> PoseMethods::box(std::size_t method, const Pose& pose) {
  switch (method) {
    case of_joint_boxes: matrices_.set(pose); return box_of<double>(volumes_.boxes.box(matrices_));
    case of_joint_capsules: matrices_.set(pose); return box_of<double>(volumes_.capsules.box(matrices_));
    case of_rounded_boxes: matrices_.set(pose); return box_of<double>(volumes_.rounded_boxes.box(matrices_));
    case of_motion_bound: return motion_bound_.box(pose, {});
    case of_all_skinned: return truth(pose);
    default: place_pivots(model_, pose, pivots_); return padded_pivots<double>(pivots_, padding_);
  }
}

std::vector<Box<double>> PoseMethods::boxes(const Pose& pose) {
  std::vector<Box<double>> out;
  for (std::size_t m = 0; m < methods().size(); ++m) out.push_back(with_room(box(m, pose)));
  return out;
}

const std::vector<EngineMethod>& clip_methods() {
  static const std::vector<EngineMethod> all = [] {
    std::vector<EngineMethod> names = {{"bind_box", false}, {"scaled_bind_box", false}};
    for (const SamplingWay& way : sampling_ways()) names.push_back({"sampled_union_" + way.name, false});
    names.push_back({"sampled_joint_boxes", false});
    return names;
  }();
  return all;
}

std::vector<ClipBox> clip_boxes(const Model& model, const PlayedClip& clip, PoseMethods& methods) {
  const auto merged = [&](const SamplingWay& way, std::size_t method) {
    auto box = Box<double>::empty();
    for (const double time : sampled_times(way, clip.key_times)) box.merge(methods.box(method, clip.sample(time)));
    return box;
  };
  std::vector<Box<double>> boxes = {bind_box(model), scaled(bind_box(model), guessed_scale)};
  for (const SamplingWay& way : sampling_ways()) boxes.push_back(merged(way, of_all_skinned));
  boxes.push_back(merged({"steps", 1 / seconds_a_step}, of_joint_boxes));
  std::vector<ClipBox> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) out.push_back({clip_methods()[i].name, with_room(boxes[i])});
  return out;
}

}  // namespace refitlab
