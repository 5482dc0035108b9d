// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in models, made by code alone: no input files, the same bits at every call. Units are metres, y is up, the
// models face +z, left is +x. Each skin is one closed, connected surface without handles.
//
// Clips: "walk" (one period of a gait, on the spot, a foot always on the ground) and "twist" (one second, from the
// reference pose to half a turn about the bone axis at each of the joints that twists, where linear blending
// collapses the skin). The sizes are those of the paper's two models (paper 5).
#pragma once

#include "algorithms/model/model.hpp"

namespace refitlab {

// 1.8 m tall, arms half lowered: 8270 triangles, 27 joints. "twist" turns waist, neck, left_upper_arm and
// right_upper_arm.
Model make_man();
// The same with another number of triangles, for what depends on it. Throws ModelError for one that is odd, so small that the
// body cannot be made of so few (some hundreds), or more than its finest grid has (about two hundred thousand).
Model make_man(int triangles);

// A winged beast on four legs, 3 m from nose to tail: 13590 triangles, 56 joints. "twist" turns neck_3, tail_2,
// left_upper_arm and right_wing_arm.
Model make_creature();

// A tube of 10 m along z with this many joints in a row, for what depends on their number: 20,000 triangles, whatever
// the joints; two joints at most to a vertex, and so about as many joint-sets. Its clip is "wave" alone. Throws ModelError
// for joints < 1.
Model make_snake(int joints);

}  // namespace refitlab
