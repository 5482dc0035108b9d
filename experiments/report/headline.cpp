#include "experiments/report/headline.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

// By scene, in the order of the results.
using Row = std::map<std::string, double>;

void write_row(std::ostringstream& out, const std::string& title, const Row& row, const Row& ours,
               const std::vector<std::string>& scenes) {
  if (row.empty()) return;
  out << "<tr><td>" << title << "</td>";
  for (const std::string& scene : scenes) {
    out << "<td>";
    if (row.count(scene)) out << format(row.at(scene) < 100 ? "%.3g" : "%.0f", row.at(scene));
    if (row.count(scene) && ours.count(scene) && &row != &ours)
      out << " <span class=\"soft\">(" << format("%.3g", row.at(scene) / ours.at(scene)) << "×)</span>";
    out << "</td>";
  }
  out << "</tr>\n";
}

}  // namespace

std::string headline_section(const std::vector<CollisionResult>& collisions) {
  if (collisions.empty()) return "";
  const std::string& model = collisions[0].model;
  std::vector<std::string> scenes;
  std::map<std::string, Row> rows;  // by detector
  Row fastest_engine;
  for (const CollisionResult& r : collisions) {
    if (r.model != model || r.query != Query::full) continue;
    if (std::find(scenes.begin(), scenes.end(), r.scene) == scenes.end()) scenes.push_back(r.scene);
    rows[r.detector][r.scene] = r.us_per_frame;
    if (r.origin != Origin::engine) continue;
    double& best = fastest_engine.try_emplace(r.scene, r.us_per_frame).first->second;
    best = std::min(best, r.us_per_frame);
  }
  const Row& ours = rows["clusters"];
  std::ostringstream out;
  out << "<h2>Queries at a glance</h2><p>Two of the model " << escape_html(model)
      << ", from postures to all touching pairs of triangles: microseconds a frame on one thread (in brackets, how "
         "many "
         "times ours).</p><div class=\"scroll\"><table><thead><tr><th></th>";
  for (const std::string& scene : scenes) out << "<th>" << scene << "</th>";
  out << "</tr></thead><tbody>\n";
  write_row(out, "<b>ours</b>: clusters, <code>collide(ClusterBody, …)</code>", ours, ours, scenes);
  write_row(out, "skin everything in SIMD, boxes bottom-up", rows["skin_all_simd"], ours, scenes);
  write_row(out, "the fastest engine of each scene", fastest_engine, ours, scenes);
  write_row(out, "the paper’s query, spheres by control_mixed", rows["control_mixed"], ours, scenes);
  write_row(out, "the paper’s query, Algorithm 1 repaired", rows["spherical_repaired"], ours, scenes);
  out << "</tbody></table></div>\n";
  return out.str();
}

}  // namespace refitlab
