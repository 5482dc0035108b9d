#include "experiments/report/batch_section.hpp"

#include <sstream>

#include "experiments/report/html.hpp"

namespace refitlab {

std::string batch_section(const std::vector<BatchSpeed>& results) {
  if (results.empty()) return "";
  std::ostringstream out;
  out << "<h2>In batches</h2><p>All vertices skinned (double, bit-identical to the scalar code) and all spheres refitted (float, "
         "rounding in the radius) in SIMD packs, by instruction set; the frame's joint-set data given for scalar refits, made anew "
         "in each batch. Nanoseconds per vertex, sphere or joint-set, and the ratio to scalar double code in the same run.</p>"
         "<div class=\"scroll\"><table><thead><tr><th>model, posture</th><th>what</th><th>how</th><th>ns</th><th>to scalar</th>"
         "<th>to linear</th></tr></thead><tbody>\n";
  for (const BatchSpeed& r : results)
    out << "<tr><td>" << escape_html(r.model + ", " + r.posture) << "</td><td>" << r.what << "</td><td>" << r.how << "</td><td>"
        << format("%.2f", r.ns) << "</td><td>" << (r.how == "scalar" ? "" : format("1/%.1f", 1 / r.ratio)) << "</td><td>"
        << (r.to_linear > 0 ? format("%.2f", r.to_linear) : "") << "</td></tr>\n";
  out << "</tbody></table></div>\n";
  return out.str();
}

}  // namespace refitlab
