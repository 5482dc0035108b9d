// Drawings: a picture in the plane for each lemma, of what the lemma's own code
// computes in double.
#pragma once

#include "experiments/drawings/plane.hpp"

namespace refitlab::drawings {

struct Drawing {
  std::string stem;  // of the lemma's file
  void (*draw)(Plane &);
  std::string caption;

  std::string svg() const {
    Plane plane;
    draw(plane);
    return plane.svg(caption);
  }
};

const std::vector<Drawing> &drawings_of_lemmas();
const std::vector<Drawing> &drawings_of_sections();
const std::vector<Drawing> &drawings_of_one_cap();
const std::vector<Drawing> &drawings_of_control_hulls();

// All of them.
std::vector<Drawing> all_drawings();

// Throws std::invalid_argument for a stem that has none.
Drawing drawing_of(const std::string &stem);

}  // namespace refitlab::drawings
