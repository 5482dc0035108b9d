// SPDX-License-Identifier: GPL-3.0-or-later
// Pins cases of s41_weight_vertices_span: what goes wrong without each hypothesis, and where the paper is wrong.
#pragma once

#include "lemmas/exact/exact.hpp"
#include "lemmas/s41_weight_vertices_span.hpp"

namespace proptests::s41 {

using Q = refitlab::Rational;
using Weights = std::vector<Q>;
using refitlab::WeightBounds;
using refitlab::WeightVertices;

// Two joints without bounds have W' = W_2, a segment.
inline const WeightBounds<Q> segment{{0, 0}, {1, 1}};
inline const Weights middle{Q(1, 2), Q(1, 2)};

// A list without one of the weight vertices does not span the middle; the normal separates it.
inline const WeightVertices<Q> one_end{{1, 0}};
inline const Weights towards_the_other_end{-1, 0};

// Weights that the bounds do not admit are not spanned.
inline const Weights beyond_the_segment{2, -1};
inline const WeightVertices<Q> both_ends{{1, 0}, {0, 1}};
inline const Weights along_the_segment{1, 0};

// A listed point outside W' makes combinations that the bounds do not admit.
inline const WeightVertices<Q> too_far{{2, -1}, {1, 0}, {0, 1}};
inline const Weights only_the_first{1, 0, 0};

// With a repeated weight vertex there are more than n C(n-1, floor((n-1)/2)) = 2.
inline const WeightVertices<Q> repeated{{1, 0}, {0, 1}, {1, 0}};

// In print any bounds have weight vertices. These let no weights through: the low ones sum to 3/2, the high ones to 1/2, or a low
// one is above its high one.
inline const WeightBounds<Q> low_too_high{{Q(3, 4), Q(3, 4)}, {1, 1}};
inline const WeightBounds<Q> high_too_low{{0, 0}, {Q(1, 4), Q(1, 4)}};
inline const WeightBounds<Q> crossed{{1, 0}, {0, 1}};

}  // namespace proptests::s41
