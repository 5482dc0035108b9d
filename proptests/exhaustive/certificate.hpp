// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the certificate of a theorem, or of a shard of it, as JSON.
#pragma once

#include "proptests/exhaustive/subdivide.hpp"

namespace proptests::exhaustive {

// Returns the certificate. The member "tree" has the tree of all cells; a shard has "cells" in its place, a path and a tree each.
// Numbers are fractions.
std::string certificate_of(const Theorem& theorem, double constant, const std::vector<Cell>& cells);
std::string shard_of(const Theorem& theorem, double constant, const std::vector<Cell>& cells);

// Returns a dyadic number as a fraction, such as "-37/64".
std::string fraction_of(double x);

}  // namespace proptests::exhaustive
