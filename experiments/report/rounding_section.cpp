#include "experiments/report/rounding_section.hpp"

#include <sstream>

#include "experiments/report/html.hpp"

namespace refitlab {

std::string rounding_section(const std::vector<RoundingResult>& results) {
  if (results.empty()) return "";
  std::ostringstream out;
  out << "<h2>Rounding</h2><p>Every ball carries a slack for all rounding, derived before any number is known "
         "(<code>algorithms/skinning/pose_rounding.hpp</code>). Vertices are skinned in exact arithmetic and compared with the ball as it "
         "stands in double, and rounded to float. Inflation: what slack, and rounding to float, add to the radius, relative to it, "
         "median over all nodes. Cost: with the slack over without, same run.</p>"
         "<div class=\"scroll\"><table><thead><tr><th>model</th><th>variant</th><th>exact checks</th><th>outside</th>"
         "<th>outside, float</th><th>outside without slack</th><th>inflation</th><th>inflation, float</th><th>cost</th>"
         "</tr></thead><tbody>\n";
  for (const RoundingResult& r : results)
    out << "<tr><td>" << escape_html(r.model) << "</td><td>" << r.variant << "</td><td>" << r.checks << "</td><td>" << r.misses
        << "</td><td>" << r.float_misses << "</td><td>"
        << format("%.2f %%", 100.0 * static_cast<double>(r.misses_as_computed) / static_cast<double>(r.checks)) << "</td><td>"
        << format("%.1e", r.inflation) << "</td><td>" << format("%.1e", r.float_inflation) << "</td><td>"
        << format("%.2f", r.cost) << "</td></tr>\n";
  out << "</tbody></table></div>\n";
  return out.str();
}

}  // namespace refitlab
