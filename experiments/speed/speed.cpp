// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/speed.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>
#include <memory>

#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/methods.hpp"

namespace refitlab {

namespace {

// Refits these nodes of the character by each sound variant that stands alone. If these are all nodes, it takes the other
// variants too, which make some nodes from others.
std::vector<Timed> refits_of(const AnimatedCharacter& c, const Pose& pose, const std::vector<int>& nodes) {
  std::vector<Timed> out;
  for (const Method& method : methods()) {
    const RefitVariant& variant = *method.variant;
    if (!variant.sound) continue;
    const auto palette = std::make_shared<SkinningPalette<double>>(make_skinning_palette(c.mesh, c.sets, pose, variant.skinning));
    const int count = static_cast<int>(nodes.size());
    if (method.stands_alone()) {
      out.push_back({method.name, count, [&c, &variant, &nodes, palette] {
                       for (const int n : nodes)
                         benchmark::DoNotOptimize(variant.refit(c.refit_node(n, *palette, variant.pieces)));
                     }});
    } else if (nodes.size() == c.tree.nodes.size()) {
      const auto frame = std::make_shared<FrameRefits>(c, variant, method.options);
      out.push_back({method.name, count, [frame, palette] {
                       frame->begin(*palette);
                       frame->refit_all();
                       benchmark::DoNotOptimize((*frame)[0]);
                     }});
    }
  }
  return out;
}

}  // namespace

std::vector<SpeedResult> run_speed(const AnimatedCharacter& c, const NamedPose& pose, const SpeedSettings& settings) {
  std::cout << "[speed] " << c.mesh.name << ", " << pose.name << ": " << settings.repetitions << " repetitions" << std::endl;
  std::vector<SpeedResult> results;
  for (int level = 0; level <= c.tree.level_count(); ++level) {
    std::vector<int> nodes;
    for (std::size_t n = 0; n < c.tree.nodes.size(); ++n)
      if (level == 0 || c.tree.nodes[n].level == level) nodes.push_back(static_cast<int>(n));
    const double share = level == 0 ? 1 : 0.1;
    const auto times = ns_per_item(refits_of(c, pose.pose, nodes), {settings.seconds_per_run * share, settings.repetitions});
    for (const auto& [variant, entries] : times)
      results.push_back(
          {c.mesh.name, pose.name, variant, level, median(entries), median_ratio(entries, times.at("spherical_repaired"))});
    if (level > 0) continue;
    for (const SpeedResult& r : results)
      std::printf("  %-32s %8.1f ns per sphere, %6.2f times spherical_repaired\n", r.variant.c_str(), r.ns_per_sphere,
                  r.ratio_to_repaired);
  }
  return results;
}

void write_speed(const std::vector<SpeedResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit"});
  for (const SpeedResult& r : results) {
    const std::string level = r.level == 0 ? "all" : std::to_string(r.level);
    file.add({"speed", r.model, r.pose, r.variant, level, "ns_per_sphere", format_number(r.ns_per_sphere), "ns"});
    file.add({"speed", r.model, r.pose, r.variant, level, "time_ratio_to_repaired", format_number(r.ratio_to_repaired), "1"});
  }
  file.write(path);
}

}  // namespace refitlab
