// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/sampled_miss_figure.hpp"

#include <algorithm>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "experiments/over_time/sampled_boxes.hpp"
#include "experiments/pictures/box_edges.hpp"
#include "experiments/pictures/character_scene.hpp"

namespace refitlab {
namespace {

constexpr int miss_width = 640, miss_height = 600;

struct Worst {
  const OverTimeResult* result = nullptr;
  std::string clip, way;
  int cluster = -1;  // the whole character if it is none
  Miss miss;
};

Worst worst_of(const std::vector<OverTimeResult>& results, bool of_cluster) {
  Worst worst;
  for (const OverTimeResult& r : results)
    for (const ClipResult& clip : r.clips)
      for (const ClipMisses& m : clip.misses)
        if (const Miss& miss = of_cluster ? m.of_cluster : m.of_whole; miss.vertex >= 0 && miss.by > worst.miss.by)
          worst = {&r, clip.clip, m.way, of_cluster ? m.worst_cluster : -1, miss};
  return worst;
}

bool is_in(const Box<float>& box, const Point3& p) {
  for (int i = 0; i < 3; ++i)
    if (p[i] < box.low[i] || p[i] > box.high[i]) return false;
  return true;
}

Point3 mean_of(const std::vector<Point3>& vertices, const std::vector<bool>& counted) {
  Point3 sum = Point3::Zero();
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (counted[v]) sum += vertices[v];
  return sum / std::max<double>(1, std::count(counted.begin(), counted.end(), true));
}

// Returns, of some views, the one that has the vertices outside nearest to the eye.
Point3 view_of(const Point3& outside, const Point3& center) {
  std::vector<Point3> views;
  for (const double x : {-1, 1})
    for (const double z : {-1, 1}) views.emplace_back(0.45 * x, 0.2, z), views.emplace_back(x, 0.2, 0.45 * z);
  const auto nearness = [&](const Point3& view) { return dot<double, 3>(view.normalized(), outside - center); };
  return *std::max_element(views.begin(), views.end(), [&](const auto& a, const auto& b) { return nearness(a) < nearness(b); });
}

void draw(const Model& made, const Worst& worst, PictureTable& pictures) {
  const Model model = with_keys(made);
  const auto clip = std::find_if(model.clips.begin(), model.clips.end(), [&](const Clip& c) { return c.name == worst.clip; });
  const auto way =
      std::find_if(sampling_ways().begin(), sampling_ways().end(), [&](const auto& w) { return w.name == worst.way; });
  if (clip == model.clips.end() || way == sampling_ways().end()) return;
  const Skinning skinning = worst.result->skinning;
  Model alone = model;
  alone.clips = {*clip};
  const ModelBounds bounds = bound_model(alone, {.skinning = skinning});
  const std::size_t part = compared_parts(bounds)[worst.cluster + 1];
  const JointSets sets(model);
  const std::vector<WatchedPart> watched = {{bounds.parts[part].vertices, Point3::Zero()}};
  const Box<float> sampled = sampled_boxes(WatchedClip(model, sets, clip->animation, skinning, watched), *way)[0],
                   bound = bounds.clips[0].parts[part].box;

  const AnimatedJoints joints(model, clip->animation, skinning != Skinning::linear);
  std::vector<Point3> vertices;
  MovingVertices(model, sets, skinning, indices_below(model.vertices.size()))
      .place(*joints.at(worst.miss.time, Side::after), Followed::skinned, vertices);

  const std::vector<Point3> framed = corners_of(bound);
  const double size = norm<double, 3>(framed.back() - framed.front());
  std::vector<bool> outside(vertices.size());
  for (const int v : bounds.parts[part].vertices) outside[v] = !is_in(sampled, vertices[v]);
  const Point3 view = view_of(mean_of(vertices, outside), mean_of(vertices, std::vector<bool>(vertices.size(), true)));
  render::Scene scene;
  scene.meshes.push_back(skin_shape(model, vertices));
  if (worst.cluster >= 0) {
    render::MeshShape cluster = scene.meshes[0];
    cluster.triangles.clear();
    for (const int t : bounds.parts[part].triangles) cluster.triangles.push_back(model.triangles[t]);
    cluster.color = render::palette::yellow;
    for (Point3& v : cluster.vertices) v += 1e-3 * size * view.normalized();
    scene.meshes[0].opacity = 0.3;
    scene.meshes.push_back(cluster);
  }
  add_edges(scene, sampled, line_share * size, figure_colors::missing);
  add_edges(scene, bound, line_share * size, figure_colors::holding);
  mark_vertices(scene, vertices, outside, figure_colors::missing, size);
  const std::string what = worst.cluster < 0 ? "whole" : "cluster";
  pictures.draw(scene, render::Camera::frame(framed, view, double(miss_width) / miss_height, 0.1),
                {.width = miss_width, .height = miss_height}, {"sampled_miss", model.name, worst.clip, worst.way},
                "sampled_miss_" + what + ".png",
                {{"shows_cluster", worst.cluster < 0 ? 0. : 1.},
                 {"clip_time", worst.miss.time, "s"},
                 {"miss_distance_over_box_side", worst.miss.by},
                 {"vertices_outside", static_cast<double>(std::count(outside.begin(), outside.end(), true))}});
}

}  // namespace

void draw_sampled_miss(const std::vector<Model>& models, const std::vector<OverTimeResult>& results, PictureTable& pictures) {
  for (const bool of_cluster : {false, true}) {
    const Worst worst = worst_of(results, of_cluster);
    for (const Model& model : models)
      if (worst.result && model.name == worst.result->model) draw(model, worst, pictures);
  }
}

}  // namespace refitlab
