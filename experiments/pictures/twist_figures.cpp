// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/twist_figures.hpp"

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/pictures/character_scene.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr int twist_width = 480, twist_height = 600;

// Dressed is a skin and the balls of the whole tree around it.
struct Dressed {
  std::string name;  // of the variant, or "reference"
  std::vector<Point3> vertices;
  std::vector<Ball3<double>> balls;
};

std::vector<Dressed> dress(const AnimatedCharacter& c, const NamedPose& pose) {
  std::vector<Dressed> out{{"reference", c.mesh.vertices, {}}};
  for (const TreeNode& n : c.tree.nodes) out[0].balls.push_back(n.reference);
  for (const char* name : {"linear", "spherical_printed", "spherical_repaired", "control_many_pieces"}) {
    const RefitVariant& variant = compared_variant(name);
    const auto palette = make_skinning_palette(c.mesh, c.sets, pose.pose, variant.skinning);
    out.push_back({variant.name, skin(c.mesh, c.sets, palette, variant.skinning), refit_all(c, variant, palette)});
  }
  return out;
}

render::Camera frame_all(const std::vector<Dressed>& all) {
  std::vector<Point3> points;
  for (const Dressed& d : all) points.insert(points.end(), d.vertices.begin(), d.vertices.end());
  return render::Camera::frame(points, {0.55, 0.25, 1}, double(twist_width) / twist_height, 0.08);
}

}  // namespace

void draw_twist(const AnimatedCharacter& c, const NamedPose& pose, PictureTable& pictures) {
  const auto all = dress(c, pose);
  const render::Camera camera = frame_all(all);
  const auto draw = [&](const Dressed& d, const render::Scene& scene, const std::string& figure, int level,
                        const std::vector<PictureNumber>& numbers) {
    const std::string what = level ? "level" + std::to_string(level) : "bare";
    pictures.draw(scene, camera, {.width = twist_width, .height = twist_height}, {figure, c.mesh.name, pose.name, d.name, level},
                  c.mesh.name + "_" + d.name + "_" + what + ".png", numbers);
  };

  for (const int index : {0, 1, 3}) {  // no skin twice: the reference, linear and spherical blending
    render::Scene scene;
    scene.meshes.push_back(skin_shape(c.mesh, all[index].vertices));
    draw(all[index], scene, "twist_bare", 0, {});
  }
  for (const int level : levels_there(c.tree, {4, 6}))
    for (const Dressed& d : all) {
      const auto nodes = nodes_of_level(c.tree, level);
      std::vector<Ball3<double>> of_level;
      for (const int n : nodes) of_level.push_back(d.balls[n]);
      const Misses misses = find_misses(c, nodes, of_level, d.vertices);
      render::Scene scene;
      scene.meshes.push_back(skin_shape(c.mesh, d.vertices));
      for (std::size_t b = 0; b < of_level.size(); ++b)
        if (is_defined(of_level[b]))
          scene.balls.push_back({of_level[b], misses.balls[b] ? figure_colors::missing : figure_colors::holding, 0.1});
      const double size = c.tree.nodes[0].reference.radius;
      mark_vertices(scene, d.vertices, misses.outside, figure_colors::missing, size);
      mark_vertices(scene, d.vertices, misses.without, figure_colors::without, size);
      draw(d, scene, "twist_balls", level, counts_of(nodes.size(), misses));
    }
}

}  // namespace refitlab
