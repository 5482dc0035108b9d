// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/baselines/brute_force.hpp"

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/skinning/skin.hpp"

namespace refitlab {
namespace {

// BoxedTriangles are the triangles of a body in the world, and their boxes.
struct BoxedTriangles {
  std::vector<TrianglePoints> triangles;
  std::vector<Box<double>> boxes;
};

BoxedTriangles boxes_of(const SkinnedMesh& model, const JointSets& sets, const Pose& pose,
                        const RigidTransform<double>& placement, Skinning skinning) {
  const auto skinned = skin(model, sets, make_skinning_palette(model, sets, pose, skinning), skinning);
  BoxedTriangles out;
  for (const Triangle& t : model.triangles) {
    out.triangles.push_back(place(placement, {skinned[t[0]], skinned[t[1]], skinned[t[2]]}));
    out.boxes.push_back(Box<double>::empty());
    for (const Point3& vertex : out.triangles.back()) out.boxes.back().merge(vertex);
  }
  return out;
}

}  // namespace

std::vector<TrianglePair> brute_force(const SkinnedMesh& model, const JointSets& sets, const ScenarioFrame& frame,
                                      Skinning skinning) {
  const BoxedTriangles a = boxes_of(model, sets, frame.first, frame.first_at, skinning),
                       b = boxes_of(model, sets, frame.second, frame.second_at, skinning);
  const std::size_t n = model.triangles.size();
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (!are_apart(a.boxes[i], b.boxes[j]) && triangles_meet(a.triangles[i], b.triangles[j]))
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

}  // namespace refitlab
