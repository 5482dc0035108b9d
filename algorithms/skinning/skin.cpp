#include "algorithms/skinning/skin.hpp"

#include "algorithms/packs/float_environment.hpp"
#include "algorithms/skinning/blend.hpp"

namespace refitlab {

std::vector<Point3> skin(const Model& model, const JointSets& sets, const SkinningPose<double>& pose, Skinning skinning) {
  const DefaultFloatEnvironment environment;
  std::vector<Point3> out;
  out.reserve(model.vertices.size());
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    const int v = static_cast<int>(i);
    out.push_back(blend<double>(skinning, pose[sets.of_vertex(v)], sets.weights(v), model.vertices[i]));
  }
  return out;
}

}  // namespace refitlab
