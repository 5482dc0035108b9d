#include "experiments/report/report.hpp"

#include <cstdio>
#include <filesystem>
#include <sstream>

#include "algorithms/queries/score.hpp"
#include "algorithms/results/result_file.hpp"
#include "experiments/drawings/style.hpp"
#include "experiments/report/batch_section.hpp"
#include "experiments/report/characters.hpp"
#include "experiments/report/collisions.hpp"
#include "experiments/report/contents.hpp"
#include "experiments/report/headline.hpp"
#include "experiments/report/html.hpp"
#include "experiments/report/line_plot.hpp"
#include "experiments/report/pareto.hpp"
#include "experiments/report/rounding_section.hpp"
#include "experiments/report/triangle_growth.hpp"
#include "experiments/report/verdicts.hpp"
#include "experiments/scenes/contenders.hpp"

namespace refitlab {
namespace {

const char* const style = R"(:root{color-scheme:light dark;--ink:#1c2024;--page:#fdfdfc;--soft:#5c6670;--rule:#d8dde2;--band:#f2f4f6;--bad:#b3261e;--ground:#fff}
@media (prefers-color-scheme:dark){:root{--ink:#e4e7ea;--page:#15181b;--soft:#9aa4ae;--rule:#333a41;--band:#1e2327;--bad:#ff8a80;--ground:#b9c1c8}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--page);max-width:74rem;margin:0 auto;padding:1rem}p,li,figcaption{overflow-wrap:anywhere}
h1,h2,h3{line-height:1.2}h2{margin-top:2.5rem;border-top:1px solid var(--rule);padding-top:1rem}
.scroll{overflow-x:auto}table{border-collapse:collapse;font-size:.82rem;font-variant-numeric:tabular-nums}
th,td{padding:.2rem .55rem;text-align:right;white-space:nowrap;border-bottom:1px solid var(--rule)}
th:first-child,td:first-child{text-align:left}thead th{background:var(--band)}
.bad{color:var(--bad);font-weight:600}.soft{color:var(--soft)}
figure{margin:0}figcaption{font-size:.85rem;color:var(--soft)}
.gallery{display:grid;grid-template-columns:repeat(var(--columns),minmax(0,1fr));gap:1rem}
.tile{background:var(--ground);border-radius:6px;overflow:hidden;isolation:isolate}
.tile img,.labelled{width:100%;height:auto;display:block}.tile img,.tile image{mix-blend-mode:multiply}
.labelled text{fill:#1c2024;font:600 17px system-ui,sans-serif}
.legend{list-style:none;display:flex;flex-wrap:wrap;gap:.3rem 1.2rem;padding:0;font-size:.85rem}
.legend i{display:inline-block;width:.8rem;height:.8rem;border-radius:50%;margin-right:.4rem;vertical-align:-.08rem}
.verdict-table th,.verdict-table td{text-align:left}
nav{line-height:1.9}a{color:var(--blue)}
@media (max-width:46rem){.gallery{grid-template-columns:repeat(var(--phone),minmax(0,1fr))}}
.plot{width:100%;max-width:46rem;height:auto;font-size:12px}.plot text{fill:var(--ink)}.plot .title{font-size:14px;font-weight:600}
.plot .grid{stroke:var(--rule)}details{margin:.5rem 0}summary{cursor:pointer}
)";

LevelTightness all_levels(const std::vector<LevelTightness>& levels) {
  LevelTightness sum;
  for (const auto& level : levels) sum.merge(level);
  return sum;
}

void write_plot(std::ostringstream& out, const TightnessResult& r) {
  LinePlot plot{.title = r.model + ", " + r.posture, .x_label = "level of the tree", .y_label = "average radius / Optimal", .lines = {}};
  for (const char* column : {"spherical_printed_signed", "spherical_repaired", "control_exact", "control_sets_exact", "control_mixed",
                             "control_clusters", "bottom_up"}) {
    PlotLine line{column, {}, plot_color(plot.lines.size())};
    const auto& levels = r.tightness.at(column);
    for (std::size_t l = 0; l < levels.size(); ++l)
      if (levels[l].nodes > levels[l].undefined) line.points.emplace_back(l + 1, levels[l].ratio_to_optimal());
    if (!line.points.empty()) plot.lines.push_back(std::move(line));
  }
  PlotLine paper{"the paper, on its creature", {}, "currentColor", true};
  const auto ratios = paper_ratios_to_optimal();
  for (std::size_t l = 0; l < ratios.size(); ++l) paper.points.emplace_back(l + 1, ratios[l]);
  plot.lines.push_back(std::move(paper));
  out << plot.svg();
}

// What one would take from a model's plots and tables.
void write_conclusion(std::ostringstream& out, const std::vector<TightnessResult>& results, const std::string& model) {
  const std::string& name = default_variant(Skinning::spherical).name;
  double least = 1e300, most = 0;
  LevelTightness all;
  for (const TightnessResult& r : results) {
    if (r.model != model) continue;
    for (const LevelTightness& level : r.tightness.at(name)) {
      least = std::min(least, level.ratio_to_optimal()), most = std::max(most, level.ratio_to_optimal());
      all.merge(level);
    }
  }
  out << "<p>The default, <b>" << name << "</b>: on average " << format("%.2f", least) << " to " << format("%.2f", most)
      << " times the smallest radius, by level and posture; " << all.misses << " of " << all.nodes << " balls miss a vertex.</p>\n";
}

void write_level_table(std::ostringstream& out, const TightnessResult& r) {
  const auto columns = tightness_columns();
  const auto paper = paper_ratios_to_optimal();
  out << "<details><summary>min / avg / max radius by level, and avg / Optimal</summary><div class=\"scroll\"><table><thead><tr><th>level</th><th>balls</th>";
  for (const auto& c : columns) out << "<th>" << c << "</th>";
  out << "<th>paper, avg / Optimal</th></tr></thead><tbody>\n";
  for (std::size_t l = 0; l < r.tightness.at("optimal").size(); ++l) {
    out << "<tr><td>" << l + 1 << "</td><td>" << r.tightness.at("optimal")[l].nodes << "</td>";
    for (const auto& c : columns) {
      const LevelTightness& t = r.tightness.at(c)[l];
      if (t.nodes == t.undefined)
        out << "<td class=\"bad\">undefined</td>";
      else
        out << "<td>" << format("%.3g", t.radius_min) << " / " << format("%.3g", t.radius_avg()) << " / " << format("%.3g", t.radius_max)
            << "<br><b>" << format("%.2f", t.ratio_to_optimal()) << "</b></td>";
    }
    out << "<td>" << (l < paper.size() ? format("%.2f", paper[l]) : "") << "</td></tr>\n";
  }
  out << "</tbody></table></div></details>\n";
}

void write_miss_table(std::ostringstream& out, const std::vector<TightnessResult>& results) {
  std::vector<std::string> columns;
  for (const auto& c : tightness_columns())
    if (c != "reference" && c.rfind("optimal", 0) != 0) columns.push_back(c);
  out << "<div class=\"scroll\"><table><thead><tr><th>model, posture</th><th>balls</th>";
  for (const auto& c : columns) out << "<th>" << c << "</th>";
  out << "</tr></thead><tbody>\n";
  for (const TightnessResult& r : results) {
    out << "<tr><td>" << escape_html(r.model + ", " + r.posture) << " (" << r.postures << ")</td><td>"
        << all_levels(r.tightness.at("optimal")).nodes << "</td>";
    for (const auto& c : columns) {
      const LevelTightness t = all_levels(r.tightness.at(c));
      out << "<td" << (t.misses ? " class=\"bad\"" : "") << ">" << t.misses;
      if (t.undefined) out << " <span class=\"soft\">(" << t.undefined << " undefined)</span>";
      if (t.worst_miss > 0) out << " <span class=\"soft\">by up to " << format("%.2g", t.worst_miss) << "</span>";
      out << "</td>";
    }
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

void write_tightness_section(std::ostringstream& out, const std::vector<TightnessResult>& results) {
  if (results.empty()) return;
  out << "<h2>Tightness</h2><p>Radii of the refitted balls by level of the sphere tree, beside the smallest balls of the deformed "
         "vertices (Optimal); the plots have some of the variants, the tables all. <i>reference</i> is the ball of the reference posture. "
         "Beside ours stands the paper's own ratio, of its creature. Where several postures were sampled, averages run over all of them.</p><ul>";
  for (const Contender& c : contenders())
    out << "<li><b>" << c.name << "</b>: " << escape_html(c.description) << (c.variant->sound ? "" : " (unsound)") << "</li>";
  out << "<li><b>linear_under_spherical</b>: the linear refit's balls against spherically blended vertices</li>"
         "<li><b>bottom_up</b>: smallest balls of the deformed leaf vertices, then of the children [Brown et al. 2001]</li></ul>\n"
         "<h3>Balls that miss a deformed vertex</h3><p>Outside by more than "
      << format("%.0e", miss_tolerance) << " of the root's reference radius; in model units. A ball that is not a number or of negative "
         "radius is undefined and counts as a miss.</p>\n";
  write_miss_table(out, results);
  std::string model;
  for (const TightnessResult& r : results) {
    if (r.model != model) {
      out << "<h3>" << escape_html(model = r.model) << "</h3>\n";
      write_conclusion(out, results, model);
    }
    write_plot(out, r);
    write_level_table(out, r);
  }
}

void write_speed_section(std::ostringstream& out, const std::vector<SpeedResult>& results) {
  if (results.empty()) return;
  out << "<h2>Speed</h2><p>Refitting all spheres of a tree in one posture, on one thread, the frame's joint-set data given. Median "
         "nanoseconds per sphere, and the median ratio to Algorithm 1 repaired in the same repetition. Only variants whose balls are "
         "proved to enclose.</p><div class=\"scroll\"><table><thead><tr><th>model, posture</th><th>variant</th><th>ns per sphere</th>"
         "<th>ratio</th></tr></thead><tbody>\n";
  for (const SpeedResult& r : results)
    if (r.level == 0)
      out << "<tr><td>" << escape_html(r.model + ", " + r.posture) << "</td><td>" << r.variant << "</td><td>" << format("%.0f", r.ns_per_sphere)
        << "</td><td>" << format("%.2f", r.ratio_to_repaired) << "</td></tr>\n";
  out << "</tbody></table></div>\n";
}

void write_queries_section(std::ostringstream& out, const std::vector<QueryResult>& results) {
  if (results.empty()) return;
  out << "<h2>Generated queries</h2><p>" << results[0].queries << " refit cases in exact rationals: 1 to 3 joint-sets of 1 to 5 joints, "
         "wild and gentle postures, a quarter of them degenerate. Missed: queries of which the ball in double leaves a vertex outside, "
         "decided exactly; beyond rounding where by more than " << format("%.0e", query_tolerance) << " of the coordinates' size. Looseness: "
         "radius over the smallest ball of sampled true positions. The cost is rough.</p><div class=\"scroll\"><table><thead><tr>"
         "<th>variant</th><th>undefined</th><th>missed</th><th>missed beyond rounding</th><th>worst miss</th><th>looseness, mean</th>"
         "<th>median</th><th>max</th><th>ns per refit</th></tr></thead><tbody>\n";
  for (const QueryResult& r : results)
    if (r.share == "all")
      out << "<tr><td>" << r.variant << "</td><td>" << r.undefined << "</td><td>" << r.misses << "</td><td"
          << (r.misses_beyond_tolerance ? " class=\"bad\"" : "") << ">" << r.misses_beyond_tolerance << "</td><td>"
          << format("%.1e", r.worst_miss) << "</td><td>" << format("%.3f", r.looseness_mean) << "</td><td>"
          << format("%.3f", r.looseness_median) << "</td><td>" << format("%.3g", r.looseness_max) << "</td><td>"
          << format("%.0f", r.ns_per_refit) << "</td></tr>\n";
  out << "</tbody></table></div>\n";
}

// A row a model and kind of volume: all levels and posture sets of the model together, and the worst of them.
void write_volumes_section(std::ostringstream& out, const VolumeResults& results) {
  if (results.tightness.empty()) return;
  out << "<h2>Boxes, k-DOPs and oriented boxes</h2><p>Around the control points of the default variant. Size: the radius of the ball of equal "
         "surface area, so that a ball's size is its radius and flat volumes have one. Optimal: the same kind of volume around the deformed "
         "vertices. On a sample of each level's nodes, averaged by level and posture set.</p><div class=\"scroll\"><table><thead><tr>"
         "<th>model</th><th>volume</th><th>size / Optimal, mean</th><th>worst level</th><th>size / radius of the ball</th><th>volume / volume of "
         "the ball</th><th>misses</th><th>ns per node</th><th>times the ball</th></tr></thead><tbody>\n";
  for (const VolumeCost& cost : results.costs) {
    double ratio = 0, worst = 0, size = 0, volume = 0;
    long misses = 0;
    int count = 0;
    for (const VolumeResult& r : results.tightness) {
      const auto levels = r.volumes.find(cost.variant);
      if (r.model != cost.model || levels == r.volumes.end()) continue;
      for (const LevelVolumes& level : levels->second) {
        ratio += level.ratio_to_optimal(), size += level.size_to_ball(), volume += level.volume_to_ball();
        worst = std::max(worst, level.ratio_to_optimal());
        misses += level.misses;
        ++count;
      }
    }
    if (count == 0) continue;
    out << "<tr><td>" << escape_html(cost.model) << "</td><td>" << cost.variant << "</td><td>" << format("%.3f", ratio / count) << "</td><td>"
        << format("%.3f", worst) << "</td><td>" << format("%.2f", size / count) << "</td><td>" << format("%.2f", volume / count) << "</td><td"
        << (misses ? " class=\"bad\"" : "") << ">" << misses << "</td><td>" << format("%.0f", cost.ns_per_node) << "</td><td>"
        << format("%.2f", cost.ratio_to_ball) << "</td></tr>\n";
  }
  out << "</tbody></table></div>\n";
}

void write_growth_section(std::ostringstream& out, const std::vector<JointGrowth>& rows) {
  if (rows.empty()) return;
  out << "<h2>Growth with joints</h2><p>A tube of 20,000 triangles with ever more joints in a row, refitted by the default variant: nodes of "
         "more than 16 joint-sets by themselves, and from below. The cost of a ball whose front the frame knows does not depend on the number of "
         "joints: the root's grows by an exponent of " << format("%.2f", exponent(rows, &JointGrowth::root_from_known))
      << " from 100 to 1000 joints while the front fills up to its 64 balls, and no further.</p>\n";
  LinePlot plot{.title = "the root's ball", .x_label = "joints", .y_label = "us", .lines = {}, .log_x = true, .log_y = true};
  const std::pair<const char*, double JointGrowth::*> lines[] = {{"by itself", &JointGrowth::own_root},
                                                                 {"from below, asked first", &JointGrowth::root_from_below},
                                                                 {"from a known front", &JointGrowth::root_from_known}};
  for (const auto& [label, cost] : lines) {
    PlotLine line{label, {}, plot_color(plot.lines.size())};
    for (const JointGrowth& r : rows)
      if (r.*cost > 0) line.points.emplace_back(r.joints, r.*cost / 1000);
    plot.lines.push_back(std::move(line));
  }
  out << plot.svg()
      << "<div class=\"scroll\"><table><thead><tr><th>joints</th><th>joint-sets</th><th>nodes of many</th><th>all their balls, by themselves, us"
         "</th><th>from below, us</th><th>root by itself, us</th><th>from below, us</th><th>from a known front, us</th><th>root / Optimal, by "
         "itself</th><th>from below</th></tr></thead><tbody>\n";
  for (const JointGrowth& r : rows) {
    out << "<tr><td>" << r.joints << "</td><td>" << r.joint_sets << "</td><td>" << r.many << "</td>";
    for (const double ns : {r.own, r.from_below, r.own_root, r.root_from_below, r.root_from_known}) out << "<td>" << format("%.1f", ns / 1000) << "</td>";
    out << "<td>" << format("%.3f", r.root_ratio) << "</td><td>" << format("%.3f", r.root_ratio_from_below) << "</td></tr>\n";
  }
  out << "</tbody></table></div>\n";
}

std::string head() {
  return std::string("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
                     "content=\"width=device-width,initial-scale=1\"><title>refitlab report</title><style>\n") +
         style + drawings::style + "</style></head><body>\n";
}

std::string introduction(const Report& report) {
  std::string out = "<h1>refitlab: bounding what skinning does to vertices, without touching them</h1>\n";
  for (const auto& absent : report.absent_models)
    out += "<p class=\"bad\">The model " + escape_html(absent) + " was absent from this run: it could not be fetched.</p>\n";
  if (!report.reference.empty())
    out += "<p>Lemma by lemma, with exercises, and how to build on it: <a href=\"" + report.reference + "/index.html\">the reference</a>.</p>\n";
  return out;
}

}  // namespace

void write_report(const Report& report, const std::string& path) {
  const Provenance& p = Provenance::of_this_build();
  const std::string folder = std::filesystem::path(path).parent_path().string();
  std::ostringstream out;
  out << figure_section(report.figures) << report.explorer << headline_section(report.collisions)
      << verdicts_section(report.verdicts, p.commit, folder, report.reference);
  write_tightness_section(out, report.tightness);
  write_speed_section(out, report.speed);
  out << pareto_section(report.speed, report.tightness);
  out << batch_section(report.batches) << rounding_section(report.rounding);
  write_volumes_section(out, report.volumes);
  out << collisions_section(report.collisions, report.speed);
  out << triangle_growth_section(report.triangle_growth);
  write_growth_section(out, report.joint_growth);
  write_characters_section(out, report.character_growth);
  write_queries_section(out, report.queries);
  out << "<h2>Provenance</h2><p class=\"soft\">Commit " << p.commit << " (" << p.dirty << "), " << escape_html(p.compiler) << ", flags "
      << escape_html(p.flags) << ", " << escape_html(p.cpu) << ".</p>\n";
  const Contents contents = contents_of(out.str());
  write_whole(path, head() + introduction(report) + contents.nav + contents.body + "</body></html>\n");
}

}  // namespace refitlab
