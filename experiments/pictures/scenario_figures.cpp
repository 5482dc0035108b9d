// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/scenario_figures.hpp"

#include <stdexcept>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/collisions/scenarios.hpp"
#include "experiments/pictures/character_scene.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr int scenario_width = 560, scenario_height = 600;
constexpr render::Color first_skin = render::palette::clay, second_skin{0.66, 0.74, 0.80};

// A Walker is one of the two, in the world, after the query.
struct Walker {
  std::vector<Point3> vertices;
  std::vector<bool> touches;         // by vertex: of a triangle that touches the other walker
  std::vector<bool> refitted;        // by node: by the query
  std::vector<Ball3<double>> balls;  // by node
};

struct Met {
  Walker walkers[2];
  std::size_t pairs;
};

// Checks that what FrameRefits says of each node adds up to what it says of each level.
void check(const SphereTree& tree, const std::vector<bool>& refitted, const std::vector<long>& by_level) {
  std::vector<long> counts(tree.level_count());
  for (std::size_t n = 0; n < refitted.size(); ++n) counts[tree.nodes[n].level - 1] += refitted[n];
  if (counts != by_level) throw std::logic_error("scenario figures: the refitted nodes are not as many as were counted");
}

Met meet(const AnimatedCharacter& c, const RefitVariant& variant, const ScenarioFrame& frame) {
  Body first(c, variant), second(c, variant);
  first.begin(frame.first), second.begin(frame.second);
  QueryCounts counts;
  const auto pairs = collide({first, frame.first_at}, {second, frame.second_at}, Query::full, counts);
  Met out{{}, pairs.size()};
  const auto finish = [&](Walker& w, Body& body, const Pose& pose, const RigidTransform<double>& at) {
    w.refitted.resize(c.tree.nodes.size());
    for (std::size_t n = 0; n < w.refitted.size(); ++n) w.refitted[n] = body.refits().is_refitted(static_cast<int>(n));
    check(c.tree, w.refitted, body.refits().refitted_by_level());
    for (std::size_t n = 0; n < w.refitted.size(); ++n) {  // which refits the others, now that the marks are taken
      const Ball3<double>& ball = body.ball(static_cast<int>(n));
      w.balls.push_back({apply(at, ball.center), ball.radius});
    }
    w.vertices = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose, variant.skinning), variant.skinning);
    for (Point3& v : w.vertices) v = apply(at, v);
    w.touches.resize(w.vertices.size());
  };
  finish(out.walkers[0], first, frame.first, frame.first_at);
  finish(out.walkers[1], second, frame.second, frame.second_at);
  for (const auto& [a, b] : pairs) {
    for (const int v : c.mesh.triangles[a]) out.walkers[0].touches[v] = true;
    for (const int v : c.mesh.triangles[b]) out.walkers[1].touches[v] = true;
  }
  return out;
}

// Returns the share of the level's nodes, of both walkers, that the query refitted.
double share_refitted(const SphereTree& tree, const Met& met, int level) {
  long refitted = 0, all = 0;
  for (const Walker& w : met.walkers)
    for (const int n : nodes_of_level(tree, level)) refitted += w.refitted[n], ++all;
  return static_cast<double>(refitted) / static_cast<double>(all);
}

void add_skins(render::Scene& scene, const SkinnedMesh& model, const Met& met) {
  for (const Walker& w : met.walkers) {
    render::MeshShape mesh = skin_shape(model, w.vertices);
    const render::Color color = &w == met.walkers ? first_skin : second_skin;
    for (const bool touches : w.touches) mesh.vertex_colors.push_back(touches ? figure_colors::touching : color);
    scene.meshes.push_back(std::move(mesh));
  }
}

const Scenario& named(const std::vector<Scenario>& all, const std::string& name) {
  for (const Scenario& e : all)
    if (e.name == name) return e;
  throw std::invalid_argument("no scenario named '" + name + "'");
}

void draw(const AnimatedCharacter& c, const std::string& scene_name, const std::string& figure, const Point3& from,
          const std::vector<int>& levels, PictureTable& pictures) {
  const auto all = scenarios(c, 1);
  const ScenarioFrame& frame = named(all, scene_name).frames[0];
  const char* const asked = "spherical_repaired";
  const Met met = meet(c, compared_variant(asked), frame);
  const Met ours = meet(c, default_variant(Skinning::spherical), frame);

  std::vector<Point3> points;
  for (const Walker& w : met.walkers) points.insert(points.end(), w.vertices.begin(), w.vertices.end());
  const auto camera = render::Camera::frame(points, from, double(scenario_width) / scenario_height, 0.1);
  const std::string file = c.mesh.name + "_" + scene_name + "_";
  render::Scene bare;
  add_skins(bare, c.mesh, met);
  pictures.draw(bare, camera, {.width = scenario_width, .height = scenario_height}, {figure, c.mesh.name, scene_name, asked},
                file + "bare.png",
                {{"touching_pairs", static_cast<double>(met.pairs)}, {"tree_levels", static_cast<double>(c.tree.level_count())}});
  for (const int level : levels_there(c.tree, levels)) {
    render::Scene scene;
    add_skins(scene, c.mesh, met);
    for (const Walker& w : met.walkers)
      for (const int n : nodes_of_level(c.tree, level))
        if (w.refitted[n]) scene.balls.push_back({w.balls[n], figure_colors::holding, 0.16});
        else scene.balls.push_back({w.balls[n], figure_colors::idle, 0.03});
    pictures.draw(scene, camera, {.width = scenario_width, .height = scenario_height},
                  {figure, c.mesh.name, scene_name, asked, level}, file + "level" + std::to_string(level) + ".png",
                  {{"share_of_nodes_refitted", share_refitted(c.tree, met, level)},
                   {"share_of_nodes_refitted_by_default", share_refitted(c.tree, ours, level)}});
  }
}

}  // namespace

void draw_walking(const AnimatedCharacter& c, PictureTable& pictures) {
  draw(c, "light", "walking", {0.35, 0.2, 1}, {6, 9}, pictures);
}

void draw_walk_through(const AnimatedCharacter& c, PictureTable& pictures) {
  draw(c, "worst", "walk_through", {1, 0.3, 0.6}, {4, 6}, pictures);
}

}  // namespace refitlab
