// SPDX-License-Identifier: GPL-3.0-or-later
// A Caster finds where rays meet the shapes of a scene, by Embree 3.
#pragma once

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <optional>

#include "experiments/render/scene.hpp"

namespace refitlab::render {

// A Surface is where a ray meets a shape. Normals have unit length and point towards where the ray came from.
struct Surface {
  double distance;  // along the ray
  Point3 point;
  Point3 normal;         // for shading: of a mesh it is interpolated
  Point3 face_normal;    // of the geometry
  Point3 lifted;         // point moved out to the smooth surface, from where light is looked for
  Eigen::Array3d color;  // linear, not sRGB
  double opacity = 1;
  bool from_inside = false;                                            // the ray leaves the shape here
  double inside_silhouette = std::numeric_limits<double>::infinity();  // of a ball: ball's radius minus ray's distance
};

class Caster {
 public:
  explicit Caster(const Scene& scene);  // keeps a reference
  std::optional<Surface> nearest_opaque(const Ray& ray) const;
  // Returns the translucent surfaces nearer than far, nearest first.
  std::vector<Surface> translucent(const Ray& ray, double far) const;
  // Returns whether something opaque is within reach of the point.
  bool occluded(const Point3& point, const Point3& direction, double reach) const;
  double diagonal() const { return diagonal_; }  // of the scene's bounds

 private:
  // A Part is one geometry of Embree's: a mesh, or all balls, or all line segments.
  struct Part {
    const MeshShape* mesh = nullptr;
    std::vector<Point3> normals;          // of a mesh, by vertex
    std::vector<const BallShape*> balls;  // by primitive
    std::vector<Eigen::Array3d> colors;   // linear; of the mesh (one) or its vertices, or by primitive
  };
  // A Layer is an Embree scene and what its geometries are, by Embree's geometry number.
  struct Layer {
    std::shared_ptr<RTCSceneTy> scene;
    std::vector<Part> parts;
  };
  Layer build(const Scene& scene, bool opaque) const;
  void add(Layer& layer, RTCGeometry geometry, Part part) const;
  RTCRay embree_ray(const Point3& origin, const Point3& direction, double far) const;
  Surface mesh_surface(const Part& part, const Ray& ray, const RTCRayHit& hit) const;

  Point3 center_;  // subtracted before coordinates become floats
  double diagonal_;
  std::shared_ptr<RTCDeviceTy> device_;
  Layer opaque_, translucent_;
};

}  // namespace refitlab::render
