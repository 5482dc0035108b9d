// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/caster.hpp"

#include <algorithm>

namespace refitlab::render {
namespace {

double to_linear(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

Eigen::Array3d to_linear(const Color& c) { return {to_linear(c.red), to_linear(c.green), to_linear(c.blue)}; }

// Returns the face normals summed at the vertices, weighted by the triangle's angle there, so that tessellation hardly shows.
std::vector<Point3> vertex_normals(const MeshShape& mesh) {
  std::vector<Point3> normals(mesh.vertices.size(), Point3::Zero());
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point3 a = mesh.vertices[t[(i + 1) % 3]] - mesh.vertices[t[i]];
      const Point3 b = mesh.vertices[t[(i + 2) % 3]] - mesh.vertices[t[i]];
      const Point3 n = a.cross(b);
      if (n.norm() > 0) normals[t[i]] += std::atan2(n.norm(), a.dot(b)) * n.normalized();
    }
  for (auto& n : normals) n.normalize();
  return normals;
}

// A Collector collects every hit of a ray. It is a filter that writes the hit down and refuses it, so that the ray goes on.
struct Collector {
  RTCIntersectContext context;  // first: Embree hands back its address
  std::vector<RTCRayHit> hits;

  static void filter(const RTCFilterFunctionNArguments* arguments) {
    auto* self = reinterpret_cast<Collector*>(arguments->context);
    self->hits.push_back({rtcGetRayFromRayN(arguments->ray, 1, 0), rtcGetHitFromHitN(arguments->hit, 1, 0)});
    arguments->valid[0] = 0;
  }
};

template <class T>
T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, int numbers, std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, numbers * sizeof(T), count));
}

}  // namespace

Caster::Caster(const Scene& scene) {
  const Box<double> bounds = scene.bounds();
  center_ = bounds.is_empty() ? Point3(Point3::Zero()) : Point3(bounds.center());
  diagonal_ = bounds.is_empty() ? 1 : std::max(bounds.edges().norm(), 1e-6);
  // The scene is built by one thread, for one instruction set, so that the picture depends neither on cores nor on the processor.
  device_ = {rtcNewDevice("threads=1,max_isa=sse4.2"), [](RTCDevice d) {
               if (d) rtcReleaseDevice(d);
             }};
  if (!device_) throw std::runtime_error("Embree: cannot make a device");
  opaque_ = build(scene, true);
  translucent_ = build(scene, false);
  if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) throw std::runtime_error("Embree: cannot build the scene");
}

void Caster::add(Layer& layer, RTCGeometry geometry, Part part) const {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(layer.scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  layer.parts.push_back(std::move(part));
}

Caster::Layer Caster::build(const Scene& scene, bool opaque) const {
  Layer layer;
  layer.scene = {rtcNewScene(device_.get()), rtcReleaseScene};
  const auto flags = RTC_SCENE_FLAG_ROBUST | (opaque ? RTC_SCENE_FLAG_NONE : RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneFlags(layer.scene.get(), RTCSceneFlags(flags));
  const auto write = [&](float* to, const Point3& point) {
    for (int i = 0; i < 3; ++i) to[i] = float(point[i] - center_[i]);
  };
  const auto wanted = [&](double opacity) { return opacity > 0 && (opacity == 1) == opaque; };

  for (const auto& mesh : scene.meshes) {
    if (!wanted(mesh.opacity) || mesh.triangles.empty()) continue;
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3, mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) write(points + 3 * i, mesh.vertices[i]);
    auto* indices = buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3, mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) indices = std::copy(triangle.begin(), triangle.end(), indices);
    Part part;
    part.mesh = &mesh;
    part.normals = vertex_normals(mesh);
    if (mesh.vertex_colors.empty()) part.colors.push_back(to_linear(mesh.color));
    for (const auto& color : mesh.vertex_colors) part.colors.push_back(to_linear(color));
    add(layer, geometry, std::move(part));
  }

  Part balls;
  for (const auto& ball : scene.balls)
    if (wanted(ball.opacity) && ball.ball.radius > 0) {
      balls.balls.push_back(&ball);
      balls.colors.push_back(to_linear(ball.color));
    }
  if (!balls.balls.empty()) {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* points = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, balls.balls.size());
    for (const auto* shape : balls.balls) {
      write(points, shape->ball.center);
      points[3] = float(shape->ball.radius);
      points += 4;
    }
    add(layer, geometry, std::move(balls));
  }

  Part segments;
  std::size_t points_of_lines = 0;
  for (const auto& line : scene.lines) {
    segments.colors.insert(segments.colors.end(), line.points.size() - 1, to_linear(line.color));
    points_of_lines += line.points.size();
  }
  if (opaque && !segments.colors.empty()) {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    auto* points = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, points_of_lines);
    auto* starts = buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 1, segments.colors.size());
    unsigned index = 0;
    for (const auto& line : scene.lines)
      for (std::size_t i = 0; i < line.points.size(); ++i, ++index) {
        write(points + 4 * index, line.points[i]);
        points[4 * index + 3] = float(line.radius);
        if (i + 1 < line.points.size()) *starts++ = index;
      }
    add(layer, geometry, std::move(segments));
  }
  rtcCommitScene(layer.scene.get());
  return layer;
}

RTCRay Caster::embree_ray(const Point3& origin, const Point3& direction, double far) const {
  const Eigen::Vector3f o = (origin - center_).cast<float>(), d = direction.cast<float>();
  return {o[0], o[1], o[2], 0, d[0], d[1], d[2], 0, float(far), ~0u, 0, 0};
}

Surface Caster::mesh_surface(const Part& part, const Ray& ray, const RTCRayHit& hit) const {
  const MeshShape& mesh = *part.mesh;
  const Triangle& t = mesh.triangles[hit.hit.primID];
  const Point3 weights(1 - hit.hit.u - hit.hit.v, hit.hit.u, hit.hit.v);
  Surface s{};
  s.distance = hit.ray.tfar;
  s.point = Point3::Zero();
  for (int i = 0; i < 3; ++i) s.point += weights[i] * mesh.vertices[t[i]];
  const Point3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  s.from_inside = normal.dot(ray.direction) > 0;
  const double sign = s.from_inside ? -1 : 1;
  s.normal = s.face_normal = sign * normal.normalized();
  s.lifted = s.point;
  s.normal.setZero();
  for (int i = 0; i < 3; ++i) s.normal += sign * weights[i] * part.normals[t[i]];
  s.normal = s.normal.norm() > 1e-6 ? Point3(s.normal.normalized()) : s.face_normal;
  // The point is pulled up to the vertices' tangent planes (Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II):
  // otherwise the triangles of a coarse mesh show as facets where the light grazes them.
  for (int i = 0; i < 3; ++i) {
    const Point3 n = sign * part.normals[t[i]];
    s.lifted -= weights[i] * std::min(0.0, (s.point - mesh.vertices[t[i]]).dot(n)) * n;
  }
  s.color = part.colors[0];
  if (!mesh.vertex_colors.empty())
    s.color = weights[0] * part.colors[t[0]] + weights[1] * part.colors[t[1]] + weights[2] * part.colors[t[2]];
  s.opacity = mesh.opacity;
  return s;
}

std::optional<Surface> Caster::nearest_opaque(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit hit{embree_ray(ray.origin, ray.direction, std::numeric_limits<float>::infinity()), {}};
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(opaque_.scene.get(), &context, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  const Part& part = opaque_.parts[hit.hit.geomID];
  if (part.mesh) return mesh_surface(part, ray, hit);
  Surface s{};
  s.distance = hit.ray.tfar;
  s.point = s.lifted = ray.origin + s.distance * ray.direction;
  const Point3 normal = Point3(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z).normalized();
  s.normal = s.face_normal = normal.dot(ray.direction) > 0 ? Point3(-normal) : normal;
  s.color = part.colors[hit.hit.primID];
  return s;
}

std::vector<Surface> Caster::translucent(const Ray& ray, double far) const {
  std::vector<Surface> found;
  if (translucent_.parts.empty()) return found;
  Collector collector;
  rtcInitIntersectContext(&collector.context);
  collector.context.filter = Collector::filter;
  RTCRayHit hit{embree_ray(ray.origin, ray.direction, far), {}};
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(translucent_.scene.get(), &collector.context, &hit);

  // Embree may report a primitive more than once. For a ball it is only asked whether the ray meets it, and the two surfaces are
  // computed here.
  const auto id = [](const RTCRayHit& h) { return std::pair(h.hit.geomID, h.hit.primID); };
  auto& hits = collector.hits;
  std::sort(hits.begin(), hits.end(), [&](const auto& a, const auto& b) { return id(a) < id(b); });
  hits.erase(std::unique(hits.begin(), hits.end(), [&](const auto& a, const auto& b) { return id(a) == id(b); }), hits.end());
  for (const auto& h : hits) {
    const Part& part = translucent_.parts[h.hit.geomID];
    if (part.mesh) {
      found.push_back(mesh_surface(part, ray, h));
      continue;
    }
    const BallShape& shape = *part.balls[h.hit.primID];
    const auto& [center, radius] = shape.ball;
    const double middle = (center - ray.origin).dot(ray.direction);
    const double from_center = (ray.origin + middle * ray.direction - center).norm();
    const double half_chord = std::sqrt(std::max(0.0, (radius - from_center) * (radius + from_center)));
    for (const bool leaving : {false, true}) {
      Surface s{};
      s.distance = middle + (leaving ? half_chord : -half_chord);
      if (s.distance <= 0 || s.distance >= far) continue;
      s.point = s.lifted = ray.origin + s.distance * ray.direction;
      s.normal = s.face_normal = (leaving ? -1 : 1) * (s.point - center) / radius;
      s.color = part.colors[h.hit.primID];
      s.opacity = shape.opacity;
      s.from_inside = leaving;
      s.inside_silhouette = radius - from_center;
      found.push_back(s);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return found;
}

bool Caster::occluded(const Point3& point, const Point3& direction, double reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = embree_ray(point, direction, reach);
  rtcOccluded1(opaque_.scene.get(), &context, &ray);
  return ray.tfar < 0;
}

}  // namespace refitlab::render
