#include "experiments/report/bar_panels.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

// 10, 1k, 100k, 1M.
std::string short_number(double v) {
  return v >= 1e6 ? format("%gM", v / 1e6) : v >= 1e3 ? format("%gk", v / 1e3) : format("%g", v);
}

constexpr double label_width = 176, panel_width = 176, bar_width = 120, row_height = 16, top = 54;

}  // namespace

std::string BarPanels::svg() const {
  double least = 1e300, most = 0;
  for (const BarRow& row : rows)
    for (const double v : row.values)
      if (v > 0) least = std::min(least, v), most = std::max(most, v);
  if (most == 0) return "";
  const double from = std::floor(std::log10(least) - 0.1), to = std::max(std::ceil(std::log10(most)), from + 1);
  const auto length = [&](double v) { return bar_width * (std::log10(v) - from) / (to - from); };
  const double count = static_cast<double>(panels.size());
  const double width = label_width + panel_width * count,
               height = top + row_height * static_cast<double>(rows.size()) + 8;

  std::ostringstream out;
  out << "<svg class=\"plot\" style=\"max-width:74rem\" viewBox=\"0 0 " << width << ' ' << height
      << "\" role=\"img\" aria-label=\"" << escape_html(title) << "\">\n<text class=\"title\" x=\"0\" y=\"16\">"
      << escape_html(title) << "</text>\n";
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double x = label_width + panel_width * static_cast<double>(p);
    out << "<text x=\"" << x << "\" y=\"" << top - 18 << "\">" << escape_html(panels[p]) << "</text>\n";
    for (double decade = from; decade <= to; ++decade)
      out << "<line class=\"grid\" x1=\"" << x + length(std::pow(10, decade)) << "\" x2=\""
          << x + length(std::pow(10, decade)) << "\" y1=\"" << top - 4 << "\" y2=\"" << height - 8
          << "\"/><text font-size=\"9\" text-anchor=\"middle\" x=\"" << x + length(std::pow(10, decade)) << "\" y=\""
          << top - 6 << "\">" << short_number(std::pow(10, decade)) << "</text>\n";
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const double y = top + row_height * static_cast<double>(r);
    out << "<text text-anchor=\"end\" x=\"" << label_width - 8 << "\" y=\"" << y + 11 << "\">"
        << escape_html(rows[r].label) << "</text>\n";
    for (std::size_t p = 0; p < rows[r].values.size(); ++p) {
      const double value = rows[r].values[p], x = label_width + panel_width * static_cast<double>(p);
      if (!(value > 0)) continue;
      out << "<rect x=\"" << x << "\" y=\"" << y + 2 << "\" width=\"" << length(value) << "\" height=\""
          << row_height - 5 << "\" fill=\"" << rows[r].color << "\"/><text font-size=\"10\" x=\""
          << x + length(value) + 4 << "\" y=\"" << y + 11 << "\">" << format(value < 100 ? "%.3g" : "%.0f", value)
          << "</text>\n";
    }
  }
  out << "</svg>\n";
  return out.str();
}

}  // namespace refitlab
