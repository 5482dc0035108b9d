// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tightness/tightness.hpp"

#include <cstdio>
#include <iostream>

#include "algorithms/results/result_file.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/methods.hpp"

namespace refitlab {
namespace {

void print_table(const TightnessResult& r) {
  const char* const shown[] = {"reference",          "linear", "spherical_printed_signed", "spherical_repaired",
                               "spherical_miniball", "optimal"};
  const char* const heads[] = {"Reference", "Linear", "Printed*", "Repaired", "Exact balls", "Optimal"};
  std::printf("\n%s, %s (%d pose%s): radii min / avg / max, and avg / Optimal\n", r.model.c_str(), r.pose.c_str(), r.poses,
              r.poses == 1 ? "" : "s");
  std::printf("%5s %7s", "level", "nodes");
  for (const char* head : heads) std::printf(" | %-29s", head);
  std::printf("\n");
  const std::size_t levels = r.tightness.at("optimal").size();
  for (std::size_t l = 0; l < levels; ++l) {
    std::printf("%5zu %7ld", l + 1, r.tightness.at("optimal")[l].nodes / r.poses);
    for (const char* column : shown) {
      const LevelTightness& t = r.tightness.at(column)[l];
      std::printf(" | %7.4g %7.4g %7.4g %5.2f", t.radius_min, t.radius_avg(), t.radius_max, t.ratio_to_optimal());
    }
    std::printf("\n");
  }
  std::printf("  avg / Optimal of every variant, level by level:\n");
  for (const Method& method : methods()) {
    std::printf("  %-31s", method.name.c_str());
    for (const LevelTightness& t : r.tightness.at(method.name)) std::printf(" %5.3f", t.ratio_to_optimal());
    std::printf("\n");
  }
  std::printf("  balls that miss a vertex (undefined; worst miss):");
  for (const auto& column : tightness_columns()) {
    LevelTightness all;
    for (const auto& level : r.tightness.at(column)) all.merge(level);
    if (all.misses)
      std::printf("  %s %ld of %ld (%ld; %.3g)", column.c_str(), all.misses, all.nodes, all.undefined, all.worst_miss);
  }
  std::printf("\n");
}

}  // namespace

std::vector<TightnessResult> run_tightness(const AnimatedCharacter& c, const std::vector<NamedPose>& poses,
                                           const TightnessSettings& settings) {
  std::vector<TightnessResult> results;
  auto sets = pose_sets(c, settings.times_per_clip);
  for (const NamedPose& p : poses) sets.push_back({p.name, {p.pose}, p.kind});
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::cout << "[tightness] " << c.mesh.name << ": " << sets[i].name << " (" << i + 1 << "/" << sets.size() << "), "
              << sets[i].poses.size() << " poses" << std::endl;
    results.push_back(
        {c.mesh.name, sets[i].name, sets[i].kind, static_cast<int>(sets[i].poses.size()), measure_tightness(c, sets[i])});
    print_table(results.back());
  }
  return results;
}

void write_tightness(const std::vector<TightnessResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "pose_kind", "poses"});
  for (const auto& r : results)
    for (const auto& column : r.tightness)
      for (std::size_t l = 0; l < column.second.size(); ++l) {
        const std::string& variant = column.first;
        const LevelTightness& t = column.second[l];
        const auto add = [&](const char* quantity, double value, const char* unit) {
          file.add({"tightness", r.model, r.pose, variant, std::to_string(l + 1), quantity, format_number(value), unit,
                    r.pose_kind, std::to_string(r.poses)});
        };
        if (t.nodes > t.undefined) {
          add("radius_min", t.radius_min, "model unit");
          add("radius_avg", t.radius_avg(), "model unit");
          add("radius_max", t.radius_max, "model unit");
          if (t.optimal_sum > 0) add("radius_ratio_to_optimal", t.ratio_to_optimal(), "1");
        }
        add("nodes", static_cast<double>(t.nodes), "1");
        add("undefined", static_cast<double>(t.undefined), "1");
        if (variant == "reference") continue;  // it bounds the reference pose only
        add("missed_balls", static_cast<double>(t.misses), "1");
        add("worst_miss", t.worst_miss, "model unit");
      }
  file.write(path);
}

}  // namespace refitlab
