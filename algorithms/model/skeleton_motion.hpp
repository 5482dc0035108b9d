// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton of a model file is a tree of nodes. Tracks of keys move it and give the skin matrices.
//
// The skin matrix of joint j at time t is M_j(t) = (global transform of its node at t) * (its offset matrix). If it is R K and a
// translation, with one K = s diag(+-1, 1, 1) for all joints and times, then K belongs to the reference pose:
// vertices are multiplied by K, offset matrices by its inverse, and M_j is the rigid C_j. Matrices act on columns, lengths are in
// units of the file, and times are in seconds.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/runtime/mesh/skinned_mesh.hpp"

namespace refitlab {

// This is the largest Frobenius norm of M^T M - I that is taken for the rounding of a file. It allows for 1e-3 in the scale along
// each axis.
inline constexpr double rigidity_tolerance = 3.5e-3;

// A node's transform is given by its parts. It scales, then rotates, then translates.
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

// Interpolation says what happens between two keys (glTF 2.0, appendix C). step: the value of the earlier key stays. linear:
// positions and scales go linearly, and rotations along the shorter great arc. cubic: values follow a cubic spline by the keys'
// tangents; rotations are normalised.
enum class Interpolation { step, linear, cubic };

template <class Value>
struct Key {
  double time;
  Value value;
};

// A cubic spline has two tangents at a key, per second: that of the curve before it, and that of the curve behind it.
template <class Value>
struct Tangents {
  Value into, out;
};

// A Channel has at least one key, by non-decreasing time. Before the first key and after the last the channel stays.
template <class Value>
struct Channel {
  std::vector<Key<Value>> keys;
  Interpolation interpolation = Interpolation::linear;
  std::vector<Tangents<Value>> tangents;  // by key, of a cubic spline
};

// A NodeTrack moves one node. Rotations are unit quaternions. Those of cubic splines are as the file has them, nearly of unit
// length, and the spline's values are normalised.
struct NodeTrack {
  int node;
  Channel<Eigen::Vector3d> positions;
  Channel<Eigen::Quaterniond> rotations;
  Channel<Eigen::Vector3d> scales;
};

// A WeightTrack has the weights of the morph targets of the mesh that a node shows. A key has all of them.
struct WeightTrack {
  int node;
  Channel<Eigen::VectorXd> weights;
};

// A channel jumps where two keys share a time, or a step ends. Then that time has two sides.
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

// Returns the parts of a node's matrix. They are those that the file has, or others that make the same matrix; for a mirror the x
// factor is negative. Returns nothing if the matrix shears or flattens.
std::optional<NodeTransform> parts_of(const SceneNode& node);

// Returns the transform of a track's node at a time.
NodeTransform transform_at(const NodeTrack& track, double time, Side side);

// These return the global transforms by node, from those against the parents, or at a time.
std::vector<Eigen::Matrix4d> global_transforms(const std::vector<SceneNode>& nodes, std::vector<Eigen::Matrix4d> locals);
std::vector<Eigen::Matrix4d> global_transforms(const std::vector<SceneNode>& nodes, const Animation& animation, double time,
                                               Side side = Side::after);

// These return the affine M_j by joint, from the transforms of the nodes against their parents, or at a time.
std::vector<Eigen::Matrix4d> skin_matrices(const BoundSkeleton& skeleton, const std::vector<Eigen::Matrix4d>& locals);
std::vector<Eigen::Matrix4d> skin_matrices(const BoundSkeleton& skeleton, const Animation& animation, double time,
                                           Side side = Side::after);

// Returns the same as a pose for a palette.
AffinePose affine_pose(const BoundSkeleton& skeleton, const Animation& animation, double time);

// Returns the weights by target.
Eigen::VectorXd weights_at(const WeightTrack& track, double time, Side side = Side::after);

// Returns how far skin matrices are from rotations. It is the largest Frobenius norm of M^T M - I over the joints, and infinite
// if one mirrors or is not finite.
double rigidity_defect(const std::vector<Eigen::Matrix4d>& skin_matrices);

// Returns K of the skin matrices at a time, by the determinant of the joint in the middle. It is the identity if it differs from
// that by rounding only.
Eigen::Matrix4d common_factor(const BoundSkeleton& skeleton, const Animation& animation, double time);

// Returns C_j by joint. It has the rotation nearest to M_j, whose quaternion is in the half-space of its parent's (for a root,
// the real part is >= 0). Throws ModelError that names clip, joint and time if M_j is not rigid within rigidity_tolerance.
PosedSkeleton pose(const BoundSkeleton& skeleton, const Animation& animation, double time, Side side = Side::after);

// Returns the same from skin matrices. clip, which may be empty, and when are for error messages.
PosedSkeleton rigid_pose(const BoundSkeleton& skeleton, const std::vector<Eigen::Matrix4d>& skin_matrices,
                         const std::string& clip, const std::string& when);

// Returns 0, the duration and the times of keys between, in order, evenly thinned to at most `limit`.
std::vector<double> key_times(const Animation& animation, std::size_t limit);

// Returns the times from 0 on, so many a second, that are before the end, and the end, in seconds.
std::vector<double> times_at_rate(double rate, double end);

}  // namespace refitlab
