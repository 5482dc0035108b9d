// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/crossfades.hpp"

#include <chrono>
#include <cstdio>
#include <iostream>

#include "algorithms/results/result_file.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/scenes/skinning_name.hpp"

namespace refitlab {
namespace {

void print(const CrossfadesResult& r) {
  if (!r.refused.empty()) std::printf("  %s: no bound: %s\n", table_name_of(r.skinning), r.refused.c_str());
  else std::printf("  %s: %zu crossfades, bounded in %.2f s\n", table_name_of(r.skinning), r.crossfades.size(), r.seconds);
  for (const CrossfadeResult& c : r.crossfades)
    std::printf("    %s to %s: volumes %.4f, %.4f of clusters; outside %ld, of both clips' bounds %ld\n", c.first.c_str(),
                c.second.c_str(), c.whole_ratio, c.cluster_ratio, c.outside, c.out_of_both_clips);
  std::cout << std::flush;
}

}  // namespace

std::vector<CrossfadesResult> run_crossfades(const Model& made, const CrossfadeSettings& settings) {
  const Model model = with_keys(made, settings.clips);
  std::vector<CrossfadesResult> results;
  if (model.clips.size() < 2) return results;
  const JointSets sets(model);
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}) {
    if (skinning != Skinning::linear && !settings.all_skinnings) continue;
    CrossfadesResult& result = results.emplace_back(CrossfadesResult{model.name, skinning});
    const auto start = std::chrono::steady_clock::now();
    try {
      const ModelBounds bounds =
          bound_model(model, {.skinning = skinning, .cluster_triangles = settings.cluster_triangles, .crossfades = true});
      result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      for (std::size_t c = 0; c < bounds.crossfades.size(); ++c)
        result.crossfades.push_back(check_crossfade(model, sets, bounds, c, settings));
    } catch (const ModelError& e) {
      result.refused = e.what();
    }
    print(result);
  }
  return results;
}

void write_crossfades(const std::vector<CrossfadesResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "skinning"});
  for (const CrossfadesResult& r : results) {
    const auto add = [&](const std::string& crossfade, const char* quantity, double value, const char* unit = "1") {
      file.add(
          {"crossfades", r.model, crossfade, "bounds", "all", quantity, format_number(value), unit, table_name_of(r.skinning)});
    };
    add("all", "refused", !r.refused.empty());
    add("all", "bounding_seconds", r.seconds, "s");
    for (const CrossfadeResult& c : r.crossfades) {
      const std::string name = c.first + " to " + c.second;
      add(name, "checks", static_cast<double>(c.places));
      add(name, "missed_places", static_cast<double>(c.outside));
      add(name, "undecided", static_cast<double>(c.undecided));
      add(name, "character_volume_ratio", c.whole_ratio);
      add(name, "mean_cluster_volume_ratio", c.cluster_ratio);
      add(name, "clusters", static_cast<double>(c.clusters));
      add(name, "flat_clusters", static_cast<double>(c.flat_clusters));
      add(name, "out_of_both_clips", static_cast<double>(c.out_of_both_clips));
    }
  }
  file.write(path);
}

}  // namespace refitlab
