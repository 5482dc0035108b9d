#include "experiments/drawings/drawings.hpp"

#include <stdexcept>

namespace refitlab::drawings {

std::vector<Drawing> all_drawings() {
  std::vector<Drawing> all;
  for (const auto *some :
       {&drawings_of_lemmas(), &drawings_of_sections(), &drawings_of_one_cap(), &drawings_of_control_hulls()})
    all.insert(all.end(), some->begin(), some->end());
  return all;
}

Drawing drawing_of(const std::string &stem) {
  for (const Drawing &drawing : all_drawings())
    if (drawing.stem == stem) return drawing;
  throw std::invalid_argument("no drawing of '" + stem + "'");
}

}  // namespace refitlab::drawings
