// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/simplex_pieces.hpp"

#include <algorithm>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

SimplexPiece piece_of(const Character& c, int joint_set, const std::vector<int>& vertices, int target) {
  const auto first = c.sets.weights(vertices[0]);
  std::vector<Point3> points;
  std::vector<double> low(first.begin(), first.end());
  for (const int v : vertices) {
    points.push_back(c.mesh.vertices[v]);
    for (std::size_t i = 0; i < low.size(); ++i) low[i] = std::min(low[i], c.sets.weights(v)[i]);
  }
  double rest = 1;
  for (const double l : low) rest -= l;
  return {joint_set, float_ball(points), box_around<double>(points), low, std::max(rest, 0.0), target};
}

}  // namespace

Ball3<double> float_ball(const std::vector<Point3>& points) {
  const DefaultFloatEnvironment environment;
  const Point3 center = smallest_ball<double, 3>(points).center.cast<float>().cast<double>();
  double radius = 0;
  for (const Point3& p : points) radius = std::max(radius, (p - center).norm());
  return {center, float_above(radius * (1 + 1e-15))};
}

std::map<int, std::vector<int>> by_joint_set(const JointSets& sets, std::span<const int> vertices) {
  std::map<int, std::vector<int>> out;
  for (const int v : vertices) out[sets.of_vertex(v)].push_back(v);
  return out;
}

std::vector<SimplexPiece> pieces_of_vertices(const Character& c, std::span<const std::vector<int>> lists) {
  const DefaultFloatEnvironment environment;
  std::vector<SimplexPiece> pieces;
  for (std::size_t target = 0; target < lists.size(); ++target)
    for (const auto& [set, vertices] : by_joint_set(c.sets, lists[target]))
      pieces.push_back(piece_of(c, set, vertices, static_cast<int>(target)));
  return pieces;
}

std::vector<SimplexPiece> pieces_of_nodes(const Character& c, std::span<const int> nodes) {
  std::vector<std::vector<int>> lists;
  for (const int n : nodes) lists.emplace_back(c.vertices[n].begin(), c.vertices[n].end());
  return pieces_of_vertices(c, lists);
}

}  // namespace refitlab
