// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/build_displacements.hpp"

#include <map>

#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

DisplacementTable build_displacements(const SkinnedMesh& mesh, std::span<const std::vector<int>> lists) {
  const DefaultFloatEnvironment environment;
  DisplacementTable table;
  if (mesh.targets.count == 0) return table;
  for (const std::vector<int>& vertices : lists) {
    table.first.push_back(table.balls.size());
    std::map<int, std::vector<Point3>> by_target;
    for (const int v : vertices)
      for (const Displacement<double>& d : mesh.displacements(v)) by_target[d.target].push_back(d.by);
    for (auto& [target, points] : by_target) {
      if (points.size() < vertices.size()) points.push_back(Point3::Zero());
      const Ball3<double> ball =
          points.size() == 1 ? Ball3<double>{points[0], 0} : rounded_up(as_ball(smallest_ball<double, 3>(points)));
      table.balls.push_back({target, ball});
    }
  }
  table.first.push_back(table.balls.size());
  return table;
}

}  // namespace refitlab
