// SPDX-License-Identifier: GPL-3.0-or-later
// This generated model has at once what files have: keyed joints that scale along axes, so that those below them shear, and morph
// targets whose weights are keyed.
#pragma once

#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns the man of experiments/procedural with the three targets of add_targets. No pose of his clips is rigid.
Model make_deforming_man();

}  // namespace refitlab
