// SPDX-License-Identifier: MIT
// SkinnedMesh: a triangle mesh, its joints, and the weight of each joint in each vertex (paper 3).
//
// Frames: everything is in model space of the reference pose, right-handed, in the units of the source model. A Pose gives,
// for each joint, the rigid transform C_j that takes the reference pose to the animated pose.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

using Point3 = Vec<double, 3>;
using Triangle = std::array<int, 3>;  // indices of vertices, counter-clockwise seen from outside
using Pose = std::vector<RigidTransform<double>>;

// The largest absolute coordinate of a mesh or a pose. Up to here, the sixth powers in determinants are in the range of
// double.
inline constexpr double largest_coordinate = 1e40;

struct Joint {
  std::string name;
  int parent;     // the index of a joint that comes before this one, or -1
  Point3 origin;  // the origin of its local frame in the reference pose
};

// weight is a multiple of 2^-24, and the weights of a vertex sum to 1 exactly (see algorithms/runtime/mesh/quantize.hpp).
struct Influence {
  int joint;
  double weight;
};

struct SkinnedMesh {
  std::string name;
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences;  // by vertex; distinct joints in increasing order, weights > 0
};

// The error for a model that cannot be used. The message names the file (or the generated model), the thing, and the
// reason.
class ModelError : public std::runtime_error {
 public:
  ModelError(const std::string& file, const std::string& thing, const std::string& reason)
      : std::runtime_error(file + ": " + thing + ": " + reason) {}
};

// Throws ModelError unless the mesh fits the comments above: indices are in range, there is at least one triangle,
// coordinates are in range, and weights are as stated. Every source of meshes calls it last.
void validate(const SkinnedMesh& mesh);

// The pose in which every joint stays where the reference pose has it.
Pose reference_pose(const SkinnedMesh& mesh);

}  // namespace refitlab
