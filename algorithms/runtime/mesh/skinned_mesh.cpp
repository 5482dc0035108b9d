// SPDX-License-Identifier: MIT
#include "algorithms/runtime/mesh/skinned_mesh.hpp"

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns why a point cannot be one of a model, or nothing if it can.
std::string reason_against(const Point3& p) {
  if (!p.allFinite()) return "is not finite";
  return p.lpNorm<Eigen::Infinity>() <= largest_coordinate ? "" : "is out of range, beyond 1e40";
}

void validate_influences(const SkinnedMesh& m, std::size_t vertex) {
  const std::string thing = "vertex " + std::to_string(vertex);
  const int joint_count = static_cast<int>(m.joints.size());
  double sum = 0;
  int last = -1;
  for (const Influence& i : m.influences[vertex]) {
    if (i.joint < 0 || i.joint >= joint_count)
      throw ModelError(m.name, thing,
                       "joint index " + std::to_string(i.joint) + " is out of range 0.." + std::to_string(joint_count - 1));
    if (i.joint <= last) throw ModelError(m.name, thing, "influences are not in increasing order of distinct joints");
    last = i.joint;
    if (!(i.weight > 0 && i.weight <= 1)) throw ModelError(m.name, thing, "a weight is not in (0, 1]");
    if (std::ldexp(i.weight, 24) != std::floor(std::ldexp(i.weight, 24)))
      throw ModelError(m.name, thing, "a weight is not a multiple of 2^-24");
    sum += i.weight;  // exact: multiples of 2^-24 below 1
  }
  if (sum != 1) throw ModelError(m.name, thing, "the weights do not sum to 1");
}

void validate_displacements(const SkinnedMesh& m, std::size_t vertex) {
  const std::string thing = "vertex " + std::to_string(vertex);
  int last = -1;
  for (const Displacement<double>& d : m.targets.of_vertex[vertex]) {
    if (d.target <= last || d.target >= m.targets.count)
      throw ModelError(m.name, thing, "displacements are not by increasing targets of the mesh");
    last = d.target;
    if (const auto reason = reason_against(d.by); !reason.empty()) throw ModelError(m.name, thing, "its displacement " + reason);
  }
}

}  // namespace

void validate(const SkinnedMesh& m) {
  const DefaultFloatEnvironment environment;
  if (m.joints.empty()) throw ModelError(m.name, "skeleton", "no joints");
  if (m.vertices.empty() || m.triangles.empty())
    throw ModelError(m.name, "mesh", "no triangles, or none of three vertices that differ");
  if (m.influences.size() != m.vertices.size()) throw ModelError(m.name, "mesh", "not one list of influences a vertex");
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    const std::string thing = "joint " + std::to_string(j) + " (" + m.joints[j].name + ")";
    if (m.joints[j].parent < -1 || m.joints[j].parent >= static_cast<int>(j))
      throw ModelError(m.name, thing, "its parent does not come before it");
    if (const auto reason = reason_against(m.joints[j].origin); !reason.empty())
      throw ModelError(m.name, thing, "its origin " + reason);
  }
  for (std::size_t v = 0; v < m.vertices.size(); ++v) {
    if (const auto reason = reason_against(m.vertices[v]); !reason.empty())
      throw ModelError(m.name, "vertex " + std::to_string(v), "its position " + reason);
    validate_influences(m, v);
  }
  if (m.targets.count < 0 || m.targets.of_vertex.size() != (m.targets.count == 0 ? 0 : m.vertices.size()))
    throw ModelError(m.name, "morph targets", "not one list of displacements a vertex");
  for (std::size_t v = 0; v < m.targets.of_vertex.size(); ++v) validate_displacements(m, v);
  const int vertex_count = static_cast<int>(m.vertices.size());
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (const int v : m.triangles[t])
      if (v < 0 || v >= vertex_count)
        throw ModelError(m.name, "triangle " + std::to_string(t), "vertex index " + std::to_string(v) + " is out of range");
}

Pose reference_pose(const SkinnedMesh& m) { return Pose(m.joints.size()); }

}  // namespace refitlab
