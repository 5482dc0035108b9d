// SPDX-License-Identifier: GPL-3.0-or-later
// Sampled clips become key frames of a skeleton.
#pragma once

#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns the model with a skeleton of one node for each joint, and with clips that go between keys. There are so many keys a
// second, and one at the end. At the keys the poses are those of the model, up to rounding; between them rotations go along the
// shorter great arc relative to the parent, and positions linearly. Its sources and morph targets are left out.
// Throws ModelError for a rate that is no positive number or gives a clip more than ten million keys, and what the clips throw.
Model keyed(const Model& model, double rate);

}  // namespace refitlab
