// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/procedural/procedural_mesh.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>

namespace refitlab {
namespace {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<CgalPoint>;

Point3 to_point3(const CgalPoint& p) { return {p.x(), p.y(), p.z()}; }

Point3 place(const Mesh& mesh, Mesh::Vertex_index v) { return to_point3(mesh.point(v)); }

void move(Mesh& mesh, Mesh::Vertex_index v, const Point3& p) { mesh.point(v) = CgalPoint(p[0], p[1], p[2]); }

Mesh to_cgal(const SkinMesh& skin) {
  Mesh mesh;
  for (const Point3& p : skin.vertices) mesh.add_vertex(CgalPoint(p[0], p[1], p[2]));
  for (const auto& [a, b, c] : skin.triangles)
    if (mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c)) == Mesh::null_face())
      throw ModelError("generated mesh", "a triangle", "does not fit to its neighbours: the surface is no manifold");
  return mesh;
}

SkinMesh from_cgal(const Mesh& mesh) {  // of a mesh without removed elements
  SkinMesh skin;
  for (const auto v : mesh.vertices()) skin.vertices.push_back(place(mesh, v));
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    skin.triangles.push_back({int(mesh.source(h)), int(mesh.target(h)), int(mesh.target(mesh.next(h)))});
  }
  return skin;
}

Point3 twice_area_normal(const Point3& a, const Point3& b, const Point3& c) { return cross(Point3(b - a), Point3(c - a)); }

// Returns whether the triangles around v, except those that also contain `except`, keep facing their way when v moves to p.
bool folds_nothing(const Mesh& mesh, Mesh::Vertex_index v, const Point3& p, Mesh::Vertex_index except) {
  const Point3 old = place(mesh, v);
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const auto a = mesh.target(mesh.next(h)), b = mesh.source(h);
    if (a == except || b == except) continue;
    const Point3 before = twice_area_normal(old, place(mesh, a), place(mesh, b));
    const Point3 after = twice_area_normal(p, place(mesh, a), place(mesh, b));
    if (dot(before, after) <= 0.5 * norm(before) * norm(after)) return false;
  }
  return true;
}

// Returns the shape of a triangle, which is 1 if it is equilateral and 0 if it is degenerate.
double shape(const Point3& a, const Point3& b, const Point3& c) {
  const double squares =
      squared_distance<double, 3>(a, b) + squared_distance<double, 3>(b, c) + squared_distance<double, 3>(c, a);
  return 2 * std::sqrt(3.) * norm(twice_area_normal(a, b, c)) / squares;
}

// Returns the worst shape among the triangles around v, with v at p.
double worst_shape(const Mesh& mesh, Mesh::Vertex_index v, const Point3& p) {
  double worst = 1;
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
    worst = std::min(worst, shape(p, place(mesh, mesh.target(mesh.next(h))), place(mesh, mesh.source(h))));
  return worst;
}

// Returns the smallest cosine between a direction and the normal of a triangle around v, with v at p.
double worst_facing(const Mesh& mesh, Mesh::Vertex_index v, const Point3& p, const Point3& direction) {
  double worst = 1;
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const Point3 normal = twice_area_normal(p, place(mesh, mesh.target(mesh.next(h))), place(mesh, mesh.source(h)));
    worst = std::min(worst, dot(normal, direction) / norm(normal));
  }
  return worst;
}

// Returns the sum of the squared distances of p from the planes of the triangles around v, weighted by area.
double distance_to_planes(const Mesh& mesh, Mesh::Vertex_index v, const Point3& p) {
  double sum = 0;
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const Point3 corner = place(mesh, mesh.source(h));
    const Point3 normal = twice_area_normal(place(mesh, v), place(mesh, mesh.target(mesh.next(h))), corner);
    sum += sq(dot(normal, Point3(p - corner))) / norm(normal);
  }
  return sum;
}

// Returns the point to which an edge collapses. It is the middle, unless keeping one end is much truer to the shape, so that
// ridges and tips stay.
Point3 place_to_collapse_to(const Mesh& mesh, Mesh::Vertex_index a, Mesh::Vertex_index b) {
  const Point3 pa = place(mesh, a), pb = place(mesh, b), middle = (pa + pb) / 2;
  Point3 best = middle;
  double least = 0.4 * (distance_to_planes(mesh, a, middle) + distance_to_planes(mesh, b, middle));
  for (const Point3& end : {pa, pb}) {
    const double error = distance_to_planes(mesh, a, end) + distance_to_planes(mesh, b, end);
    if (error < least) least = error, best = end;
  }
  return best;
}

// Sizes are the sizes wanted at each vertex.
using Sizes = Mesh::Property_map<Mesh::Vertex_index, double>;

// Collapses an edge if it is shorter than `length` in terms of the size wanted there. That takes two
// triangles away and changes neither closedness, orientation, nor genus.
void collapse_if_short(Mesh& mesh, Mesh::Edge_index edge, double length, Sizes& sizes) {
  const auto h = mesh.halfedge(edge);
  const auto a = mesh.source(h), b = mesh.target(h);
  const double size = (sizes[a] + sizes[b]) / 2;
  if (squared_distance<double, 3>(place(mesh, a), place(mesh, b)) > sq(length * size)) return;
  const Point3 target = place_to_collapse_to(mesh, a, b);
  if (!folds_nothing(mesh, a, target, b) || !folds_nothing(mesh, b, target, a)) return;
  if (!CGAL::Euler::does_satisfy_link_condition(edge, mesh)) return;
  const auto kept = CGAL::Euler::collapse_edge(edge, mesh);
  move(mesh, kept, target);
  sizes[kept] = size;
}

// Collapses short edges, then longer ones, until the count is reached. `length` is where it begins, and then where it ended.
void thin_out(Mesh& mesh, int triangle_count, double& length, Sizes& sizes) {
  for (int round = 0; round < 200; ++round, length *= 1.04)
    for (const auto e : mesh.edges()) {  // those that are removed are skipped
      if (int(mesh.number_of_faces()) <= triangle_count) return;
      collapse_if_short(mesh, e, length, sizes);
    }
}

// Flips an edge if that brings the number of neighbours of its four vertices nearer to six, the number of neighbours in
// a grid of equilateral triangles, and folds nothing.
void flip_if_better(Mesh& mesh, Mesh::Edge_index edge) {
  const auto h = mesh.halfedge(edge), g = mesh.opposite(h);
  const auto a = mesh.source(h), b = mesh.target(h), left = mesh.target(mesh.next(h)), right = mesh.target(mesh.next(g));
  if (mesh.halfedge(left, right).is_valid()) return;
  int gain = 0;
  for (const auto& [v, change] : {std::pair(a, -1), std::pair(b, -1), std::pair(left, 1), std::pair(right, 1)}) {
    const int excess = int(mesh.degree(v)) - 6;
    gain += excess * excess - (excess + change) * (excess + change);
  }
  if (gain <= 0) return;
  const Point3 pa = place(mesh, a), pb = place(mesh, b), pl = place(mesh, left), pr = place(mesh, right);
  if (std::min(shape(pl, pa, pr), shape(pr, pb, pl)) < std::min({0.5, shape(pa, pb, pl), shape(pb, pa, pr)})) return;
  const Point3 before = twice_area_normal(pa, pb, pl).normalized() + twice_area_normal(pb, pa, pr).normalized();
  const Point3 after_a = twice_area_normal(pl, pa, pr), after_b = twice_area_normal(pr, pb, pl);
  constexpr double flat_enough = 0.8;  // cosine between the normals of the old pair and of the new triangles
  const double length = flat_enough * norm(before);
  if (dot(before, after_a) > length * norm(after_a) && dot(before, after_b) > length * norm(after_b))
    CGAL::Euler::flip_edge(h, mesh);
}

// Moves a vertex along the surface towards the middle of its triangles, each weighted by its area in terms of the
// wanted size. A vertex at a ridge that is thinner than its triangles is moved outwards first, so that it ends on the ridge,
// which is nearest to a point beyond it.
void relax(Mesh& mesh, Mesh::Vertex_index v, const ImplicitBody& body, const Sizes& sizes) {
  const Point3 p = place(mesh, v);
  Point3 sum = Point3::Zero(), normal = Point3::Zero();
  double total = 0, area = 0;
  std::vector<Point3> normals;
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const auto a = mesh.target(mesh.next(h)), b = mesh.source(h);
    const Point3 twice_area = twice_area_normal(p, place(mesh, a), place(mesh, b));
    const double weight = norm(twice_area) / sq(sizes[v] + sizes[a] + sizes[b]);
    sum += weight * (p + place(mesh, a) + place(mesh, b)) / 3;
    total += weight;
    area += norm(twice_area) / 2;
    normals.push_back(twice_area.normalized());
    normal += normals.back();
  }
  normal.normalize();
  const Point3 step = sum / total - p;
  Point3 target = p + step - dot(step, normal) * normal;
  constexpr double steep = 0.5;  // cosine between a triangle's normal and the mean
  if (std::any_of(normals.begin(), normals.end(), [&](const Point3& n) { return dot(n, normal) < steep; }))
    target += 0.3 * std::sqrt(area) * normal;
  const Point3 moved = body.project(target);
  // The move is judged by the mean normal and not, as folds_nothing() does, by each triangle's own, because a fold must be free
  // to unfold.
  if (worst_facing(mesh, v, moved, normal) >= std::min(0.2, worst_facing(mesh, v, p, normal)) &&
      worst_shape(mesh, v, moved) >= std::min(0.6, worst_shape(mesh, v, p)))
    move(mesh, v, moved);
}

}  // namespace

SkinMesh mesh_of(const ImplicitBody& body, double cell, int triangle_count, const std::function<double(const Point3&)>& size) {
  Mesh mesh = to_cgal(polygonise(body, cell));
  Sizes sizes = mesh.add_property_map<Mesh::Vertex_index, double>("size").first;
  for (const auto v : mesh.vertices()) sizes[v] = size(place(mesh, v));

  // This takes two steps, and goes back to the surface after each, because collapsing shrinks thin parts.
  double length = cell / 4;
  for (const int count : {3 * triangle_count, triangle_count}) {
    thin_out(mesh, count, length, sizes);
    for (const auto v : mesh.vertices()) move(mesh, v, body.project(place(mesh, v)));
  }
  if (int(mesh.number_of_faces()) != triangle_count)
    throw ModelError("generated mesh", std::to_string(mesh.number_of_faces()) + " triangles",
                     "cannot be brought to " + std::to_string(triangle_count));
  mesh.collect_garbage();
  for (int round = 0; round < 8; ++round) {
    for (const auto e : mesh.edges()) flip_if_better(mesh, e);
    for (const auto v : mesh.vertices()) relax(mesh, v, body, sizes);
  }
  return from_cgal(mesh);
}

}  // namespace refitlab
