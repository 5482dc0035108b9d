// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/scene.hpp"

#include <stdexcept>

namespace refitlab::render {
namespace {

void require(bool good, const char* kind, std::size_t index, const char* reason) {
  if (!good) throw std::invalid_argument(std::string("scene: ") + kind + " " + std::to_string(index) + ": " + reason);
}

bool is_opacity(double x) { return x >= 0 && x <= 1; }

}  // namespace

Box<double> Scene::bounds() const {
  auto box = Box<double>::empty();
  const auto extend = [&](const Point3& center, double radius) {
    Box<double> own{center, center};
    own.grow(radius);
    box.merge(own);
  };
  for (const auto& mesh : meshes)
    for (const auto& vertex : mesh.vertices) box.merge(vertex);
  for (const auto& [ball, color, opacity] : balls) extend(ball.center, ball.radius);
  for (const auto& line : lines)
    for (const auto& point : line.points) extend(point, line.radius);
  return box;
}

void Scene::validate() const {
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto& mesh = meshes[i];
    const auto count = mesh.vertices.size();
    require(is_opacity(mesh.opacity), "mesh", i, "the opacity must be in [0, 1]");
    require(mesh.vertex_colors.empty() || mesh.vertex_colors.size() == count, "mesh", i,
            "there must be a colour per vertex, or none");
    for (const auto& vertex : mesh.vertices) require(vertex.allFinite(), "mesh", i, "a vertex is not finite");
    for (const auto& triangle : mesh.triangles)
      for (const int v : triangle)
        require(v >= 0 && std::size_t(v) < count, "mesh", i, "a triangle names a vertex that does not exist");
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto& [ball, color, opacity] = balls[i];
    require(is_opacity(opacity), "ball", i, "the opacity must be in [0, 1]");
    require(ball.center.allFinite() && std::isfinite(ball.radius), "ball", i, "it is not finite");
    require(ball.radius >= 0, "ball", i, "the radius is negative");
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& line = lines[i];
    require(line.points.size() >= 2, "line", i, "it has fewer than two points");
    require(line.radius > 0 && std::isfinite(line.radius), "line", i, "the radius must be positive and finite");
    for (const auto& point : line.points) require(point.allFinite(), "line", i, "a point is not finite");
  }
}

}  // namespace refitlab::render
