// SPDX-License-Identifier: GPL-3.0-or-later
// A Scene is what a picture shows, in model space and model units. y is up unless the camera says otherwise.
#pragma once

#include <vector>

#include "experiments/render/camera.hpp"
#include "experiments/render/image.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab::render {

struct MeshShape {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  Color color = palette::clay;
  double opacity = 1;                     // face on; below 1: seen through, denser where seen at grazing angles
  std::vector<Color> vertex_colors = {};  // one per vertex, in place of color; or empty
};

// A BallShape is a bounding sphere if it is translucent (with a thin darker outline), or a marker if it is opaque.
struct BallShape {
  Ball3<double> ball;
  Color color = palette::blue;
  double opacity = 0.15;
};

// A LineShape is a polyline with round ends. It has at least two points.
struct LineShape {
  std::vector<Point3> points;
  double radius;  // half the thickness, model units
  Color color = palette::black;
};

struct Scene {
  std::vector<MeshShape> meshes;
  std::vector<BallShape> balls;
  std::vector<LineShape> lines;

  Box<double> bounds() const;
  // Throws std::invalid_argument that names the shape and what is wrong with it, which is a number that is not finite, an index
  // out of range, an opacity outside [0, 1], a radius that is negative (balls) or not positive (lines).
  void validate() const;
};

}  // namespace refitlab::render
