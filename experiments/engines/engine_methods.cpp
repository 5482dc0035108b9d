// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/engine_methods.hpp"

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

std::vector<Box<double>> points(const std::vector<Point3>& at) {
  std::vector<Box<double>> out;
  for (const Point3& p : at) out.push_back({p, p});
  return out;
}

}  // namespace

std::vector<Pose> expected_poses(const Model& model, std::optional<std::size_t> left_out) {
  std::vector<Pose> poses;
  for (std::size_t c = 0; c < model.clips.size(); ++c) try {
      const Clip& clip = model.clips[c];
      if (c == left_out) continue;
      for (int i = 0; i < expected_times; ++i) poses.push_back(clip.sample(clip.duration * i / (expected_times - 1)));
    } catch (const ModelError&) {
    }
  return poses;
}

Pose rest_pose(const Model& model) { return pose(model.skeleton, Animation{}, 0).pose; }

const std::vector<std::string>& PoseMethods::methods() {
  static const std::vector<std::string> all = {"joint_boxes",    "padded_pivots", "all_skinned",
                                               "joint_capsules", "rounded_boxes", "motion_bound"};
  return all;
}

JointVolumes::JointVolumes(const Model& model)
    : boxes(model),
      pivots(points(origins_of(model))),
      capsules(model),
      rounded_boxes(model, expected_poses(model)) {}

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
    default: matrices_.set(pose); return padded_pivots(box_of<double>(volumes_.pivots.box(matrices_)), padding_);
  }
}

std::vector<Box<double>> PoseMethods::boxes(const Pose& pose) {
  std::vector<Box<double>> out;
  for (std::size_t m = 0; m < methods().size(); ++m) out.push_back(box_of<double>(with_room(box(m, pose))));
  return out;
}

const std::vector<std::string>& clip_methods() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names = {"rest_box", "scaled_rest_box"};
    for (const SamplingWay& way : sampling_ways()) names.push_back("sampled_union_" + way.name);
    names.push_back("sampled_joint_boxes");
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
  const Box<double> rest = methods.box(of_all_skinned, rest_pose(model));
  std::vector<Box<double>> boxes = {rest, scaled(rest, guessed_scale)};
  for (const SamplingWay& way : sampling_ways()) boxes.push_back(merged(way, of_all_skinned));
  boxes.push_back(merged({"steps", 1 / seconds_a_step}, of_joint_boxes));
  std::vector<ClipBox> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) out.push_back({clip_methods()[i], box_of<double>(with_room(boxes[i]))});
  return out;
}

}  // namespace refitlab
