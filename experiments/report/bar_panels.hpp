// BarPanels: horizontal bars on a log axis, a row a name, a panel beside the other for each case, as one SVG element.
#pragma once

#include <string>
#include <vector>

namespace refitlab {

struct BarRow {
  std::string label;
  std::string color;           // a CSS colour
  std::vector<double> values;  // by panel; a bar is left out where it is not positive
};

struct BarPanels {
  std::string title;
  std::vector<std::string> panels;
  std::vector<BarRow> rows;
  std::string svg() const;
};

}  // namespace refitlab
