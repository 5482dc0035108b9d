// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tightness/volumes.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>
#include <numbers>

#include "algorithms/bake/parallel.hpp"
#include "algorithms/methods/refit/volume_variants.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/tightness/measure.hpp"

namespace refitlab {
namespace {

// Dual quaternions are left out: where a blend may vanish, their volumes have no size.
constexpr Skinning measured_skinnings[] = {Skinning::spherical, Skinning::linear};

std::vector<const VolumeVariant*> variants_of(Skinning skinning) {
  std::vector<const VolumeVariant*> out;
  for (const VolumeVariant& variant : volume_variants())
    if (variant.skinning == skinning) out.push_back(&variant);
  return out;
}

double size_of(const Volume& volume) {
  const double area = std::visit([](const auto& v) { return v.surface_area(); }, volume);
  return std::sqrt(area / (4 * std::numbers::pi));
}

double volume_of(const Ball3<double>& ball) { return 4 * std::numbers::pi / 3 * std::pow(ball.radius, 3); }

// Returns whether all points are inside. The volumes allow for rounding themselves.
bool holds_all(const Volume& volume, std::span<const Ball3<double>> points) {
  return std::visit(
      [&](const auto& v) {
        for (const auto& p : points)
          if (v.contains(p.center) != Verdict::holds) return false;
        return true;
      },
      volume);
}

// Returns the nodes that are measured. There are at most this many of each level, evenly spread. Nodes are in the order of their
// levels.
std::vector<int> some_nodes(const SphereTree& tree, int per_level) {
  std::vector<int> out;
  for (std::size_t first = 0, next; first < tree.nodes.size(); first = next) {
    for (next = first; next < tree.nodes.size() && tree.nodes[next].level == tree.nodes[first].level;) ++next;
    const std::size_t count = next - first, taken = std::min<std::size_t>(count, static_cast<std::size_t>(per_level));
    for (std::size_t i = 0; i < taken; ++i) out.push_back(static_cast<int>(first + i * count / taken));
  }
  return out;
}

using Volumes = std::map<std::string, std::vector<LevelVolumes>>;

void measure(const AnimatedCharacter& c, const std::vector<int>& nodes, const Pose& pose, Skinning skinning, Volumes& out) {
  const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
  const auto deformed = skin(c.mesh, c.sets, palette, skinning);
  const double tolerance = miss_tolerance * c.tree.nodes[0].reference.radius;
  const RefitVariant& balls = default_variant(skinning);
  for (const VolumeVariant* variant : variants_of(skinning)) out[variant->name].resize(c.tree.level_count());
  std::vector<Ball3<double>> points;
  for (const int n : nodes) {
    points.clear();
    for (const int v : c.vertices[n]) points.push_back({deformed[v], 0.0});
    const Ball3<double> ball = balls.refit(c.refit_node(n, palette, balls.pieces));
    for (const VolumeVariant* variant : variants_of(skinning)) {
      LevelVolumes& level = out[variant->name][c.tree.nodes[n].level - 1];
      const Volume volume = variant->refit(c.refit_node(n, palette, variant->pieces));
      ++level.nodes;
      level.misses += !holds_all(volume, points);
      level.size_sum += size_of(volume);
      level.optimal_sum += size_of(variant->around(points));
      level.ball_sum += ball.radius;
      if (ball.radius <= tolerance) continue;  // the vertices are one point, up to rounding
      ++level.solid_nodes;
      level.volume_ratio_sum += std::visit([](const auto& v) { return v.volume(); }, volume) / volume_of(ball);
    }
  }
}

Volumes measure(const AnimatedCharacter& c, const std::vector<int>& nodes, const PoseSet& set) {
  std::vector<Volumes> parts(set.poses.size());
  parallel_for(parts.size(), [&](std::size_t i) {
    for (const Skinning skinning : measured_skinnings) measure(c, nodes, set.poses[i], skinning, parts[i]);
  });
  Volumes total = std::move(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i)  // in order, so that sums do not depend on the threads
    for (auto& [variant, levels] : total)
      for (std::size_t l = 0; l < levels.size(); ++l) levels[l].merge(parts[i][variant][l]);
  return total;
}

void print_table(const VolumeResult& r) {
  std::printf("\n%s, %s (%d pose%s): size / the same volume of the deformed vertices; volume / the ball's\n", r.model.c_str(),
              r.pose.c_str(), r.poses, r.poses == 1 ? "" : "s");
  std::printf("%5s %7s", "level", "nodes");
  for (const auto& [variant, by_level] : r.volumes) std::printf(" | %-13s", variant.c_str());
  std::printf("\n");
  const std::size_t levels = r.volumes.begin()->second.size();
  for (std::size_t l = 0; l < levels; ++l) {
    std::printf("%5zu %7ld", l + 1, r.volumes.begin()->second[l].nodes / r.poses);
    for (const auto& [variant, by_level] : r.volumes) {
      const LevelVolumes& level = by_level[l];
      std::printf(" | %6.3f %6.3f", level.ratio_to_optimal(), level.volume_to_ball());
    }
    std::printf("\n");
  }
  long misses = 0, nodes = 0;
  for (const auto& [variant, by_level] : r.volumes)
    for (const LevelVolumes& level : by_level) misses += level.misses, nodes += level.nodes;
  std::printf("  volumes that miss a vertex: %ld of %ld\n", misses, nodes);
}

std::vector<VolumeCost> measure_costs(const AnimatedCharacter& c, const NamedPose& pose, Skinning skinning,
                                      const SpeedSettings& settings) {
  const auto palette = make_skinning_palette(c.mesh, c.sets, pose.pose, skinning);
  const int count = static_cast<int>(c.tree.nodes.size());
  std::vector<Timed> timed;
  const auto add = [&](const auto& variant) {
    timed.push_back({variant.name, count, [&c, &palette, &variant, count] {
                       for (int n = 0; n < count; ++n)
                         benchmark::DoNotOptimize(variant.refit(c.refit_node(n, palette, variant.pieces)));
                     }});
  };
  const RefitVariant& balls = default_variant(skinning);
  add(balls);
  for (const VolumeVariant* variant : variants_of(skinning)) add(*variant);
  const auto times = ns_per_item(timed, settings);
  std::vector<VolumeCost> out;
  for (const Timed& refit : timed) {
    const auto& own = times.at(refit.name);
    out.push_back({c.mesh.name, pose.name, pose.kind, refit.name, median(own), median_ratio(own, times.at(balls.name))});
    std::printf("  %-26s %8.1f ns per node, %6.2f times %s\n", refit.name.c_str(), out.back().ns_per_node,
                out.back().ratio_to_ball, balls.name.c_str());
  }
  return out;
}

}  // namespace

void run_volumes(const AnimatedCharacter& c, const NamedPose& pose, const VolumeSettings& settings, VolumeResults& results) {
  auto sets = pose_sets(c, settings.times_per_clip);
  sets.push_back({pose.name, {pose.pose}, pose.kind});
  const std::vector<int> nodes = some_nodes(c.tree, settings.nodes_per_level);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const int poses = static_cast<int>(sets[i].poses.size());
    std::cout << "[volumes] " << c.mesh.name << ": " << sets[i].name << " (" << i + 1 << "/" << sets.size() << "), " << poses
              << " poses" << std::endl;
    results.tightness.push_back({c.mesh.name, sets[i].name, sets[i].kind, poses, measure(c, nodes, sets[i])});
    print_table(results.tightness.back());
  }
  for (const Skinning skinning : measured_skinnings) {
    const auto costs = measure_costs(c, pose, skinning, settings.speed);
    results.costs.insert(results.costs.end(), costs.begin(), costs.end());
  }
}

void write_volumes(const VolumeResults& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "pose_kind", "poses"});
  for (const VolumeResult& r : results.tightness)
    for (const auto& column : r.volumes)
      for (std::size_t l = 0; l < column.second.size(); ++l) {
        const LevelVolumes& level = column.second[l];
        const auto add = [&](const char* quantity, double value, const char* unit) {
          file.add({"volumes", r.model, r.pose, column.first, std::to_string(l + 1), quantity, format_number(value), unit,
                    r.pose_kind, std::to_string(r.poses)});
        };
        // A single point has no ratio.
        if (level.optimal_sum > 0) add("size_ratio_to_optimal", level.ratio_to_optimal(), "1");
        if (level.ball_sum > 0) add("size_ratio_to_ball", level.size_to_ball(), "1");
        if (level.solid_nodes > 0) add("volume_ratio_to_ball", level.volume_to_ball(), "1");
        add("missed_volumes", static_cast<double>(level.misses), "1");
      }
  for (const VolumeCost& cost : results.costs) {
    const auto add = [&](const char* quantity, double value, const char* unit) {
      file.add(
          {"volumes", cost.model, cost.pose, cost.variant, "all", quantity, format_number(value), unit, cost.pose_kind, "1"});
    };
    add("ns_per_node", cost.ns_per_node, "ns");
    add("time_ratio_to_ball", cost.ratio_to_ball, "1");
  }
  file.write(path);
}

}  // namespace refitlab
