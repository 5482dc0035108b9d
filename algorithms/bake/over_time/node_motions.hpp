// SPDX-License-Identifier: GPL-3.0-or-later
// These functions bound how far, how fast and with how much bend the nodes of a skeleton move between two keys of an animation.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "algorithms/model/model.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {

// Returns the times that divide an animation so that every channel is smooth in between. They are 0, the duration, the keys'
// times between, and times at which splines of rotations are divided, until the quaternions of a part are certainly not zero.
// They are in seconds and in increasing order; there is at least one. Throws ModelError for a spline of rotations that comes too
// close to zero, where it turns without a bound.
std::vector<double> smooth_times(const std::string& file, const std::vector<SceneNode>& nodes, const Animation& animation);

// Returns smooth_times, and the last of them once more if it is the only one, or if the animation jumps there. The parts between
// them have all that the animation shows. The last part has what comes after the jump.
std::vector<double> part_times(const std::string& file, const std::vector<SceneNode>& nodes, const Animation& animation);

// Returns whether a node's transform or a weight jumps at this time, because two keys share it or a step ends.
bool jumps_at(const Animation& animation, double time);

// Returns the motion of a track's node against its parent from start to end, as below.
LinkMotion<double> track_motion(const NodeTrack& track, double start, double end);

// Returns the motion of a node that no track moves.
ChainMotion<double> still_link(const SceneNode& node);

// Returns, by node, the motion of each node against its parent from start to end (c2_channel_motion, c3_normalized_motion). These
// are two neighbours of smooth_times, or both are its last time, after which nothing moves. Lengths are in units of the file, and
// motions per second.
std::vector<ChainMotion<double>> link_motions(const std::vector<SceneNode>& nodes, const Animation& animation, double start,
                                              double end);

// Returns, by target, the motion of the weights of a track's morph targets from start to end, likewise. Sizes have no unit.
std::vector<Motion<double>> weight_motions(const WeightTrack& track, double start, double end);

// Returns the same of a mesh's weights, which stay if their track is nullptr.
std::vector<Motion<double>> weight_motions(const MorphedMesh& mesh, const WeightTrack* track, double start, double end);

// Returns, by node, the motion of each node against the scene, from that of the nodes against their parents (c4_chain_motion).
std::vector<ChainMotion<double>> chain_motions(const std::vector<SceneNode>& nodes,
                                               const std::vector<ChainMotion<double>>& links);

// A Stretch is how much the linear part of a transform lengthens a vector, at least and at most.
struct Stretch {
  double least, most;
};
Stretch stretch_of(const Eigen::Matrix4d& matrix);
inline Stretch widest_of(const Stretch& a, const Stretch& b) { return {std::min(a.least, b.least), std::max(a.most, b.most)}; }

// Returns the stretch of each node against its parent, from start to end as above. The least is 0 where a scale changes its sign.
std::vector<Stretch> stretches(const std::vector<SceneNode>& nodes, const Animation& animation, double start, double end);

// Returns how far the linear part of any joint's skin matrix is at most from the rotation that its chain's quaternions make. It
// follows from the nodes' stretches, and is infinite where one may vanish.
double defect_of(const BoundSkeleton& skeleton, const std::vector<Stretch>& links);

// This is the error of a point that a matrix carries, relative to the sum of the summands' sizes.
inline constexpr double rounding_of_image = 32 * std::numeric_limits<double>::epsilon() / 2;

// Holds how long at most the image of a vertex by a joint's offset is: with room for the rounding of the computed length, and as
// the sum of its terms, which may cancel.
struct ImageLength {
  double computed, summed;
};
// A vertex and its displacement by d are also made of what the file's own offset and coordinates are, which a renderer begins
// with.
ImageLength length_of_vertex(const Model& model, const Eigen::Matrix4d& offset, int vertex);
ImageLength length_of_displacement(const Model& model, const Eigen::Matrix4d& offset, int vertex, const Point3& d);

// Returns how many times the rounding errors of splines' quaternions are those of a slerp's, from start to end as above. They are
// greater because a spline's quaternion is shorter than its summands.
double growth_of_rounding(const Animation& animation, double start, double end);

// Returns the motion of a node against one of its ancestors, or against itself, where it rests.
ChainMotion<double> chain_below(const std::vector<SceneNode>& nodes, const std::vector<ChainMotion<double>>& links, int ancestor,
                                int node);

}  // namespace refitlab
