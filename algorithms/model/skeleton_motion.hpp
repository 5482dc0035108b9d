// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton of a model file in motion: a tree of nodes, tracks of keys, and the skin matrices that they give.
//
// Skin matrix of joint j at time t: M_j(t) = (global transform of its node at t) * (its offset matrix). If it is R K
// and a translation, with one K = s diag(+-1, 1, 1) for all joints and times, then K belongs to the reference pose:
// vertices are multiplied by K, offset matrices by its inverse, and M_j is the rigid C_j. Matrices act on columns;
// lengths in units of the file, times in seconds.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// The largest Frobenius norm of M^T M - I that is taken for the rounding of a file: 1e-3 in the scale along each axis.
inline constexpr double rigidity_tolerance = 3.5e-3;

// A node's transform by its parts: scaled, then rotated, then translated.
struct NodeTransform {
  Eigen::Vector3d translation, scale;
  Eigen::Quaterniond rotation;
};

struct SceneNode {
  std::string name;
  int parent;                              // index of a node that comes before this one, or -1
  Eigen::Matrix4d local;                   // to the parent's frame, where no clip moves it
  int source = -1;                         // its index in the file
  std::optional<NodeTransform> rest = {};  // local by its parts, where the file has these
};

struct BoundJoint {
  std::string name;
  int node;
  int parent;              // joint
  Eigen::Matrix4d offset;  // from the frame of the reference pose to that of the node
};

// What happens between two keys (glTF 2.0, appendix C). step: the value of the earlier one. linear: positions and scales go
// linearly, rotations along the shorter great arc. cubic: a cubic spline by the keys' tangents; rotations are normalised.
enum class Interpolation { step, linear, cubic };

template <class Value>
struct Key {
  double time;
  Value value;
};

// Tangents of a cubic spline at a key, per second: that of the curve before it, and that of the curve behind it.
template <class Value>
struct Tangents {
  Value into, out;
};

// At least one key, by non-decreasing time. Before the first key and after the last the channel stays.
template <class Value>
struct Channel {
  std::vector<Key<Value>> keys;
  Interpolation interpolation = Interpolation::linear;
  std::vector<Tangents<Value>> tangents;  // by key, of a cubic spline
};

// Where one node goes. Rotations are unit quaternions; those of cubic splines are as the file has them, nearly of unit length, and
// what comes of the spline is normalised.
struct NodeTrack {
  int node;
  Channel<Eigen::Vector3d> positions;
  Channel<Eigen::Quaterniond> rotations;
  Channel<Eigen::Vector3d> scales;
};

// The weights of the morph targets of the mesh that a node shows, all of them at a time.
struct WeightTrack {
  int node;
  Channel<Eigen::VectorXd> weights;
};

// Where two keys share a time, or a step ends, a channel jumps: a time has two sides then.
enum class Side { before, after };

struct Animation {
  std::string name;
  double duration = 0;
  std::vector<NodeTrack> tracks;                // of distinct nodes; a node without one stays as it is
  std::vector<WeightTrack> weight_tracks = {};  // of distinct nodes; a mesh without one keeps its weights
};

struct BoundSkeleton {
  std::string file;
  std::vector<SceneNode> nodes;
  std::vector<BoundJoint> joints;
};

struct PosedSkeleton {
  Pose pose;
  double rigidity_defect;  // the largest over the joints
};

Eigen::Matrix4d matrix_of(const NodeTransform& transform);

// The parts of a node's matrix: those that the file has, or others that make the same; of a mirror with a negative x factor.
// None where it shears or flattens.
std::optional<NodeTransform> parts_of(const SceneNode& node);

// Of a track's node, where its channels are at a time.
NodeTransform transform_at(const NodeTrack& track, double time, Side side = Side::after);

// By node, from those against the parents.
std::vector<Eigen::Matrix4d> global_transforms(const std::vector<SceneNode>& nodes, std::vector<Eigen::Matrix4d> locals);
std::vector<Eigen::Matrix4d> global_transforms(const std::vector<SceneNode>& nodes, const Animation& animation, double time,
                                               Side side = Side::after);

// M_j by joint, affine; from the transforms of the nodes against their parents, or at a time.
std::vector<Eigen::Matrix4d> skin_matrices(const BoundSkeleton& skeleton, const std::vector<Eigen::Matrix4d>& locals);
std::vector<Eigen::Matrix4d> skin_matrices(const BoundSkeleton& skeleton, const Animation& animation, double time,
                                           Side side = Side::after);

// The same for a palette.
AffinePose affine_pose(const BoundSkeleton& skeleton, const Animation& animation, double time, Side side = Side::after);

// By target.
Eigen::VectorXd weights_at(const WeightTrack& track, double time, Side side = Side::after);

// How far skin matrices are from rotations: the largest Frobenius norm of M^T M - I over the joints. Infinite where one
// mirrors or is not finite.
double rigidity_defect(const std::vector<Eigen::Matrix4d>& skin_matrices);

// K of the skin matrices at a time, by the determinant of the joint in the middle. The identity where it differs from
// that by rounding only.
Eigen::Matrix4d common_factor(const BoundSkeleton& skeleton, const Animation& animation, double time);

// C_j by joint: the rotation nearest to M_j, its quaternion in the half-space of its parent's (of a root, real part >=
// 0). Throws ModelError that names clip, joint and time where M_j is not rigid, within rigidity_tolerance.
PosedSkeleton pose(const BoundSkeleton& skeleton, const Animation& animation, double time, Side side = Side::after);

// The same of skin matrices; where: what the error says of them besides the joint, or nothing.
PosedSkeleton rigid_pose(const BoundSkeleton& skeleton, const std::vector<Eigen::Matrix4d>& skin_matrices,
                         const std::string& clip, const std::string& when);

// 0, the duration and the times of keys between, in order; evenly thinned to at most `limit`.
std::vector<double> key_times(const Animation& animation, std::size_t limit);

}  // namespace refitlab
