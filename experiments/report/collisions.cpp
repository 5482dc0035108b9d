#include "experiments/report/collisions.hpp"

#include <algorithm>
#include <sstream>

#include "experiments/report/bar_panels.hpp"
#include "experiments/report/html.hpp"
#include "experiments/report/line_plot.hpp"

namespace refitlab {
namespace {

using Results = std::vector<CollisionResult>;

template <class Key>
std::vector<std::string> distinct(const Results& results, const Key& key) {
  std::vector<std::string> out;
  for (const CollisionResult& r : results)
    if (std::find(out.begin(), out.end(), key(r)) == out.end()) out.push_back(key(r));
  return out;
}

const auto scene_of = [](const CollisionResult& r) { return r.scene; };
const auto detector_of = [](const CollisionResult& r) { return r.detector; };
const auto model_of = [](const CollisionResult& r) { return r.model; };

// Null if there is no such row.
const CollisionResult* find(const Results& results, const std::string& model, const std::string& scene,
                            const std::string& detector, Query query) {
  for (const CollisionResult& r : results)
    if (r.model == model && r.scene == scene && r.detector == detector && r.query == query) return &r;
  return nullptr;
}

// Not the oracle, and not linear blending, which is there for Table 2.
bool is_comparable(const CollisionResult& r) { return r.ratio_to_skin_all > 0; }

std::string color_of(Origin origin) {
  return plot_color(origin == Origin::own ? 1 : origin == Origin::rival ? 2 : origin == Origin::engine ? 0 : 6);
}

const char* name_of(Origin origin) {
  switch (origin) {
    case Origin::own:
      return "on demand";
    case Origin::rival:
      return "skins everything";
    case Origin::engine:
      return "engine";
    case Origin::oracle:
      break;
  }
  return "oracle";
}

const char* title_of(Query query) { return query == Query::full ? "Full: all pairs" : "Yes/no: until the first pair"; }

// "far, 0 pairs", by scene of the model.
std::vector<std::string> scene_titles(const Results& results, const std::string& model,
                                      const std::vector<std::string>& scenes) {
  std::vector<std::string> out;
  for (const std::string& scene : scenes) {
    const CollisionResult* oracle = find(results, model, scene, "brute_force", Query::full);
    out.push_back(scene + (oracle ? format(", %.0f pairs", oracle->pairs) : ""));
  }
  return out;
}

void write_bars(std::ostringstream& out, const Results& results, const std::string& model, Query query) {
  const auto scenes = distinct(results, scene_of);
  BarPanels bars{model + ", " + refitlab::name_of(query) + ": us a frame", scene_titles(results, model, scenes), {}};
  for (const std::string& detector : distinct(results, detector_of)) {
    BarRow row{detector, "", {}};
    bool is_there = false;
    for (const std::string& scene : scenes) {
      const CollisionResult* r = find(results, model, scene, detector, query);
      row.values.push_back(r ? r->us_per_frame : 0);
      if (r) row.color = color_of(r->origin), is_there = is_comparable(*r);
    }
    if (is_there) bars.rows.push_back(std::move(row));
  }
  out << bars.svg();
}

void write_times(std::ostringstream& out, const Results& results, const std::string& model, Query query) {
  const auto scenes = distinct(results, scene_of);
  out << "<details><summary>" << title_of(query)
      << ", with ratios</summary><div class=\"scroll\"><table><thead><tr><th>us a frame (of the fastest engine, of "
         "skin_all_simd)</th><th></th>";
  for (const std::string& title : scene_titles(results, model, scenes)) out << "<th>" << escape_html(title) << "</th>";
  out << "</tr></thead><tbody>\n";
  for (const std::string& detector : distinct(results, detector_of)) {
    std::ostringstream cells;
    const CollisionResult* any = nullptr;
    for (const std::string& scene : scenes) {
      const CollisionResult* r = find(results, model, scene, detector, query);
      cells << "<td>";
      if (r) {
        any = is_comparable(*r) || r->origin == Origin::oracle ? r : nullptr;
        cells << "<b>" << format(r->us_per_frame < 100 ? "%.1f" : "%.0f", r->us_per_frame) << "</b>";
        if (r->ratio_to_skin_all > 0)
          cells << " <span class=\"soft\">(" << format("%.3g", r->ratio_to_engine) << ", "
                << format("%.3g", r->ratio_to_skin_all) << ")</span>";
      }
      cells << "</td>";
    }
    if (any)
      out << "<tr><td>" << detector << "</td><td class=\"soft\">" << name_of(any->origin) << "</td>" << cells.str()
          << "</tr>\n";
  }
  out << "</tbody></table></div></details>\n";
}

void write_work(std::ostringstream& out, const Results& results, const std::string& model) {
  out << "<details><summary>What a frame takes, by stage, and what is looked at</summary><div "
         "class=\"scroll\"><table><thead><tr><th>scene</th>"
         "<th>detector</th>";
  for (const char* stage : stage_names) out << "<th>" << stage << ", us</th>";
  out << "<th>vertices skinned</th><th>nodes refitted</th><th>volume tests</th><th>triangle "
         "tests</th></tr></thead><tbody>\n";
  for (const CollisionResult& r : results) {
    if (r.model != model || r.origin == Origin::oracle) continue;
    out << "<tr><td>" << r.scene << ", " << refitlab::name_of(r.query) << "</td><td>" << r.detector << "</td>";
    for (const double us : r.stages_us) out << "<td>" << format("%.1f", us) << "</td>";
    for (const double count : {r.vertices_skinned, r.nodes_refitted, r.volume_tests, r.triangle_tests})
      out << "<td>" << (count > 0 ? format("%.0f", count) : "") << "</td>";
    out << "</tr>\n";
  }
  out << "</tbody></table></div></details>\n";
}

// The rows and columns of the paper's Table 2, its milliseconds of 2006 beside ours. Its men are in light contact.
void write_table_2(std::ostringstream& out, const Results& results) {
  struct Row {
    const char *title, *model, *scene;
    Query query;
    double paper[3];
  };
  const Row rows[] = {{"Men (Full)", "man", "light", Query::full, {0.27, 0.31, 16.70}},
                      {"Creatures (Full)", "creature", "worst", Query::full, {6.14, 7.47, 35.17}},
                      {"Creatures (Yes/no)", "creature", "worst", Query::yes_no, {0.72, 1.44, 28.67}}};
  const std::pair<const char*, const char*> columns[] = {
      {"linear", "LBS"}, {"spherical_repaired", "SBS"}, {"brown", "Bottom-up"}};
  out << "<h3>The paper's Table 2</h3><p>Milliseconds a query, ours and (the paper's, on a processor of 2006, without "
         "the frame's joint-set data). "
         "LBS and SBS refit on demand, by linear and by spherical blending; bottom-up skins everything and refits all "
         "spheres. The paper's men are "
         "taken as the scene light, its worst-case scenario as the scene worst.</p><div "
         "class=\"scroll\"><table><thead><tr><th>scenario</th>";
  for (const auto& [detector, title] : columns) out << "<th>" << title << "</th>";
  out << "</tr></thead><tbody>\n";
  for (const Row& row : rows) {
    if (!find(results, row.model, row.scene, "brown", row.query)) continue;
    out << "<tr><td>" << row.title << "</td>";
    for (std::size_t i = 0; i < std::size(columns); ++i) {
      const CollisionResult* r = find(results, row.model, row.scene, columns[i].first, row.query);
      out << "<td>" << (r ? format("%.3f", r->us_per_frame / 1000) : "") << " <span class=\"soft\">("
          << format("%.2f", row.paper[i]) << ")</span></td>";
    }
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

void write_shares(std::ostringstream& out, const Results& results) {
  std::size_t levels = 0;
  for (const CollisionResult& r : results) levels = std::max(levels, r.share_refitted.size());
  out << "<h3>Spheres refitted on demand</h3><p>Per cent of a level's spheres, Algorithm 1 repaired, full queries. The "
         "paper's men: 19 % of level 5, "
         "9 % of level 6.</p><div class=\"scroll\"><table><thead><tr><th>model, scene</th>";
  for (std::size_t l = 0; l < levels; ++l) out << "<th>" << l + 1 << "</th>";
  out << "</tr></thead><tbody>\n";
  for (const CollisionResult& r : results) {
    if (r.detector != "spherical_repaired" || r.query != Query::full) continue;
    out << "<tr><td>" << escape_html(r.model + ", " + r.scene) << "</td>";
    for (const double share : r.share_refitted) out << "<td>" << format("%.2g", 100 * share) << "</td>";
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

void write_sphere_costs(std::ostringstream& out, const std::vector<SpeedResult>& speed) {
  if (speed.empty()) return;
  out << "<h3>Refit cost of a sphere, linear and spherical</h3><p>The paper: 1.21 and 1.31 us, ratio 1.08.</p><div "
         "class=\"scroll\"><table><thead><tr>"
         "<th>model</th><th>linear, ns</th><th>Algorithm 1 repaired, ns</th><th>ratio</th></tr></thead><tbody>\n";
  for (const SpeedResult& linear : speed)
    for (const SpeedResult& spherical : speed)
      if (linear.variant == "linear" && spherical.variant == "spherical_repaired" && linear.model == spherical.model &&
          linear.level == 0 && spherical.level == 0)
        out << "<tr><td>" << escape_html(linear.model) << "</td><td>" << format("%.0f", linear.ns_per_sphere)
            << "</td><td>" << format("%.0f", spherical.ns_per_sphere) << "</td><td>"
            << format("%.2f", 1 / linear.ratio_to_repaired) << "</td></tr>\n";
  out << "</tbody></table></div>\n";
}

// Of the engine whose volumes leave rounding out of account.
void write_differences(std::ostringstream& out, const Results& results) {
  for (const DetectorKind& kind : detector_kinds()) {
    if (kind.tolerated_share == 0) continue;
    long differ = 0;
    double pairs = 0;
    for (const CollisionResult& r : results)
      if (r.detector == kind.name && r.query == Query::full) differ += r.differing_pairs, pairs += r.pairs;
    out << " Only of " << kind.name << " a share of " << format("%g", kind.tolerated_share)
        << " may: its boxes leave rounding out of account, and " << differ << " of its pairs do"
        << format(", of %.0f a frame over all models and scenes.", pairs);
  }
}

}  // namespace

std::string collisions_section(const Results& results, const std::vector<SpeedResult>& speed) {
  if (results.empty()) return "";
  std::ostringstream out;
  out << "<h2>Collision queries</h2><p>Two copies of a model pass each other, face to face: far (the roots are "
         "disjoint), near (nothing "
         "touches), light (about 50 touching pairs of triangles in the median frame), heavy (about 850, or walking "
         "through each other) and worst "
         "(in one place). Processor time of a frame from postures to pairs, on one thread: the joint-sets' data, "
         "skinning, refits, tests. Every "
         "detector's pairs are compared with those of brute force in every frame, decided exactly on the same corners: "
         "none may differ.";
  write_differences(out, results);
  out << "</p><ul>";
  for (const DetectorKind& kind : detector_kinds())
    if (std::any_of(results.begin(), results.end(), [&](const CollisionResult& r) { return r.detector == kind.name; }))
      out << "<li><b style=\"color:" << color_of(kind.origin) << "\">" << kind.name << "</b> (" << name_of(kind.origin)
          << "): " << escape_html(kind.description) << "</li>";
  out << "</ul>\n";
  for (const std::string& engine : absent_engines())
    out << "<p class=\"bad\">" << escape_html(engine) << " was not found when this was configured.</p>\n";
  for (const std::string& model : distinct(results, model_of)) {
    out << "<h3>" << escape_html(model) << "</h3>\n";
    for (const Query query : {Query::full, Query::yes_no}) {
      write_bars(out, results, model, query);
      write_times(out, results, model, query);
    }
    write_work(out, results, model);
  }
  write_table_2(out, results);
  write_shares(out, results);
  write_sphere_costs(out, speed);
  return out.str();
}

}  // namespace refitlab
