#include "experiments/report/twist_figures.hpp"

#include "algorithms/refit/variants.hpp"
#include "algorithms/skinning/skin.hpp"
#include "experiments/report/character_scene.hpp"

namespace refitlab {
namespace {

constexpr int width = 480, height = 600;

// A skin and the balls of the whole tree around it.
struct Dressed {
  std::string name, caption;  // name: in file names
  std::vector<Point3> vertices;
  std::vector<Ball3<double>> balls;
};

std::vector<Dressed> dress(const Character& c, const NamedPosture& posture) {
  std::vector<Dressed> out{{"reference", "reference posture, smallest balls", c.model.vertices, {}}};
  for (const TreeNode& n : c.tree.nodes) out[0].balls.push_back(n.reference);
  const auto add = [&](const std::string& caption, const char* variant_name) {
    const RefitVariant& variant = refit_variant(variant_name);
    const auto pose = make_skinning_pose(c.model, c.sets, posture.posture, variant.skinning);
    out.push_back({variant.name, caption, skin(c.model, c.sets, pose, variant.skinning), c.refit_all(variant, pose)});
  };
  add("linear blending, [Kavan and Zara 2005a]", "linear");
  add("spherical blending, Algorithm 1 as printed", "spherical_printed");
  add("spherical blending, Algorithm 1 repaired", "spherical_repaired");
  add("spherical blending, the tightest (control_clusters)", "control_clusters");
  return out;
}

render::Camera frame_all(const std::vector<Dressed>& all) {
  std::vector<Point3> points;
  for (const Dressed& d : all) points.insert(points.end(), d.vertices.begin(), d.vertices.end());
  return render::Camera::frame(points, {0.55, 0.25, 1}, double(width) / height, 0.08);
}

std::string count(long n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); }

std::string said_of(const Misses& m) {
  if (m.ball_count() == 0) return "none misses a vertex";
  return count(m.ball_count(), "misses a vertex", "miss a vertex") +
         (m.undefined ? " (" + count(m.undefined, "is", "are") + " no ball at all)" : "");
}

}  // namespace

std::vector<Figure> twist_figures(const Character& c, const NamedPosture& posture, const std::string& folder) {
  const auto all = dress(c, posture);
  const render::Camera camera = frame_all(all);
  const auto draw = [&](const Dressed& d, const render::Scene& scene, const std::string& what,
                        const std::string& caption) {
    return rendered(scene, camera, {.width = width, .height = height}, caption,
                    folder + "/" + c.model.name + "_" + d.name + "_" + what + ".png");
  };

  Figure bare{c.model.name + ": two ways to blend (the paper's Figure 1)",
              "The posture is “" + posture.name +
                  "”. Linear blending averages matrices: where joints turn far apart the skin "
                  "collapses, the candy-wrapper. Spherical blending averages rotations.",
              {},
              {},
              3};
  const std::pair<int, const char*> bare_captions[] = {
      {0, "reference posture"}, {1, "linear blending: candy-wrappers"}, {3, "spherical blending"}};
  for (const auto& [index, caption] : bare_captions) {
    render::Scene scene;
    scene.meshes.push_back(skin_shape(c.model, all[index].vertices));
    bare.pictures.push_back(draw(all[index], scene, "bare", caption));
  }

  Figure balls{c.model.name + ": bounding spheres of two levels of the tree (the paper's Figure 5)",
               "Refitted from the joints and precomputed weight bounds, without looking at a vertex.",
               {{figure_colors::holding, "a ball that holds all its vertices"},
                {figure_colors::missing, "a ball that misses one, and the vertices outside"},
                {figure_colors::without, "vertices whose “ball” has a negative radius or is no number"}},
               {},
               5};
  for (const int level : levels_there(c.tree, {4, 6}))
    for (const Dressed& d : all) {
      const auto nodes = nodes_of_level(c.tree, level);
      std::vector<Ball3<double>> of_level;
      for (const int n : nodes) of_level.push_back(d.balls[n]);
      const Misses misses = find_misses(c, nodes, of_level, d.vertices);
      render::Scene scene;
      scene.meshes.push_back(skin_shape(c.model, d.vertices));
      for (std::size_t b = 0; b < of_level.size(); ++b)
        if (is_defined(of_level[b]))
          scene.balls.push_back({of_level[b], misses.balls[b] ? figure_colors::missing : figure_colors::holding, 0.1});
      const double size = c.tree.nodes[0].reference.radius;
      mark_vertices(scene, d.vertices, misses.outside, figure_colors::missing, size);
      mark_vertices(scene, d.vertices, misses.without, figure_colors::without, size);
      balls.pictures.push_back(draw(d, scene, "level" + std::to_string(level),
                                    "level " + std::to_string(level) + ": " + d.caption + "; of " +
                                        count(static_cast<long>(nodes.size()), "ball", "balls") + " " +
                                        said_of(misses)));
    }
  return {bare, balls};
}

}  // namespace refitlab
