// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of b9_pose_change: joints that turn and leave images where they are, and what goes wrong without a factor of 2.
#pragma once

#include "lemmas/b9_pose_change.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::b9 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Turn = refitlab::Quaternion<Q>;
using Transforms = std::vector<refitlab::RigidTransform<Q>>;
using Bounds = refitlab::PoseChangeBounds<Q>;

inline const Point origin(0, 0, 0), x_axis(1, 0, 0), y_axis(0, 1, 0);
inline const std::vector<Q> halves{Q(1, 2), Q(1, 2)};
inline const Turn identity(1, 0, 0, 0);

// Two joints carry a vertex at y to (0, 0, 12/13) and (0, 0, -12/13). Then they turn about the x axis by 45 degrees and by -45
// degrees, and carry the vertex to where they did: no image moves, and dual quaternions at halves raise the vertex by 5/13.
// Their quaternions turn by sqrt(2/13), which is a little less than 2/5.
inline const Turn turned(Q(12, 13), Q(5, 13), 0, 0), turned_back(Q(12, 13), Q(-5, 13), 0, 0);
inline const Q image_height(12, 13), bulge(5, 13), turn(2, 5);
inline const Point upper(0, 0, image_height), lower(0, 0, -image_height);
inline const Point pivot(0, Q(119, 169), 0), ahead(0, 0, Q(120, 169));
inline const Transforms still{{identity, upper - y_axis}, {identity, lower - y_axis}};
inline const Transforms opposed{{turned, upper - pivot - ahead}, {turned_back, lower - pivot + ahead}};
inline const Bounds opposed_bounds{1, turn, 0, Q(24, 13)};

// What is wrong of these bounds, from these joints to others: a cosine or a spread that is not theirs, or no turn where they turn.
inline const Bounds at_one{1, 0, 0, Q(24, 13)}, closer{Q(119, 169), 0, 0, 1};
// The joints at rest go on along the x axis.
inline const Transforms gone_on{{identity, upper - y_axis + x_axis}, {identity, lower - y_axis + x_axis}};
// A joint that is half a turn from the other turns on to where its quaternion takes the long way round, and leaves y at -y.
inline const Transforms half_a_turn{{identity, origin}, {{0, 1, 0, 0}, origin}};
inline const Transforms long_way{{identity, origin}, {{Q(-12, 13), Q(5, 13), 0, 0}, {0, Q(-288, 169), Q(120, 169)}}};
inline const Bounds long_way_bounds{0, Q(10, 9), 0, 2};

// A turn about the z axis by 106 degrees, whose quaternion is sqrt(4/5) from that of no turn, moves x by 8/5.
inline const Turn far_turn(Q(3, 5), 0, 0, Q(4, 5));
inline const Q far_turn_squared(4, 5), far_turn_length(9, 10);

// The joints' quaternions are at a cosine of 3/5 and turn away from each other, by less than 2/5 each. They end at -123/845.
inline const Turn first(1, 0, 0, 0), second(Q(3, 5), 0, 0, Q(4, 5));
inline const Turn first_now(Q(12, 13), 0, 0, Q(-5, 13)), second_now(Q(16, 65), 0, 0, Q(63, 65));
inline const Q apart(3, 5), apart_now(-123, 845);

// The share is 1/4 at the least cosine of its sharp formula, and its square is 9/32 at 1/2. That of a step of as much as lies between is
// 17/1280.
inline const Q at_the_jump(3, 5), beyond_the_jump(1, 2), share_at_the_jump(1, 4), share_of_the_step(1, 8);

}  // namespace proptests::b9
