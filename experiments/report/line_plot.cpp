#include "experiments/report/line_plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

constexpr double width = 680, least_height = 360, line_height = 18, left = 68, right = 238, top = 34, bottom = 44;

struct Axis {
  double low, high;
  bool log;
  double place(double value, double from, double to) const {
    const auto f = [&](double v) { return log ? std::log10(v) : v; };
    return from + (to - from) * (f(value) - f(low)) / (f(high) - f(low));
  }
};

std::string number(double value, int digits = 4) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

// Round steps of 1, 2 or 5 times a power of ten, about six of them; on a log axis 1, 2, 5 of each decade, or, of more than
// two, powers of ten.
std::vector<double> ticks(const Axis& axis) {
  std::vector<double> out;
  if (axis.log) {
    const bool is_long = axis.high > 100 * axis.low;
    for (double decade = std::pow(10, std::floor(std::log10(axis.low))); decade <= axis.high; decade *= 10)
      for (const double m : {1.0, 2.0, 5.0})
        if ((m == 1 || !is_long) && decade * m >= axis.low * 0.999 && decade * m <= axis.high * 1.001)
          out.push_back(decade * m);
    return out;
  }
  const double rough = (axis.high - axis.low) / 6, power = std::pow(10, std::floor(std::log10(rough)));
  double step = power;
  for (const double m : {2.0, 5.0, 10.0})
    if (step < rough) step = power * m;
  for (double t = std::ceil(axis.low / step) * step; t <= axis.high + 1e-9 * step; t += step) out.push_back(t);
  return out;
}

}  // namespace

std::string plot_color(std::size_t index) {
  static const char* const colors[] = {"#D55E00", "#0072B2", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#8a8a8a", "#7f5fbf"};
  return colors[index % std::size(colors)];
}

std::string LinePlot::svg() const {
  const double height = std::max(least_height, top + line_height * static_cast<double>(lines.size()) + bottom);
  Axis x{1e300, -1e300, log_x}, y{1e300, -1e300, log_y};
  for (const PlotLine& line : lines)
    for (const auto& [px, py] : line.points) {
      x.low = std::min(x.low, px), x.high = std::max(x.high, px);
      y.low = std::min(y.low, py), y.high = std::max(y.high, py);
    }
  if (!(x.low < x.high)) x.high = x.low + 1;
  const double margin = 0.04 * (y.high - y.low) + 1e-9;
  if (!log_y) y.low -= margin, y.high += margin;
  if (log_x) x.low *= 0.8, x.high *= 1.25;
  const auto px = [&](double v) { return x.place(v, left, width - right); };
  const auto py = [&](double v) { return y.place(v, height - bottom, top); };

  std::ostringstream out;
  out << "<svg class=\"plot\" viewBox=\"0 0 " << width << ' ' << height << "\" role=\"img\" aria-label=\"" << escape_html(title)
      << "\">\n<text class=\"title\" x=\"" << left << "\" y=\"18\">" << escape_html(title) << "</text>\n";
  for (const double t : ticks(y))
    out << "<line class=\"grid\" x1=\"" << left << "\" x2=\"" << width - right << "\" y1=\"" << py(t) << "\" y2=\"" << py(t)
        << "\"/><text text-anchor=\"end\" x=\"" << left - 6 << "\" y=\"" << py(t) + 4 << "\">" << number(t, 6) << "</text>\n";
  for (const double t : ticks(x))
    out << "<text text-anchor=\"middle\" x=\"" << px(t) << "\" y=\"" << height - bottom + 16 << "\">" << number(t, 6) << "</text>\n";
  out << "<text text-anchor=\"middle\" x=\"" << (left + width - right) / 2 << "\" y=\"" << height - 8 << "\">" << escape_html(x_label)
      << "</text>\n<text text-anchor=\"middle\" transform=\"translate(14," << (top + height - bottom) / 2 << ") rotate(-90)\">"
      << escape_html(y_label) << "</text>\n";
  double legend = top + 8;
  for (const PlotLine& line : lines) {
    const std::string style =
        "stroke=\"" + line.color + "\" fill=\"none\" stroke-width=\"2\"" + (line.dashed ? " stroke-dasharray=\"6 4\"" : "");
    out << "<polyline " << style << " points=\"";
    for (const auto& [vx, vy] : line.points) out << px(vx) << ',' << py(vy) << ' ';
    out << "\"/>";
    for (const auto& [vx, vy] : line.points)
      out << "<circle cx=\"" << px(vx) << "\" cy=\"" << py(vy) << "\" r=\"2.6\" fill=\"" << line.color << "\"><title>"
          << escape_html(line.label) << ": " << number(vx) << ", " << number(vy) << "</title></circle>";
    out << "<line " << style << " x1=\"" << width - right + 12 << "\" x2=\"" << width - right + 36 << "\" y1=\"" << legend << "\" y2=\""
        << legend << "\"/><text x=\"" << width - right + 42 << "\" y=\"" << legend + 4 << "\">" << escape_html(line.label)
        << "</text>\n";
    legend += line_height;
  }
  out << "</svg>\n";
  return out.str();
}

}  // namespace refitlab
