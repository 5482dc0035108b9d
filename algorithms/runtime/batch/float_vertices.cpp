// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/float_vertices.hpp"

#include "algorithms/runtime/batch/joint_set_balls.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

FloatVertices::FloatVertices(const SkinnedMesh& mesh, const JointSets& sets, const PackedVertices& groups) {
  const DefaultFloatEnvironment environment;
  constexpr int lanes = Lanes<float>::count;
  const auto balls = joint_set_balls(mesh, sets);
  for (int group = 0; group < groups.group_count(); ++group) {
    const auto vertices = groups.vertices(group);
    for (std::size_t first = 0; first < vertices.size(); first += lanes) {
      const int set = sets.of_vertex(vertices[first]), joints = static_cast<int>(sets.joints(set).size());
      if (first == 0 || runs_.back().joint_set != set) runs_.push_back({set, joints, 0, static_cast<int>(data_.size())});
      data_.resize(data_.size() + 2 + joints);
      Lanes<float>* const block = data_.data() + data_.size() - 2 - joints;
      for (int lane = 0; lane < lanes; ++lane) {
        const int v = vertices[first + lane];
        const bool is_padding = first + lane > 0 && v == vertices[first + lane - 1];
        if (!is_padding) places_.push_back(static_cast<std::uint16_t>(first + lane)), ++runs_.back().vertex_count;
        const Point3 p = mesh.vertices[v] - balls[set].center;
        for (int i = 0; i < 3; ++i) block[i].lane[lane] = static_cast<float>(p[i]);
        for (int j = 1; j < joints; ++j) block[2 + j].lane[lane] = static_cast<float>(sets.weights(v)[j]);
      }
    }
    first_run_.push_back(static_cast<int>(runs_.size()));
    first_place_.push_back(static_cast<int>(places_.size()));
    block_count_.push_back(static_cast<int>(vertices.size()) / lanes);
    // Nothing is written over the padding of the last run.
    const int last = vertices.empty() ? 0 : runs_.back().vertex_count;
    const int end = static_cast<int>(places(group).size()) - last + lanes * blocks_for<float>(last);
    room_.push_back(lanes * blocks_for<float>(end));
  }
}

float FloatVertices::skin(int group, const FloatPaletteEntry* palette, float* out, Box<float>& box, Target target) const {
  const DefaultFloatEnvironment environment;
  const auto own = runs(group);
  return float_skin(target)(own.data(), static_cast<int>(own.size()), data_.data(), palette, room(group), out, box);
}

}  // namespace refitlab
