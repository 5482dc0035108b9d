// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/engine_boxes_figure.hpp"

#include <algorithm>

#include "experiments/engines/box_measures.hpp"
#include "experiments/engines/engine_methods.hpp"
#include "experiments/pictures/box_edges.hpp"
#include "experiments/pictures/character_scene.hpp"

namespace refitlab {
namespace {

constexpr int boxes_width = 640, boxes_height = 600;

struct DrawnBox {
  std::string method;
  render::Color color;
};
const DrawnBox drawn_boxes[] = {{"all_skinned", render::palette::gray},
                                {"rounded_boxes", figure_colors::holding},
                                {"joint_boxes", figure_colors::without},
                                {"padded_pivots", figure_colors::missing}};

void draw_boxes_of(const Model& model, const Clip& clip, PictureTable& pictures) {
  const double time = clip.duration / 2;
  const Pose pose = clip.sample(time);
  const JointSets sets(model);
  const JointVolumes volumes(model);
  PoseMethods methods(model, sets, volumes, Skinning::linear);
  const std::vector<Box<double>> boxes = methods.boxes(pose);
  AllSkinned all(model, sets);
  const Box<double> truth = all.box(pose, Skinning::linear);
  if (!(volume_of_box(truth) > 0)) return;  // of a flat model, whose boxes have no ratios

  auto framed = Box<double>::empty();
  render::Scene scene;
  scene.meshes.push_back(skin_shape(model, all.vertices()));
  std::vector<PictureNumber> numbers = {{"clip_time", time, "s"}};
  for (const DrawnBox& drawn : drawn_boxes) {
    const auto& names = PoseMethods::methods();
    const auto at = std::find(names.begin(), names.end(), drawn.method);
    const Box<double>& box = boxes[static_cast<std::size_t>(at - names.begin())];
    framed.merge(box);
    add_edges(scene, box_of<float>(box), line_share * truth.edges().norm(), drawn.color);
    numbers.push_back({"volume_of_" + drawn.method, volume_of_box(box) / volume_of_box(truth)});
    if (drawn.method != "padded_pivots") continue;
    std::vector<bool> outside;
    for (const Point3& v : all.vertices()) outside.push_back(beyond_box({v, v}, box) > 0);
    mark_vertices(scene, all.vertices(), outside, figure_colors::missing, truth.edges().norm());
    numbers.push_back({"vertices_outside", static_cast<double>(std::count(outside.begin(), outside.end(), true))});
  }
  pictures.draw(
      scene, render::Camera::frame(corners_of(box_of<float>(framed)), {0.55, 0.25, 1}, double(boxes_width) / boxes_height, 0.1),
      {.width = boxes_width, .height = boxes_height}, {"engine_boxes", model.name, clip.name, "rounded_boxes"},
      "engine_boxes.png", numbers);
}

}  // namespace

void draw_engine_boxes(const Model& model, PictureTable& pictures) {
  for (const Clip& clip : model.clips) try {
      draw_boxes_of(model, clip, pictures);
      return;
    } catch (const ModelError&) {
    }
}

}  // namespace refitlab
