// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/drawings/drawings.hpp"

#include "algorithms/results/result_file.hpp"

namespace refitlab::drawings {

std::vector<Drawing> all_drawings() {
  std::vector<Drawing> all;
  for (const auto *some : {&drawings_of_lemmas(), &drawings_of_sections(), &drawings_of_one_cap(), &drawings_of_control_hulls(),
                           &drawings_of_determinants(), &drawings_of_motion()})
    all.insert(all.end(), some->begin(), some->end());
  return all;
}

void write_drawings(const std::string &path) {
  ResultFile file({"drawing", "shape", "kind", "points", "radius", "closed", "label"});
  for (const Drawing &drawing : all_drawings()) {
    file.add({drawing.stem, "caption", "", "", "0", "no", drawing.caption});
    Plane plane;
    drawing.draw(plane);
    for (const Shape &s : plane.shapes()) {
      std::string points;
      for (const Point &p : s.points) points += (points.empty() ? "" : " ") + format_number(p[0]) + " " + format_number(p[1]);
      file.add({drawing.stem, s.shape, s.kind, points, format_number(s.radius), s.closed ? "yes" : "no", s.label});
    }
  }
  file.write(path);
}

}  // namespace refitlab::drawings
