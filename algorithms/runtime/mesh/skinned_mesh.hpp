// SPDX-License-Identifier: MIT
// A SkinnedMesh is a triangle mesh, its joints, and the weight of each joint in each vertex (paper 3).
//
// Everything is in model space of the reference pose, right-handed, in the units of the source model. A Pose gives, for each
// joint, the rigid transform C_j that takes the reference pose to the animated pose. An AffinePose gives any affine transforms,
// by joints that scale, shear or mirror.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "lemmas/vocabulary/affine.hpp"
#include "lemmas/vocabulary/displacement.hpp"
#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

using Point3 = Vec<double, 3>;
using Triangle = std::array<int, 3>;  // indices of vertices, counter-clockwise seen from outside
using Pose = std::vector<RigidTransform<double>>;
using AffinePose = std::vector<AffineMap<double>>;

// This is the largest absolute coordinate of a mesh or a pose. Up to here, the sixth powers in determinants are in the range of
// double.
inline constexpr double largest_coordinate = 1e40;
// This is the largest absolute number in the matrix of an affine joint.
inline constexpr double largest_stretch = 1e4;

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

// Morph targets, or other coordinates, displace vertices. Before a vertex is skinned, it is moved by the sum over the targets of
// weight times displacement.
struct MorphTargets {
  int count = 0;
  std::vector<std::vector<Displacement<double>>> of_vertex = {};  // targets in increasing order; empty if count is 0
};

struct SkinnedMesh {
  std::string name;
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences;  // by vertex; distinct joints in increasing order, weights > 0
  MorphTargets targets = {};

  // Returns the displacements of a vertex by the targets that move it.
  std::span<const Displacement<double>> displacements(int vertex) const {
    return targets.count == 0 ? std::span<const Displacement<double>>() : targets.of_vertex[static_cast<std::size_t>(vertex)];
  }
};

// This is the error for a model that cannot be used. The message names the file (or the generated model), the thing, and the
// reason.
class ModelError : public std::runtime_error {
 public:
  ModelError(const std::string& file, const std::string& thing, const std::string& reason)
      : std::runtime_error(file + ": " + thing + ": " + reason) {}
};

// Throws ModelError unless the mesh fits the comments above: indices are in range, there is at least one triangle,
// coordinates are in range, and weights and displacements are as stated. Every source of meshes calls it last.
void validate(const SkinnedMesh& mesh);

// Returns the pose in which every joint stays where the reference pose has it.
Pose reference_pose(const SkinnedMesh& mesh);

}  // namespace refitlab
