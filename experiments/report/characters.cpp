#include "experiments/report/characters.hpp"

#include "experiments/report/html.hpp"
#include "experiments/report/line_plot.hpp"

namespace refitlab {

void write_characters_section(std::ostringstream& out, const std::vector<CharacterGrowth>& rows) {
  if (rows.empty()) return;
  out << "<h2>Many characters in one scene</h2><p>Walking men in a square, each with two square metres: every touching "
         "pair of triangles "
         "of every two men, from postures to pairs. Boxes around the men are compared first, and only pairs whose "
         "boxes meet are looked "
         "into. The cost of a frame grows with the number of men by an exponent of "
      << format("%.2f", exponent(rows, &CharacterGrowth::full)) << " ("
      << format("%.2f", exponent(rows, &CharacterGrowth::yes_no))
      << " for yes/no). To pose and skin all of them, which is where any other detector here begins, is drawn beside "
         "it.</p>\n";
  LinePlot plot{
      .title = "time of a frame", .x_label = "characters", .y_label = "us", .lines = {}, .log_x = true, .log_y = true};
  const std::pair<const char*, double CharacterGrowth::*> lines[] = {
      {"all pairs", &CharacterGrowth::full},
      {"all pairs, two threads", &CharacterGrowth::full_on_two_threads},
      {"yes/no", &CharacterGrowth::yes_no},
      {"skinning alone", &CharacterGrowth::skin_all}};
  for (const auto& [label, cost] : lines) {
    PlotLine line{label, {}, plot_color(plot.lines.size())};
    for (const CharacterGrowth& r : rows)
      if (r.*cost > 0) line.points.emplace_back(r.characters, r.*cost);
    if (!line.points.empty()) plot.lines.push_back(std::move(line));
  }
  out << plot.svg()
      << "<div class=\"scroll\"><table><thead><tr><th>characters</th><th>pairs of boxes that meet</th><th>pairs that "
         "touch</th><th>touching "
         "triangles</th><th>clusters skinned</th><th>all pairs, us</th><th>on two threads, us</th><th>yes/no, "
         "us</th><th>skinning alone, us</th>"
         "</tr></thead><tbody>\n";
  for (const CharacterGrowth& r : rows) {
    out << "<tr><td>" << r.characters << "</td><td>" << format("%.0f", r.pairs_of_boxes) << "</td><td>"
        << format("%.0f", r.contacts) << "</td><td>" << format("%.0f", r.triangle_pairs) << "</td><td>"
        << format("%.1f", 100 * r.clusters_skinned) << " %</td>";
    for (const double us : {r.full, r.full_on_two_threads, r.yes_no, r.skin_all})
      out << "<td>" << (us > 0 ? format("%.0f", us) : "") << "</td>";
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

}  // namespace refitlab
