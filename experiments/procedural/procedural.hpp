// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in models are made by code alone. They need no input files and have the same bits at every call. Units are metres, y
// is up, the models face +z, and left is +x. Each skin is one closed, connected surface without handles.
//
// Their clips are "walk" and "twist". "walk" is one period of a gait on the spot, with a foot always on the ground. "twist" takes
// one second, from the reference pose to half a turn about the bone axis at each joint that twists, where linear blending
// collapses the skin. The sizes are those of the paper's two models (paper 5).
#pragma once

#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns a man 1.8 m tall with his arms half lowered. He has 8270 triangles and 27 joints. "twist" turns waist, neck,
// left_upper_arm and right_upper_arm.
Model make_man();
// Returns the same man with another number of triangles, for measurements that depend on it. Throws ModelError for a number that
// is odd, too small for the body (some hundreds), or more than its finest grid has (about two hundred thousand).
Model make_man(int triangles);

// Returns a winged beast on four legs, 3 m from nose to tail. It has 13590 triangles and 56 joints. "twist" turns neck_3, tail_2,
// left_upper_arm and right_wing_arm.
Model make_creature();

// Returns a tube of 10 m along z with this many joints in a row, for measurements that depend on their number. It always has
// 20,000 triangles. A vertex has at most two joints, so there are about as many joint-sets as joints. Its only clip is "wave".
// Throws ModelError for joints < 1.
Model make_snake(int joints);

}  // namespace refitlab
