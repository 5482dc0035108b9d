// SPDX-License-Identifier: GPL-3.0-or-later
// Each lemma has a drawing. It is a picture in the plane of what the lemma's own code computes in double, as a table of shapes.
#pragma once

#include "experiments/drawings/plane.hpp"

namespace refitlab::drawings {

struct Drawing {
  std::string stem;  // of the lemma's file
  void (*draw)(Plane &);
  std::string caption;
};

const std::vector<Drawing> &drawings_of_lemmas();
const std::vector<Drawing> &drawings_of_sections();
const std::vector<Drawing> &drawings_of_one_cap();
const std::vector<Drawing> &drawings_of_control_hulls();
const std::vector<Drawing> &drawings_of_determinants();
const std::vector<Drawing> &drawings_of_motion();

// Returns all drawings.
std::vector<Drawing> all_drawings();

// Writes drawings.csv. It has a row for each shape, in the order in which they are drawn, and a row with the caption of each
// drawing. Points are "x y x y ...".
void write_drawings(const std::string &path);

}  // namespace refitlab::drawings
