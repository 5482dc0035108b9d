#include "experiments/report/triangle_growth.hpp"

#include <algorithm>
#include <sstream>

#include "experiments/report/html.hpp"
#include "experiments/report/line_plot.hpp"

namespace refitlab {
namespace {

// In order of appearance.
template <class Key>
auto distinct(const std::vector<TriangleGrowth>& rows, const Key& key) {
  std::vector<std::decay_t<decltype(key(rows[0]))>> out;
  for (const TriangleGrowth& r : rows)
    if (std::find(out.begin(), out.end(), key(r)) == out.end()) out.push_back(key(r));
  return out;
}

}  // namespace

std::string triangle_growth_section(const std::vector<TriangleGrowth>& rows) {
  if (rows.empty()) return "";
  const auto scenes = distinct(rows, [](const TriangleGrowth& r) { return r.result.scene; });
  const auto detectors = distinct(rows, [](const TriangleGrowth& r) { return r.result.detector; });
  const auto numbers = distinct(rows, [](const TriangleGrowth& r) { return r.triangles; });
  std::ostringstream out;
  out << "<h2>Growth with triangles</h2><p>Two men pass each other at the distances of the scenes near, light and heavy, "
         "their meshes made coarser, or "
         "finer by subdivision, on the same skeleton. Processor time of a full query with all that it needs, us a "
         "frame. The exponent is that "
         "of the least-squares fit to the time, from 4000 triangles up.</p>\n";
  for (const std::string& scene : scenes) {
    LinePlot plot{
        .title = scene, .x_label = "triangles", .y_label = "us a frame", .lines = {}, .log_x = true, .log_y = true};
    std::ostringstream table;
    table << "<div class=\"scroll\"><table><thead><tr><th>" << scene << ", us a frame</th>";
    for (const int n : numbers) table << "<th>" << n << "</th>";
    table << "<th>exponent</th></tr></thead><tbody>\n";
    for (const std::string& detector : detectors) {
      PlotLine line{detector, {}, plot_color(plot.lines.size())};
      table << "<tr><td>" << detector << "</td>";
      for (const TriangleGrowth& r : rows)
        if (r.result.scene == scene && r.result.detector == detector) {
          line.points.emplace_back(r.triangles, r.result.us_per_frame);
          table << "<td>" << format("%.0f", r.result.us_per_frame) << "</td>";
        }
      table << "<td>" << format("%.2f", triangle_exponent(rows, scene, detector)) << "</td></tr>\n";
      plot.lines.push_back(std::move(line));
    }
    table << "<tr><td class=\"soft\">touching pairs</td>";
    for (const TriangleGrowth& r : rows)
      if (r.result.scene == scene && r.result.detector == detectors[0])
        table << "<td class=\"soft\">" << format("%.0f", r.result.pairs) << "</td>";
    out << plot.svg() << table.str() << "<td></td></tr></tbody></table></div>\n";
  }
  return out.str();
}

}  // namespace refitlab
