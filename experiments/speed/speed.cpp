#include "experiments/speed/speed.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>

#include "algorithms/results/result_file.hpp"

namespace refitlab {

std::vector<SpeedResult> run_speed(const Character& c, const NamedPosture& posture, const SpeedSettings& settings) {
  std::cout << "[speed] " << c.model.name << ", " << posture.name << ": " << settings.repetitions << " repetitions" << std::endl;
  std::vector<Timed> timed;
  for (const RefitVariant& variant : refit_variants()) {
    if (!variant.sound) continue;
    const auto pose = make_skinning_pose(c.model, c.sets, posture.posture, variant.skinning);
    const int count = static_cast<int>(c.tree.nodes.size());
    timed.push_back({variant.name, count, [&c, &variant, count, pose] {
                       for (int n = 0; n < count; ++n)
                         benchmark::DoNotOptimize(variant.refit(c.refit_node(n, pose, variant.pieces)));
                     }});
  }
  const auto times = ns_per_item(timed, settings);

  std::vector<SpeedResult> results;
  const auto& repaired = times.at("spherical_repaired");
  for (const RefitVariant& variant : refit_variants()) {
    const auto entry = times.find(variant.name);
    if (entry == times.end()) continue;
    results.push_back({c.model.name, posture.name, variant.name, median(entry->second),
                       median_ratio(entry->second, repaired)});
    std::printf("  %-26s %8.1f ns per sphere, %6.2f times spherical_repaired\n", variant.name.c_str(), results.back().ns_per_sphere,
                results.back().ratio_to_repaired);
  }
  return results;
}

void write_speed(const std::vector<SpeedResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "posture", "variant", "level", "quantity", "value", "unit"});
  for (const SpeedResult& r : results) {
    file.add({"speed", r.model, r.posture, r.variant, "all", "ns_per_sphere", format_number(r.ns_per_sphere), "ns"});
    file.add({"speed", r.model, r.posture, r.variant, "all", "ratio_to_repaired", format_number(r.ratio_to_repaired), "1"});
  }
  file.write(path);
}

}  // namespace refitlab
