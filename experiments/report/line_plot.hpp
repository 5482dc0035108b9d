// LinePlot: a labelled line chart as an SVG element whose colours follow the page's light or dark scheme.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace refitlab {

struct PlotLine {
  std::string label;
  std::vector<std::pair<double, double>> points;
  std::string color;  // a CSS colour
  bool dashed = false;
};

struct LinePlot {
  std::string title, x_label, y_label;
  std::vector<PlotLine> lines;
  bool log_x = false, log_y = false;
  std::string svg() const;
};

// Colours that the colour-blind can tell apart [Okabe and Ito 2008], by index; black and yellow are left out, since they
// vanish on a dark or a light page.
std::string plot_color(std::size_t index);

}  // namespace refitlab
