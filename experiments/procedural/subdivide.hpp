// SPDX-License-Identifier: GPL-3.0-or-later
// A subdivided model is a finer mesh with the same surface in the reference pose, the same skeleton and clips.
#pragma once

#include "algorithms/model/model.hpp"

namespace refitlab {

// Each triangle becomes four, with a vertex in the middle of each edge. The vertices of the model come first and keep
// their influences; a middle has the mean of its ends' weights, the four largest of them if there are more. model is
// valid. Its sources are left out.
Model subdivide(const Model& model);

}  // namespace refitlab
