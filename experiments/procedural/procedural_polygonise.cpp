// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "experiments/procedural/procedural_mesh.hpp"

namespace refitlab {
namespace {

using Index3 = std::array<int, 3>;

class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const ImplicitBody& body, double cell) : body_(body), cell_(cell) {}

  SkinMesh run() {
    int size = 1;
    while (size * cell_ < (body_.high() - body_.low()).maxCoeff()) size *= 2;
    visit({0, 0, 0}, size);
    return std::move(mesh_);
  }

 private:
  // Halves the cube down to single cells, leaving out cubes that the surface cannot reach. The 2 makes up for parts
  // whose distance is approximate.
  void visit(const Index3& corner, int size) {
    const Point3 center = place(corner) + Point3::Constant(0.5 * size * cell_);
    if (std::abs(body_.distance(center)) > 2 * (0.87 * size * cell_)) return;
    if (size == 1) return march(corner);
    for (int octant = 0; octant < 8; ++octant) {
      Index3 child = corner;
      for (int axis = 0; axis < 3; ++axis) child[axis] += (octant >> axis & 1) * size / 2;
      visit(child, size / 2);
    }
  }

  // Marches through the six tetrahedra of a cell. There is one for each way from its lowest corner to its highest along three
  // edges.
  void march(const Index3& corner) {
    static constexpr std::array<Index3, 6> ways = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::size_t w = 0; w < ways.size(); ++w) {
      std::array<Index3, 4> tetrahedron = {corner, corner, corner, corner};
      for (int step = 0; step < 3; ++step)
        for (int later = step + 1; later < 4; ++later) ++tetrahedron[later][ways[w][step]];
      march_tetrahedron(tetrahedron, w < 3);
    }
  }

  void march_tetrahedron(const std::array<Index3, 4>& corners, bool positive) {
    std::array<Index3, 4> v;  // corners inside first
    int inside = 0;
    for (int i = 0; i < 4; ++i)
      if (value(corners[i]) < 0) {
        for (int j = 0; j < i; ++j) positive ^= value(corners[j]) >= 0;  // the swaps that bring it forward
        v[inside++] = corners[i];
      }
    for (int i = 0, next = inside; i < 4; ++i)
      if (value(corners[i]) >= 0) v[next++] = corners[i];
    if (inside == 0 || inside == 4) return;
    if (!positive) inside <= 2 ? std::swap(v[2], v[3]) : std::swap(v[0], v[1]);

    const auto cut = [&](int a, int b) { return vertex_on(v[a], v[b]); };
    if (inside == 1) mesh_.triangles.push_back({cut(0, 1), cut(0, 2), cut(0, 3)});
    if (inside == 3) mesh_.triangles.push_back({cut(0, 3), cut(1, 3), cut(2, 3)});
    if (inside == 2) {
      mesh_.triangles.push_back({cut(0, 2), cut(0, 3), cut(1, 3)});
      mesh_.triangles.push_back({cut(0, 2), cut(1, 3), cut(1, 2)});
    }
  }

  // Returns the vertex where the surface crosses a grid edge. It is kept off the edge's ends, so that no triangle degenerates.
  int vertex_on(Index3 a, Index3 b) {
    if (b < a) std::swap(a, b);  // then b - a is 0 or 1 along each axis
    const std::uint64_t direction = (b[0] - a[0]) * 4 + (b[1] - a[1]) * 2 + (b[2] - a[2]);
    const auto [known, is_new] = vertex_of_.try_emplace(key(a) * 8 + direction, static_cast<int>(mesh_.vertices.size()));
    if (is_new) {
      const double t = std::clamp(value(a) / (value(a) - value(b)), 0.1, 0.9);
      mesh_.vertices.push_back((1 - t) * place(a) + t * place(b));
    }
    return known->second;
  }

  double value(const Index3& i) {
    const auto [known, is_new] = value_of_.try_emplace(key(i), 0.);
    if (is_new) known->second = body_.distance(place(i));
    return known->second;
  }

  Point3 place(const Index3& i) const { return body_.low() + cell_ * Point3(i[0], i[1], i[2]); }
  static std::uint64_t key(const Index3& i) { return (std::uint64_t(i[0]) << 40) + (std::uint64_t(i[1]) << 20) + i[2]; }

  const ImplicitBody& body_;
  double cell_;
  std::unordered_map<std::uint64_t, double> value_of_;
  std::unordered_map<std::uint64_t, int> vertex_of_;
  SkinMesh mesh_;
};

}  // namespace

SkinMesh polygonise(const ImplicitBody& body, double cell) { return MarchingTetrahedra(body, cell).run(); }

}  // namespace refitlab
