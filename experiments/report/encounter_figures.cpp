#include "experiments/report/encounter_figures.hpp"

#include <stdexcept>

#include "algorithms/skinning/skin.hpp"
#include "experiments/collisions/encounters.hpp"
#include "experiments/report/character_scene.hpp"
#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

constexpr int width = 560, height = 600;
constexpr render::Color first_skin = render::palette::clay, second_skin{0.66, 0.74, 0.80}, touching{0.835, 0.369, 0};

// One of the two, in the world, after the query.
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

// What FrameRefits says of each node must add up to what it says of each level.
void check(const SphereTree& tree, const std::vector<bool>& refitted, const std::vector<long>& by_level) {
  std::vector<long> counts(tree.level_count());
  for (std::size_t n = 0; n < refitted.size(); ++n) counts[tree.nodes[n].level - 1] += refitted[n];
  if (counts != by_level)
    throw std::logic_error("encounter figures: the refitted nodes are not as many as were counted");
}

Met meet(const Character& c, const RefitVariant& variant, const EncounterFrame& frame) {
  Body first(c, variant), second(c, variant);
  first.begin(frame.first), second.begin(frame.second);
  QueryCounts counts;
  const auto pairs = collide({first, frame.first_at}, {second, frame.second_at}, Query::full, counts);
  Met out{{}, pairs.size()};
  const auto finish = [&](Walker& w, Body& body, const Posture& posture, const RigidTransform<double>& at) {
    w.refitted.resize(c.tree.nodes.size());
    for (std::size_t n = 0; n < w.refitted.size(); ++n) w.refitted[n] = body.refits().is_refitted(static_cast<int>(n));
    check(c.tree, w.refitted, body.refits().refitted_by_level());
    for (std::size_t n = 0; n < w.refitted.size(); ++n) {  // which refits the others, now that the marks are taken
      const Ball3<double>& ball = body.ball(static_cast<int>(n));
      w.balls.push_back({apply(at, ball.center), ball.radius});
    }
    w.vertices =
        skin(c.model, c.sets, make_skinning_pose(c.model, c.sets, posture, variant.skinning), variant.skinning);
    for (Point3& v : w.vertices) v = apply(at, v);
    w.touches.resize(w.vertices.size());
  };
  finish(out.walkers[0], first, frame.first, frame.first_at);
  finish(out.walkers[1], second, frame.second, frame.second_at);
  for (const auto& [a, b] : pairs) {
    for (const int v : c.model.triangles[a]) out.walkers[0].touches[v] = true;
    for (const int v : c.model.triangles[b]) out.walkers[1].touches[v] = true;
  }
  return out;
}

// The share of the level's nodes, of both walkers, that the query refitted.
double share_refitted(const SphereTree& tree, const Met& met, int level) {
  long refitted = 0, all = 0;
  for (const Walker& w : met.walkers)
    for (const int n : nodes_of_level(tree, level)) refitted += w.refitted[n], ++all;
  return static_cast<double>(refitted) / static_cast<double>(all);
}

void add_skins(render::Scene& scene, const Model& model, const Met& met) {
  for (const Walker& w : met.walkers) {
    render::MeshShape mesh = skin_shape(model, w.vertices);
    const render::Color color = &w == met.walkers ? first_skin : second_skin;
    for (const bool touches : w.touches) mesh.vertex_colors.push_back(touches ? touching : color);
    scene.meshes.push_back(std::move(mesh));
  }
}

const Encounter& named(const std::vector<Encounter>& all, const std::string& name) {
  for (const Encounter& e : all)
    if (e.name == name) return e;
  throw std::invalid_argument("no encounter named '" + name + "'");
}

Figure figure(const Character& c, const std::string& scene_name, const std::string& title, const std::string& text,
              const Point3& from, const std::vector<int>& levels, const std::string& folder) {
  const auto all = encounters(c, 1);
  const EncounterFrame& frame = named(all, scene_name).frames[0];
  const Met met = meet(c, refit_variant("spherical_repaired"), frame);
  const Met ours = meet(c, default_variant(Skinning::spherical), frame);

  Figure out{c.model.name + ": " + title,
             text,
             {{touching, "triangles that touch"},
              {figure_colors::holding, "spheres that the query refitted"},
              {figure_colors::idle, "spheres that it never asked for (here refitted afterwards)"}},
             {},
             3};
  render::Scene bare;
  add_skins(bare, c.model, met);
  std::vector<Point3> points;
  for (const Walker& w : met.walkers) points.insert(points.end(), w.vertices.begin(), w.vertices.end());
  const auto camera = render::Camera::frame(points, from, double(width) / height, 0.1);
  const std::string file = folder + "/" + c.model.name + "_" + scene_name + "_";
  out.pictures.push_back(rendered(bare, camera, {.width = width, .height = height},
                                  format("%.0f pairs of triangles touch", static_cast<double>(met.pairs)),
                                  file + "bare.png"));
  for (const int level : levels_there(c.tree, levels)) {
    render::Scene scene;
    add_skins(scene, c.model, met);
    for (const Walker& w : met.walkers)
      for (const int n : nodes_of_level(c.tree, level))
        if (w.refitted[n]) scene.balls.push_back({w.balls[n], figure_colors::holding, 0.16});
        else scene.balls.push_back({w.balls[n], figure_colors::idle, 0.03});
    out.pictures.push_back(
        rendered(scene, camera, {.width = width, .height = height},
                 "level " + std::to_string(level) + ": Algorithm 1 repaired refitted " +
                     format("%.0f %% of the spheres; ", 100 * share_refitted(c.tree, met, level)) +
                     default_variant(Skinning::spherical).name +
                     format(" would have refitted %.0f %%", 100 * share_refitted(c.tree, ours, level)),
                 file + "level" + std::to_string(level) + ".png"));
  }
  return out;
}

}  // namespace

Figure walking_figure(const Character& c, const std::string& folder) {
  return figure(c, "light", "two pass each other (the paper's Figure 6)",
                "A query refits a sphere only when it gets there; the deeper, the fewer of a level. (In the paper’s "
                "frame it refitted 19 % of "
                "level 5 and 9 % of level 6, of a tree of nine levels; this one has " +
                    std::to_string(c.tree.level_count()) + ".)",
                {0.35, 0.2, 1}, {6, 9}, folder);
}

Figure walk_through_figure(const Character& c, const std::string& folder) {
  return figure(c, "worst", "two in one place (the paper's Figure 7)",
                "The worst case, as when they walk through each other: far more triangles touch than in practice.",
                {1, 0.3, 0.6}, {4, 6}, folder);
}

}  // namespace refitlab
