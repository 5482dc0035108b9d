#include "experiments/rivals/brute_force.hpp"

#include <algorithm>

#include "algorithms/runtime/skinning/skin.hpp"

namespace refitlab {
namespace {

// The triangles of a body in the world, and their boxes: arrays by bound, so that the compiler can use its lanes.
struct Boxes {
  std::vector<TrianglePoints> triangles;
  std::vector<double> low[3], high[3];
};

Boxes boxes_of(const SkinnedMesh& model, const JointSets& sets, const Posture& posture,
               const RigidTransform<double>& placement, Skinning skinning) {
  const auto skinned = skin(model, sets, make_skinning_pose(model, sets, posture, skinning), skinning);
  Boxes out;
  for (const Triangle& t : model.triangles) {
    out.triangles.push_back(place(placement, {skinned[t[0]], skinned[t[1]], skinned[t[2]]}));
    for (int i = 0; i < 3; ++i) {
      const auto& [a, b, c] = out.triangles.back();
      out.low[i].push_back(std::min({a[i], b[i], c[i]}));
      out.high[i].push_back(std::max({a[i], b[i], c[i]}));
    }
  }
  return out;
}

}  // namespace

std::vector<TrianglePair> brute_force(const SkinnedMesh& model, const JointSets& sets, const EncounterFrame& frame,
                                      Skinning skinning) {
  const Boxes a = boxes_of(model, sets, frame.first, frame.first_at, skinning),
              b = boxes_of(model, sets, frame.second, frame.second_at, skinning);
  const std::size_t n = model.triangles.size();
  std::vector<TrianglePair> pairs;
  std::vector<unsigned char> overlap(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double low[] = {a.low[0][i], a.low[1][i], a.low[2][i]}, high[] = {a.high[0][i], a.high[1][i], a.high[2][i]};
    for (std::size_t j = 0; j < n; ++j) {
      int all = 1;  // without branches
      for (int k = 0; k < 3; ++k) all &= int(b.low[k][j] <= high[k]) & int(low[k] <= b.high[k][j]);
      overlap[j] = static_cast<unsigned char>(all);
    }
    for (std::size_t j = 0; j < n; ++j)
      if (overlap[j] && triangles_meet(a.triangles[i], b.triangles[j]))
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  }
  return pairs;
}

}  // namespace refitlab
