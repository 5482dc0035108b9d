// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of a3_morph_displacement: a smile that leaves the ball of the face.
#pragma once

#include "lemmas/a3_morph_displacement.hpp"
#include "lemmas/exact/exact.hpp"

namespace proptests::a3 {

using Q = refitlab::Rational;
using Point = refitlab::Vec<Q, 3>;
using Ball = refitlab::Ball3<Q>;
using Vertex = refitlab::MorphedVertex<Q>;

inline const Ball face{Point(0, 0, 0), 1}, smile{Point(0, 1, 0), Q(1, 2)};
// The corner is at the rim of both: displaced by m in [0, 1] it is 1 + 3/2 m from the face's center.
inline const Vertex corner{Point(0, 1, 0), {Point(0, Q(3, 2), 0)}}, outside{Point(0, 2, 0), {Point(0, Q(3, 2), 0)}},
    wide{Point(0, 1, 0), {Point(0, 4, 0)}};
inline const std::vector<Ball> smiles{smile};
inline const std::vector<refitlab::Slab<Q>> up_to_one{{0, 1}};
inline const std::vector<Q> one{1}, two{2}, length{1};

}  // namespace proptests::a3
