#include "experiments/report/pareto.hpp"

#include <algorithm>
#include <sstream>

#include "experiments/report/html.hpp"
#include "experiments/report/line_plot.hpp"
#include "experiments/scenes/contenders.hpp"

namespace refitlab {
namespace {

// The models of the speed experiment, in its order.
std::vector<std::string> models_of(const std::vector<SpeedResult>& speed) {
  std::vector<std::string> models;
  for (const SpeedResult& r : speed)
    if (std::find(models.begin(), models.end(), r.model) == models.end()) models.push_back(r.model);
  return models;
}

const char* name_of(Skinning s) {
  return s == Skinning::linear ? "linear" : s == Skinning::dual_quaternion ? "dual quaternion" : "spherical";
}

LinePlot price_plot(const std::string& model, const std::vector<Price>& all) {
  LinePlot plot{.title = model + ", spherical blending", .x_label = "ns per sphere", .y_label = "average radius / Optimal: worst level",
                .lines = {}, .log_x = true};
  for (const Price& p : all)
    if (p.skinning == Skinning::spherical)
      plot.lines.push_back({p.variant, {{p.ns_per_sphere, p.worst_ratio}}, plot_color(plot.lines.size()), plot.lines.size() >= 8});
  return plot;
}

LinePlot level_plot(const std::string& model, const std::vector<SpeedResult>& speed) {
  LinePlot plot{.title = model + ": cost by level", .x_label = "level of the tree", .y_label = "ns per sphere", .lines = {}, .log_y = true};
  for (const char* variant : {"spherical_repaired", "control_exact", "control_sets_exact", "control_mixed", "control_clusters"}) {
    PlotLine line{variant, {}, plot_color(plot.lines.size())};
    for (const SpeedResult& r : speed)
      if (r.model == model && r.variant == variant && r.level > 0) line.points.emplace_back(r.level, r.ns_per_sphere);
    std::sort(line.points.begin(), line.points.end());
    plot.lines.push_back(std::move(line));
  }
  return plot;
}

void write_table(std::ostringstream& out, const std::vector<Price>& all) {
  out << "<div class=\"scroll\"><table><thead><tr><th>variant</th><th>skinning</th><th>ns per sphere</th><th>times "
         "repaired</th><th>radius / Optimal, mean</th><th>worst level</th><th>balls that miss</th><th>best at its price</th></tr>"
         "</thead><tbody>\n";
  for (const Price& p : all)
    out << "<tr><td>" << p.variant << "</td><td>" << name_of(p.skinning) << "</td><td>" << format("%.0f", p.ns_per_sphere) << "</td><td>"
        << format("%.2f", p.ratio_to_repaired) << "</td><td>" << format("%.3f", p.mean_ratio) << "</td><td>"
        << format("%.3f", p.worst_ratio) << "</td><td" << (p.misses ? " class=\"bad\"" : "") << ">" << p.misses << "</td><td>"
        << (p.on_front ? "yes" : "") << "</td></tr>\n";
  out << "</tbody></table></div>\n";
}

// What the run says of one variant, over all models.
struct Summary {
  double cheapest = 1e300, dearest = 0, worst = 0;
  void add(const Price& p) {
    cheapest = std::min(cheapest, p.ratio_to_repaired);
    dearest = std::max(dearest, p.ratio_to_repaired);
    worst = std::max(worst, p.worst_ratio);
  }
  std::string text() const {
    const std::string low = format("%.2f", cheapest), high = format("%.2f", dearest);
    return "costs " + low + (low == high ? "" : " to " + high) + " times Algorithm 1 repaired, and on its worst level" +
           format(" the average radius is %.3f times the optimal one", worst);
  }
};

}  // namespace

std::vector<Price> prices(const std::vector<SpeedResult>& speed, const std::vector<TightnessResult>& tightness,
                          const std::string& model) {
  std::vector<Price> out;
  for (const SpeedResult& s : speed) {
    if (s.model != model || s.level != 0) continue;
    Price p{s.variant, contender(s.variant).variant->skinning, s.ns_per_sphere, s.ratio_to_repaired, 0, 0, 0, false};
    int count = 0;
    for (const TightnessResult& t : tightness) {
      if (t.model != model) continue;
      for (const LevelTightness& level : t.tightness.at(s.variant)) {
        p.misses += level.misses;
        if (level.nodes == level.undefined) continue;
        p.mean_ratio += level.ratio_to_optimal();
        p.worst_ratio = std::max(p.worst_ratio, level.ratio_to_optimal());
        ++count;
      }
    }
    if (count == 0) continue;
    p.mean_ratio /= count;
    out.push_back(p);
  }
  std::sort(out.begin(), out.end(), [](const Price& a, const Price& b) { return a.ns_per_sphere < b.ns_per_sphere; });
  for (Price& p : out)
    p.on_front = std::none_of(out.begin(), out.end(), [&](const Price& q) {
      return q.skinning == p.skinning && q.ns_per_sphere <= p.ns_per_sphere && q.worst_ratio < p.worst_ratio;
    });
  return out;
}

std::string pareto_section(const std::vector<SpeedResult>& speed, const std::vector<TightnessResult>& tightness) {
  if (speed.empty() || tightness.empty()) return "";
  const std::string preferred = default_variant(Skinning::spherical).name, tightest = "control_clusters", below = preferred + "_from_below";
  std::ostringstream body;
  Summary of_default, of_tightest, of_below;
  for (const std::string& model : models_of(speed)) {
    const auto all = prices(speed, tightness, model);
    for (const Price& p : all) {
      if (p.variant == preferred) of_default.add(p);
      if (p.variant == tightest) of_tightest.add(p);
      if (p.variant == below) of_below.add(p);
    }
    body << "<h3>" << escape_html(model) << "</h3>\n" << price_plot(model, all).svg() << level_plot(model, speed).svg();
    write_table(body, all);
  }
  std::ostringstream out;
  out << "<h2>Tightness against cost</h2><p>Each variant by what a sphere costs, over the whole tree in the posture of the speed table, "
         "and by how much larger than the smallest ball of the deformed vertices it is: the average over a level, on the worst level and "
         "posture set. Down and left is better. Best at its price: no variant of the same skinning that costs as little is tighter there.</p>"
         "<p>The default is <b>" << preferred << "</b>: it " << of_default.text()
      << ". Most nodes of a tree hold a handful of vertices, and to skin these costs no more than to bound them by corners and control "
         "points; it does so where it pays, and bounds joint-sets above. In queries take it from below (<b>" << below << "</b>): it "
      << of_below.text() << ", and the top of the tree, whose nodes have many joint-sets, is made once a frame from what is below it. The tightest, <b>" << tightest << "</b>, " << of_tightest.text()
      << ".</p>\n" << body.str();
  return out.str();
}

}  // namespace refitlab
