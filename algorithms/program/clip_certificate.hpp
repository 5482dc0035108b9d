// SPDX-License-Identifier: GPL-3.0-or-later
// A clip certificate says why the bounds of a baked file hold at every time. proptests/certificate/check_clip verifies it.
//
// Format, version 2: a JSON document on one line, with the members of objects in alphabetical order. Numbers that are not
// integers are doubles by the fewest digits that read back as the same double.
//   clips      the file's animations and the rest pose, each
//     animation   its index in the file, or -1 for the rest pose
//     bounds      by part:
//       box, ball   as the file has them: least x, y, z, greatest x, y, z; and the center's x, y, z and the radius
//       slabs       least and greatest (n, x) for each of the directions
//       box_intervals, ball_intervals
//                 intervals of time [start, end, slack], in order, which cover the clip: between the ends the vertices are no
//                 farther than the slack from the chords, and at both ends no nearer than that to leaving the box or ball
//     duration    seconds
//   directions the integer directions n of the slabs; none of a box alone
//   file       the SHA-256 of the baked file's bytes
//   parts      lists of parts of the file that have the same vertices: {"kind": "whole"}, {"kind": "skin", "skin": 0},
//              {"kind": "mesh", "mesh": 0}, {"kind": "primitive", "node": 0, "mesh": 0, "primitive": 0}, and clusters, which are
//              primitives with a list of some of their "triangles"
//   skinning   "linear"
//   version    2
#pragma once

#include <string>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

// Returns the certificate of bounds of linear skinning with intervals. baked has the bytes of the file with these bounds, from
// which the model was loaded.
std::string clip_certificate(const Model& model, const ModelBounds& bounds, const std::string& baked);

}  // namespace refitlab
