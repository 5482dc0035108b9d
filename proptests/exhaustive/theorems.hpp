// SPDX-License-Identifier: GPL-3.0-or-later
// Declares the theorems of this folder. Each file has those of the lemma that it is named after.
#pragma once

#include "proptests/exhaustive/theorem.hpp"

namespace proptests::exhaustive {

std::vector<Theorem> theorems_of_lemma5();
std::vector<Theorem> theorems_of_rotation_bound();
std::vector<Theorem> theorems_of_control_hulls();
std::vector<Theorem> theorems_of_motion_bound();

std::vector<Theorem> all_theorems();

// Returns the theorem of this name. Throws std::runtime_error, which lists all names, if there is none.
Theorem theorem_named(const std::string& name);

}  // namespace proptests::exhaustive
