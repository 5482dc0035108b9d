// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/over_time.hpp"

#include <chrono>
#include <cstdio>
#include <iostream>

#include "algorithms/bake/parallel.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/results/result_file.hpp"
#include "experiments/scenes/skinning_name.hpp"

namespace refitlab {
namespace {

constexpr double keys_a_second = 10;

// Bounded is the model with those of its clips that have bounds.
struct Bounded {
  Model model;
  ModelBounds bounds;
  double seconds = 0;
  std::vector<std::string> refused;
};

Bounded bounded(const Model& model, Skinning skinning) {
  Bounded out{model, {}, 0, {}};
  const auto bound = [&](const Model& some) {
    const auto start = std::chrono::steady_clock::now();
    ModelBounds bounds = bound_model(some, {.skinning = skinning});
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return bounds;
  };
  try {
    out.bounds = bound(model);
    return out;
  } catch (const ModelError&) {
    out.model.clips.clear();
  }
  Model one = model;
  for (const Clip& clip : model.clips) try {
      one.clips = {clip};
      bound(one);
      out.model.clips.push_back(clip);
    } catch (const ModelError& e) {
      out.refused.push_back("clip '" + clip.name + "': " + e.what());
    }
  out.bounds = bound(out.model);
  return out;
}

void print(const OverTimeResult& r) {
  std::printf("  %s: %ld clusters, bounded in %.2f s\n", table_name_of(r.skinning), r.clusters, r.seconds);
  for (const std::string& why : r.refused) std::printf("    no bound of %s\n", why.c_str());
  for (const ClipResult& clip : r.clips) {
    std::printf("    %-16s volumes %.4f, %.4f of clusters; clusters missed:", clip.clip.c_str(), clip.whole_ratio,
                clip.cluster_ratio);
    for (const ClipMisses& m : clip.misses) std::printf(" %s %ld", m.way.c_str(), m.clusters);
    std::cout << std::endl;
  }
}

}  // namespace

Model with_keys(const Model& made, int most_clips) {
  Model model = made.skeleton.joints.size() == made.joints.size() ? made : keyed(made, keys_a_second);
  if (most_clips > 0 && model.clips.size() > static_cast<std::size_t>(most_clips)) model.clips.resize(most_clips);
  return model;
}

std::vector<OverTimeResult> run_over_time(const Model& made, const OverTimeSettings& settings) {
  const Model model = with_keys(made, settings.clips);
  const JointSets sets(model);
  std::vector<OverTimeResult> results;
  std::vector<Bounded> found;
  struct Task {
    std::size_t skinning, clip;
  };
  std::vector<Task> tasks;
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}) {
    const Bounded& b = found.emplace_back(bounded(model, skinning));
    OverTimeResult r{model.name, skinning, static_cast<long>(model.triangles.size())};
    r.clusters = static_cast<long>(compared_parts(b.bounds).size()) - 1;
    r.seconds = b.seconds, r.refused = b.refused;
    r.clips.resize(b.model.clips.size());
    for (std::size_t c = 0; c < r.clips.size(); ++c) tasks.push_back({results.size(), c});
    results.push_back(std::move(r));
  }
  parallel_for(tasks.size(), [&](std::size_t t) {
    const auto& [s, clip] = tasks[t];
    results[s].clips[clip] = check_clip(found[s].model, sets, found[s].bounds, clip, settings);
  });
  for (const OverTimeResult& r : results) print(r);
  return results;
}

void write_over_time(const std::vector<OverTimeResult>& results, const OverTimeSettings& settings, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "skinning"});
  for (const OverTimeResult& r : results) {
    const auto add = [&](const std::string& clip, const std::string& way, const char* quantity, double value,
                         const char* unit = "1") {
      file.add({"over_time", r.model, clip, way, "all", quantity, format_number(value), unit, table_name_of(r.skinning)},
               settings.seed);
    };
    add("all", "bounds", "triangles", static_cast<double>(r.triangles));
    add("all", "bounds", "clusters", static_cast<double>(r.clusters));
    add("all", "bounds", "bounding_seconds", r.seconds, "s");
    add("all", "bounds", "refused_clips", static_cast<double>(r.refused.size()));
    for (const ClipResult& c : r.clips) {
      const auto add_count = [&](const char* quantity, long value) {
        add(c.clip, "bounds", quantity, static_cast<double>(value));
      };
      add(c.clip, "bounds", "duration", c.duration, "s");
      add_count("random_times", c.random_times);
      add_count("close_times", c.close_times);
      add_count("checks", c.places);
      add_count("exact_checks", c.exact_checks);
      add_count("exact_missed_places", c.exact_misses);
      add_count("exact_undecided", c.exact_undecided);
      add(c.clip, "bounds", "character_volume_ratio", c.whole_ratio);
      add(c.clip, "bounds", "mean_cluster_volume_ratio", c.cluster_ratio);
      add_count("flat_clusters", c.flat_clusters);
      for (const ClipMisses& m : c.misses) {
        add(c.clip, m.way, "character_misses", m.of_whole.vertex >= 0);
        add(c.clip, m.way, "character_miss_distance_over_box_side", m.of_whole.by);
        add(c.clip, m.way, "cluster_misses", static_cast<double>(m.clusters));
        add(c.clip, m.way, "cluster_miss_distance_over_box_side", m.of_cluster.by);
        add(c.clip, m.way, "worst_miss_cluster", m.worst_cluster);
        add(c.clip, m.way, "worst_miss_vertex", m.of_cluster.vertex);
        add(c.clip, m.way, "worst_miss_time", m.of_cluster.time, "s");
        add(c.clip, m.way, "undecided", static_cast<double>(m.undecided));
      }
    }
  }
  file.write(path);
}

}  // namespace refitlab
