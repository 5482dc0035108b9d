// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s44_joint_sets: where Algorithm 1's single list of weight vertices and single rotation center go wrong.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s44_joint_sets.hpp"

namespace proptests::s44_joints {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;

struct Case {
  std::vector<refitlab::PosedJointSet<Q>> sets;
  // ball encloses the balls as printed, but not the vertex.
  refitlab::Ball3<Q> reference, ball;
  std::vector<Q> weights;  // of the vertex, in the second joint-set
  Point vertex, deformed;
};

inline const refitlab::RigidTransform<Q> at_rest{};
inline const refitlab::RigidTransform<Q> half_turn_about_z{{0, 0, 0, 1}, {0, 0, 0}};
inline const refitlab::RigidTransform<Q> moved_by_five{{1, 0, 0, 0}, {5, 0, 0}};

// There is one rotation center for both: that of the first joint-set is the vertex itself, so no turn is expected of it. The
// second turns it by a right angle about the origin.
inline const Case rotation_center{
    {{{at_rest, at_rest}, {2, 0, 0}, {{Q(1, 2), Q(1, 2)}}}, {{at_rest, half_turn_about_z}, {0, 0, 0}, {{Q(1, 2), Q(1, 2)}}}},
    {{2, 0, 0}, 0},
    {{1, 0, 0}, 1},
    {Q(1, 2), Q(1, 2)},
    {2, 0, 0},
    {0, 2, 0}};

// There is one list of weight vertices for both: the first joint-set is moved by its first joint only, the second by its second.
inline const Case weight_vertices{{{{at_rest, at_rest}, {0, 0, 0}, {{1, 0}}}, {{at_rest, moved_by_five}, {0, 0, 0}, {{0, 1}}}},
                                  {{0, 0, 0}, 0},
                                  {{0, 0, 0}, 0},
                                  {0, 1},
                                  {0, 0, 0},
                                  {5, 0, 0}};

}  // namespace proptests::s44_joints
