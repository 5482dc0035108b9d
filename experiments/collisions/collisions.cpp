// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/collisions/collisions.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "algorithms/results/result_file.hpp"
#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/brute_force.hpp"
#include "experiments/collisions/detectors.hpp"
#include "experiments/collisions/on_demand.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

// Returns the processor time of a call.
double microseconds(const std::function<void()>& call) {
  const auto now = [] {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  call();
  return now() - start;
}

// Returns how many pairs are found and not expected, or expected and not found. A query for one pair finds one or none.
long differing(std::vector<TrianglePair> found, const std::vector<TrianglePair>& expected, Query query) {
  std::sort(found.begin(), found.end());
  std::vector<TrianglePair> difference;
  if (query == Query::full)
    std::set_symmetric_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(difference));
  else if (found.size() != std::min<std::size_t>(expected.size(), 1)) return 1;
  else std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(difference));
  return static_cast<long>(difference.size());
}

// Goes through all frames twice. The least of both passes counts, so that other programs on the machine hardly matter.
StageTimes time_stages(Detector& detector, const Scenario& e, Query query) {
  std::vector<StageTimes> least(e.frames.size());
  for (int pass = 0; pass < 2; ++pass) {
    detector.forget();
    for (std::size_t i = 0; i < e.frames.size(); ++i) {
      const StageTimes now{microseconds([&] { detector.palette(e.frames[i]); }), microseconds([&] { detector.skin(); }),
                           microseconds([&] { detector.refit(); }), microseconds([&] { detector.query(query); })};
      for (std::size_t s = 0; s < now.size(); ++s) least[i][s] = pass == 0 ? now[s] : std::min(least[i][s], now[s]);
    }
  }
  StageTimes means{};
  for (const StageTimes& of_frame : least)
    for (std::size_t s = 0; s < means.size(); ++s) means[s] += of_frame[s] / static_cast<double>(e.frames.size());
  return means;
}

std::string played_by(const AnimatedCharacter& c) { return c.clips.empty() ? "twist" : c.clips[0].name; }

// Goes through all frames once, and counts and checks everything.
CollisionResult count(const AnimatedCharacter& c, const Scenario& e, Query query, const DetectorKind& kind, Detector& detector,
                      const PairLists& expected) {
  CollisionResult out{c.mesh.name, played_by(c), e.name, kind.name, kind.origin, query};
  const double n = static_cast<double>(e.frames.size());
  std::string frames;
  std::size_t of = 0;
  long all_differing = 0;
  for (std::size_t i = 0; i < e.frames.size(); ++i) {
    const auto pairs = detector.pairs(e.frames[i], query);
    const long differ = differing(pairs, expected[i], query);
    if (differ > 0) frames += " " + std::to_string(i);
    all_differing += differ;
    of += query == Query::full ? expected[i].size() : std::min<std::size_t>(expected[i].size(), 1);
    out.pairs += static_cast<double>(pairs.size()) / n;
  }
  if (static_cast<double>(all_differing) > kind.tolerated_share * static_cast<double>(of))
    throw std::logic_error("collisions: " + kind.name + ", " + c.mesh.name + ", " + e.name + ", " + name_of(query) + ": " +
                           std::to_string(all_differing) + " pairs differ from the " + std::to_string(of) +
                           " expected ones, in frames" + frames);
  out.differing_pairs = static_cast<double>(all_differing) / n;
  const DetectorCounts counts = detector.counts();
  out.volume_tests = static_cast<double>(counts.volume_tests) / n;
  out.triangle_tests = static_cast<double>(counts.triangle_tests) / n;
  out.nodes_refitted = static_cast<double>(counts.nodes_refitted) / n;
  out.vertices_skinned = static_cast<double>(counts.vertices_skinned) / n;
  std::vector<long> of_level(counts.refitted_by_level.size());
  if (!of_level.empty())
    for (const TreeNode& node : c.tree.nodes) ++of_level[node.level - 1];
  for (std::size_t l = 0; l < of_level.size(); ++l)
    out.share_refitted.push_back(static_cast<double>(counts.refitted_by_level[l]) / (2 * n * static_cast<double>(of_level[l])));

  out.stages_us = time_stages(detector, e, query);
  return out;
}

// Makes the oracle's own row, with its pairs and its time.
CollisionResult ask_oracle(const AnimatedCharacter& c, const Scenario& e, Skinning skinning, PairLists& pairs) {
  CollisionResult out{c.mesh.name, played_by(c), e.name, "brute_force", Origin::oracle, Query::full};
  const double n = static_cast<double>(e.frames.size()), triangles = static_cast<double>(c.mesh.triangles.size());
  for (const ScenarioFrame& frame : e.frames) {
    out.us_per_frame += microseconds([&] { pairs.push_back(brute_force(c.mesh, c.sets, frame, skinning)); }) / n;
    out.pairs += static_cast<double>(pairs.back().size()) / n;
  }
  out.volume_tests = triangles * triangles;
  out.vertices_skinned = 2 * static_cast<double>(c.mesh.vertices.size());
  return out;
}

// Returns whether the scene is like one in which the paper compares with linear blending.
bool is_in_table_2(const Scenario& e) { return e.name == "light" || e.name == "worst"; }

void print(const std::vector<CollisionResult>& results) {
  std::printf("%s, %s, %s: means of a frame\n", results[0].model.c_str(), results[0].scene.c_str(), name_of(results[0].query));
  for (const CollisionResult& r : results)
    std::printf(
        "  %-32s %7.1f pairs %9.1f us (palette %6.1f skinning %6.1f refit %8.1f query %8.1f) %7.3f of the fastest engine "
        "%7.3f of the fastest baseline skinned in float "
        "%10.1f volume tests %8.1f nodes refitted %8.1f triangle tests\n",
        r.detector.c_str(), r.pairs, r.us_per_frame, r.stages_us[0], r.stages_us[1], r.stages_us[2], r.stages_us[3],
        r.ratio_to_engine, r.ratio_to_skin_all, r.volume_tests, r.nodes_refitted, r.triangle_tests);
}

}  // namespace

const char* name_of(Query query) { return query == Query::full ? "full" : "yes/no"; }

std::vector<CollisionResult> measure(const AnimatedCharacter& c, const Scenario& e, Query query,
                                     const std::vector<const DetectorKind*>& kinds, const PairLists& expected,
                                     const SpeedSettings& speed) {
  std::vector<CollisionResult> results;
  std::vector<Timed> timed;
  for (const DetectorKind* kind : kinds) {
    const std::shared_ptr<Detector> detector = kind->make(c);
    results.push_back(count(c, e, query, *kind, *detector, expected));  // in whose first frame engines build their trees
    timed.push_back({kind->name, static_cast<int>(e.frames.size()), [detector, &e, query] {
                       detector->forget();
                       for (const ScenarioFrame& frame : e.frames) detector->pairs(frame, query);
                     }});
  }
  const auto times = ns_per_item(timed, speed);
  std::string engine, baseline;  // the fastest of those that found all pairs
  const auto keep_faster = [&](const std::string& detector, std::string& fastest) {
    if (fastest.empty() || median(times.at(detector)) < median(times.at(fastest))) fastest = detector;
  };
  for (const CollisionResult& r : results) {
    if (r.origin == Origin::engine && r.differing_pairs == 0) keep_faster(r.detector, engine);
    if (std::find(std::begin(float_baselines), std::end(float_baselines), r.detector) != std::end(float_baselines))
      keep_faster(r.detector, baseline);
  }
  for (CollisionResult& r : results) {
    const auto ratio_to = [&](const std::string& base) {
      return times.count(base) ? median_ratio(times.at(r.detector), times.at(base)) : 0;
    };
    r.us_per_frame = median(times.at(r.detector)) / 1000;
    r.ratio_to_engine = ratio_to(engine);
    r.ratio_to_skin_all = ratio_to(baseline);
    r.ratio_to_repaired = ratio_to("spherical_repaired");
  }
  return results;
}

std::vector<CollisionResult> run_collisions(const AnimatedCharacter& c, const CollisionSettings& settings) {
  std::vector<const DetectorKind*> kinds;
  for (const DetectorKind& kind : detector_kinds())
    if (settings.all_detectors || !kind.is_minor) kinds.push_back(&kind);
  const DetectorKind linear = linear_on_demand();
  std::vector<CollisionResult> results;
  for (const std::string& engine : absent_engines())
    std::cout << "[collisions] absent: " << engine << ", which was not found at configure time\n";
  std::cout << "[collisions] " << c.mesh.name << ": looking for the distances of the scenes" << std::endl;
  for (const Scenario& e : scenarios(c, settings.frames)) {
    std::cout << "[collisions] " << c.mesh.name << ", " << e.name << ": " << e.frames.size() << " frames by brute force"
              << std::endl;
    PairLists expected, expected_of_linear;
    results.push_back(ask_oracle(c, e, Skinning::spherical, expected));
    if (is_in_table_2(e)) ask_oracle(c, e, Skinning::linear, expected_of_linear);
    for (const Query query : {Query::full, Query::yes_no}) {
      std::cout << "[collisions] " << c.mesh.name << ", " << e.name << ", " << name_of(query) << ": " << kinds.size()
                << " detectors" << std::endl;
      const auto some = measure(c, e, query, kinds, expected, settings.speed);
      print(some);
      results.insert(results.end(), some.begin(), some.end());
      if (is_in_table_2(e)) results.push_back(measure(c, e, query, {&linear}, expected_of_linear, settings.speed)[0]);
    }
  }
  return results;
}

void write_collisions(const std::vector<CollisionResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "scene", "query", "origin"});
  for (const CollisionResult& r : results) {
    const auto add = [&](const std::string& level, const char* quantity, double value, const char* unit) {
      file.add({"collisions", r.model, r.pose, r.detector, level, quantity, format_number(value), unit, r.scene, name_of(r.query),
                name_of(r.origin)});
    };
    add("all", "us_per_frame", r.us_per_frame, "us");
    add("all", "pairs", r.pairs, "1");
    add("all", "differing_pairs", r.differing_pairs, "1");
    add("all", "volume_tests", r.volume_tests, "1");
    add("all", "triangle_tests", r.triangle_tests, "1");
    add("all", "nodes_refitted", r.nodes_refitted, "1");
    add("all", "vertices_skinned", r.vertices_skinned, "1");
    if (r.origin == Origin::oracle) continue;
    for (std::size_t s = 0; s < std::size(stage_names); ++s)
      add("all", (stage_names[s] + std::string("_us")).c_str(), r.stages_us[s], "us");
    for (const auto& [quantity, ratio] :
         {std::pair("time_ratio_to_engine", r.ratio_to_engine), std::pair("time_ratio_to_skin_all", r.ratio_to_skin_all),
          std::pair("time_ratio_to_repaired", r.ratio_to_repaired)})
      if (ratio > 0) add("all", quantity, ratio, "1");
    for (std::size_t l = 0; l < r.share_refitted.size(); ++l)
      add(std::to_string(l + 1), "share_of_nodes_refitted", r.share_refitted[l], "1");
  }
  file.write(path);
}

}  // namespace refitlab
