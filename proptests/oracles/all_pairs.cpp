// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/all_pairs.hpp"

#include <algorithm>
#include <span>

#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/skinning/skin.hpp"

namespace proptests::oracle {

using namespace refitlab;

std::vector<Point3> Posed::vertices(Skinning skinning) const {
  auto points =
      skin(character.mesh, character.sets, make_skinning_palette(character.mesh, character.sets, pose, skinning), skinning);
  for (auto& p : points) p = apply(at, p);
  return points;
}

std::vector<TrianglePair> sorted(std::vector<TrianglePair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<TrianglePair> all_pairs(const Triangles& a, const std::vector<Point3>& p, const Triangles& b,
                                    const std::vector<Point3>& q) {
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (triangles_meet({p[a[i][0]], p[a[i][1]], p[a[i][2]]}, {q[b[j][0]], q[b[j][1]], q[b[j][2]]}))
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

std::vector<TrianglePair> all_pairs(const Posed& a, const Posed& b, Skinning skinning) {
  return all_pairs(a.character.mesh.triangles, a.vertices(skinning), b.character.mesh.triangles, b.vertices(skinning));
}

bool has_triangle(const ClusterTree& tree, int cluster, int triangle) {
  const std::span<const int> triangles(tree.triangles(cluster),
                                       static_cast<std::size_t>(tree.clusters()[cluster].triangle_count));
  return std::find(triangles.begin(), triangles.end(), triangle) != triangles.end();
}

}  // namespace proptests::oracle
