// SPDX-License-Identifier: GPL-3.0-or-later
// How far, how fast and with how much bend the nodes of a skeleton move between two keys of an animation.
#pragma once

#include <vector>

#include "algorithms/model/skeleton_motion.hpp"
#include "lemmas/c4_chain_motion.hpp"

namespace refitlab {

// Times that divide an animation so that every channel is smooth in between: 0, the duration, the keys' times between, and times
// at which splines of rotations are divided, until the quaternions of a part are certainly not zero. In increasing order, at least
// one; seconds. Throws ModelError for a spline of rotations that comes too close to zero, where it turns without a bound.
std::vector<double> smooth_times(const std::string& file, const std::vector<SceneNode>& nodes, const Animation& animation);

// smooth_times, and the last of them once more where it is the only one, or the animation jumps there: the parts between them have
// all that the animation shows, the last one what comes after the jump.
std::vector<double> part_times(const std::string& file, const std::vector<SceneNode>& nodes, const Animation& animation);

// Whether a node's transform or a weight jumps at this time: where two keys share it, or a step ends.
bool jumps_at(const Animation& animation, double time);

// The motion of a track's node against its parent from start to end, as below.
LinkMotion<double> track_motion(const NodeTrack& track, double start, double end);

// Of a node that no track moves.
ChainMotion<double> still_link(const SceneNode& node);

// The motion of each node against its parent from start to end, two neighbours of smooth_times (c2_channel_motion,
// c3_normalized_motion), or from its last time to the same, after which nothing moves. By node; lengths in units of the file, per
// second.
std::vector<ChainMotion<double>> link_motions(const std::vector<SceneNode>& nodes, const Animation& animation, double start,
                                              double end);

// The motion of the weights of a track's morph targets from start to end, likewise. By target, of sizes without a unit.
std::vector<Motion<double>> weight_motions(const WeightTrack& track, double start, double end);

// The motion of each node against the scene, by that of the nodes against their parents (c4_chain_motion). By node.
std::vector<ChainMotion<double>> chain_motions(const std::vector<SceneNode>& nodes,
                                               const std::vector<ChainMotion<double>>& links);

// By how much the linear part of a transform lengthens a vector, at least and at most.
struct Stretch {
  double least, most;
};
Stretch stretch_of(const Eigen::Matrix4d& matrix);

// Of each node against its parent, from start to end as above; the least is 0 where a scale changes its sign.
std::vector<Stretch> stretches(const std::vector<SceneNode>& nodes, const Animation& animation, double start, double end);

// How far the linear part of some joint's skin matrix is from the rotation that its chain's quaternions make, at most, by how the
// nodes stretch; infinite where one may vanish.
double defect_of(const BoundSkeleton& skeleton, const std::vector<Stretch>& links);

// How many times more than the quaternions of a slerp those of splines are off by rounding, from start to end as above: they are
// shorter than what they are summed up from.
double growth_of_rounding(const Animation& animation, double start, double end);

// The motion of a node against one of its ancestors, or against itself, where it rests.
ChainMotion<double> chain_below(const std::vector<SceneNode>& nodes, const std::vector<ChainMotion<double>>& links, int ancestor,
                                int node);

}  // namespace refitlab
