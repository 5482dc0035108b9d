// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/failing_figure.hpp"

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/pictures/character_scene.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/tightness/misses.hpp"

namespace refitlab {
namespace {

constexpr int failing_width = 480, failing_height = 600;

class FailingPose {
 public:
  FailingPose(const AnimatedCharacter& c, const NamedPose& pose, PictureTable& pictures)
      : c_(c),
        pictures_(pictures),
        pose_(pose),
        palette_(make_skinning_palette(c.mesh, c.sets, pose_.pose, Skinning::spherical)),
        vertices_(skin(c.mesh, c.sets, palette_, Skinning::spherical)),
        nodes_(nodes_of_level(c.tree, 0)),
        balls_(refit_all(c, compared_variant("spherical_printed"), palette_)),
        misses_(find_misses(c, nodes_, balls_, vertices_)),
        node_(coarsest_failure()) {}

  void draw() const {
    whole();
    if (node_ < 0) return;
    for (const char* name : {"spherical_printed", "spherical_repaired", "control_many_pieces"}) near(compared_variant(name));
  }

 private:
  // If from_outside is false, the eye is among the skin, where no light gets to.
  void draw(const render::Scene& scene, const std::vector<Point3>& framed, const Point3& from, bool from_outside,
            const std::string& what, const std::string& variant, int level, const std::vector<PictureNumber>& numbers) const {
    pictures_.draw(scene, render::Camera::frame(framed, from, double(failing_width) / failing_height, 0.15),
                   {.width = failing_width, .height = failing_height, .occlusion = from_outside},
                   {"failing", c_.mesh.name, pose_.name, variant, level}, c_.mesh.name + "_failing_" + what + ".png", numbers);
  }

  void whole() const {
    render::Scene scene;
    scene.meshes.push_back(skin_shape(c_.mesh, vertices_));
    const double size = c_.tree.nodes[0].reference.radius;
    mark_vertices(scene, vertices_, misses_.outside, figure_colors::missing, size);
    mark_vertices(scene, vertices_, misses_.without, figure_colors::without, size);
    std::vector<Point3> framed;
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      if (misses_.outside[v] || misses_.without[v]) framed.push_back(vertices_[v]);
    draw(scene, framed.empty() ? vertices_ : framed, {0.55, 0.25, 1}, true, "whole", "spherical_printed", 0,
         counts_of(balls_.size(), misses_));
  }

  // Takes the coarsest level on which a defined ball misses a vertex, and returns the node whose ball misses by most, or -1 if
  // there is none.
  int coarsest_failure() const {
    for (int level = 1; level <= c_.tree.level_count(); ++level) {
      const auto nodes = nodes_of_level(c_.tree, level);
      std::vector<Ball3<double>> balls;
      for (const int n : nodes) balls.push_back(balls_[n]);
      const int worst = find_misses(c_, nodes, balls, vertices_).worst_ball;
      if (worst >= 0) return nodes[worst];
    }
    return -1;
  }

  // Draws this node's ball, as a variant makes it, with the skin that it is to hold.
  void near(const RefitVariant& variant) const {
    const Ball3<double> ball = ball_by(variant);
    const Misses misses = find_misses(c_, std::vector{node_}, std::vector{ball}, vertices_);
    const auto framed = around_node();
    render::Scene scene;
    render::MeshShape part = skin_shape(c_.mesh, vertices_), rest = part;
    part.triangles.clear();
    const TreeNode& n = c_.tree.nodes[node_];
    for (int t = 0; t < n.triangle_count; ++t)
      part.triangles.push_back(c_.mesh.triangles[c_.tree.triangle_order[n.first_triangle + t]]);
    part.color = render::palette::yellow;
    for (Point3& v : part.vertices) v += 1e-4 * norm<double, 3>(framed.back() - framed.front()) * view().normalized();
    scene.meshes.push_back(part), scene.meshes.push_back(rest);
    const bool fails = misses.ball_count() > 0;
    scene.balls.push_back({ball, fails ? figure_colors::missing : figure_colors::holding, 0.25});
    const double size = norm<double, 3>(framed.back() - framed.front());
    std::vector<bool> inside(vertices_.size());
    for (const int v : c_.vertices[node_]) inside[v] = !misses.outside[v];
    mark_vertices(scene, vertices_, misses.outside, figure_colors::missing, 2 * size);
    mark_vertices(scene, vertices_, inside, figure_colors::holding, 2 * size);
    std::vector<PictureNumber> numbers = counts_of(1, misses);
    numbers.push_back({"radius", ball.radius, "model unit"});
    numbers.push_back({"worst_miss", misses.worst, "model unit"});
    draw(scene, framed, view(), false, variant.name, variant.name, n.level, numbers);
  }

  Ball3<double> ball_by(const RefitVariant& variant) const {
    return variant.refit(c_.refit_node(node_, palette_, variant.pieces));
  }

  // Returns the place that all near pictures show. It is that of the repaired ball, which is the widest.
  std::vector<Point3> around_node() const {
    const Ball3<double> ball = ball_by(compared_variant("spherical_repaired"));
    std::vector<Point3> points;
    for (const int side : {-1, 1})
      for (int axis = 0; axis < 3; ++axis) points.push_back(ball.center + 0.9 * side * ball.radius * Point3::Unit(axis));
    return points;
  }
  // Returns the direction from which the node's triangles are seen from outside.
  Point3 view() const {
    Point3 normal = Point3::Zero();
    const TreeNode& n = c_.tree.nodes[node_];
    for (int t = 0; t < n.triangle_count; ++t) {
      const Triangle& triangle = c_.mesh.triangles[c_.tree.triangle_order[n.first_triangle + t]];
      normal += (vertices_[triangle[1]] - vertices_[triangle[0]]).cross(vertices_[triangle[2]] - vertices_[triangle[0]]);
    }
    const Point3 tilted = normal.normalized() + Point3(0.2, 0, 0.2);
    return tilted.cross(Point3::UnitY()).norm() > 0.1 ? tilted : Point3::UnitZ();
  }

  const AnimatedCharacter& c_;
  PictureTable& pictures_;
  const NamedPose& pose_;
  const SkinningPalette<double> palette_;
  const std::vector<Point3> vertices_;
  const std::vector<int> nodes_;
  const std::vector<Ball3<double>> balls_;
  const Misses misses_;
  const int node_;
};

}  // namespace

void draw_failing(const AnimatedCharacter& character, const NamedPose& worst, PictureTable& pictures) {
  FailingPose(character, worst, pictures).draw();
}

}  // namespace refitlab
