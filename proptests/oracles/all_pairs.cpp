// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/all_pairs.hpp"

#include <algorithm>

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

std::vector<TrianglePair> all_pairs(const Posed& a, const Posed& b, Skinning skinning) {
  const auto p = a.vertices(skinning), q = b.vertices(skinning);
  const auto &s = a.character.mesh.triangles, &t = b.character.mesh.triangles;
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = 0; j < t.size(); ++j)
      if (triangles_meet({p[s[i][0]], p[s[i][1]], p[s[i][2]]}, {q[t[j][0]], q[t[j][1]], q[t[j][2]]}))
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

}  // namespace proptests::oracle
