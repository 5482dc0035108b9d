#include "experiments/collisions/collisions.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "algorithms/results/result_file.hpp"
#include "experiments/scenes/contenders.hpp"

namespace refitlab {
namespace {

// Queries go top-down: what takes the children first has nothing to take.
std::vector<const Contender*> columns() {
  std::vector<const Contender*> out;
  for (const Contender& c : contenders())
    if (c.variant->sound && c.variant->skinning == Skinning::spherical && !c.options.children_first) out.push_back(&c);
  return out;
}

// Two bodies that go through an encounter.
class Walkers {
 public:
  Walkers(const Character& c, const Contender& column, const Encounter& encounter, Query query)
      : encounter_(encounter), query_(query), first_(c, *column.variant, column.options),
        second_(c, *column.variant, column.options), refitted_(c.tree.level_count()) {}

  std::vector<TrianglePair> frame(std::size_t i) {
    const EncounterFrame& f = encounter_.frames[i];
    first_.begin(f.first);
    second_.begin(f.second);
    return collide({first_, f.first_at}, {second_, f.second_at}, query_, counts_);
  }

  void all_frames() {
    for (std::size_t i = 0; i < encounter_.frames.size(); ++i) frame(i);
  }

  // Once through, with everything counted; the pairs of each frame are appended, sorted.
  void count(CollisionResult& out, std::vector<std::vector<TrianglePair>>& pairs) {
    const double n = static_cast<double>(encounter_.frames.size());
    for (std::size_t i = 0; i < encounter_.frames.size(); ++i) {
      pairs.push_back(frame(i));
      std::sort(pairs.back().begin(), pairs.back().end());
      out.pairs += static_cast<double>(pairs.back().size()) / n;
      for (const Body* b : {&first_, &second_}) {
        out.vertices_skinned += static_cast<double>(b->vertices_skinned()) / n;
        for (std::size_t l = 0; l < refitted_.size(); ++l) refitted_[l] += b->refits().refitted_by_level()[l];
      }
    }
    out.ball_tests = static_cast<double>(counts_.ball_tests) / n;
    out.triangle_tests = static_cast<double>(counts_.triangle_tests) / n;
    std::vector<long> of_level(refitted_.size());
    for (const TreeNode& node : first_.character().tree.nodes) ++of_level[node.level - 1];
    for (std::size_t l = 0; l < refitted_.size(); ++l) {
      out.balls_refitted += static_cast<double>(refitted_[l]) / n;
      out.share_refitted.push_back(static_cast<double>(refitted_[l]) / (2 * n * static_cast<double>(of_level[l])));
    }
  }

 private:
  const Encounter& encounter_;
  const Query query_;
  Body first_, second_;
  QueryCounts counts_;
  std::vector<long> refitted_;
};

std::vector<CollisionResult> run_encounter(const Character& c, const Encounter& e, Query query, const SpeedSettings& speed) {
  const auto all = columns();
  std::vector<CollisionResult> results;
  std::vector<Timed> timed;
  std::vector<std::vector<TrianglePair>> expected;
  for (const Contender* column : all) {
    CollisionResult r{c.model.name, e.name, column->name, query};
    std::vector<std::vector<TrianglePair>> pairs;
    Walkers(c, *column, e, query).count(r, pairs);
    if (expected.empty()) expected = pairs;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (query == Query::full ? pairs[i] != expected[i] : pairs[i].empty() != expected[i].empty())
        throw std::logic_error("collisions: " + column->name + " finds other pairs than " + all[0]->name + " in " +
                               c.model.name + ", " + e.name + ", frame " + std::to_string(i));
    const auto walkers = std::make_shared<Walkers>(c, *column, e, query);
    timed.push_back({column->name, static_cast<int>(e.frames.size()), [walkers] { walkers->all_frames(); }});
    results.push_back(std::move(r));
  }
  const auto times = ns_per_item(timed, speed);
  for (CollisionResult& r : results) {
    r.us_per_frame = median(times.at(r.variant)) / 1000;
    r.ratio_to_repaired = median_ratio(times.at(r.variant), times.at("spherical_repaired"));
  }
  return results;
}

const char* name_of(Query query) { return query == Query::full ? "full" : "yes/no"; }

void print(const std::vector<CollisionResult>& results) {
  std::printf("%s, %s, %s: means of a frame\n", results[0].model.c_str(), results[0].scene.c_str(), name_of(results[0].query));
  for (const CollisionResult& r : results)
    std::printf("  %-32s %7.1f pairs %9.1f ball tests %8.1f balls refitted %8.1f triangle tests %7.1f vertices skinned %9.1f us %6.2f times repaired\n",
                r.variant.c_str(), r.pairs, r.ball_tests, r.balls_refitted, r.triangle_tests, r.vertices_skinned, r.us_per_frame,
                r.ratio_to_repaired);
}

}  // namespace

std::vector<CollisionResult> run_collisions(const Character& c, const CollisionSettings& settings) {
  std::vector<CollisionResult> results;
  std::cout << "[collisions] " << c.model.name << ": looking for the distances of the scenes" << std::endl;
  for (const Encounter& e : encounters(c, refit_variant("spherical_repaired"), settings.frames))
    for (const Query query : {Query::full, Query::yes_no}) {
      std::cout << "[collisions] " << c.model.name << ", " << e.name << ", " << name_of(query) << ": " << e.frames.size()
                << " frames" << std::endl;
      const auto some = run_encounter(c, e, query, settings.speed);
      print(some);
      results.insert(results.end(), some.begin(), some.end());
    }
  return results;
}

void write_collisions(const std::vector<CollisionResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "posture", "variant", "level", "quantity", "value", "unit"});
  for (const CollisionResult& r : results) {
    const std::string scene = r.scene + ", " + name_of(r.query);
    const auto add = [&](const std::string& level, const char* quantity, double value, const char* unit) {
      file.add({"collisions", r.model, scene, r.variant, level, quantity, format_number(value), unit});
    };
    add("all", "pairs", r.pairs, "1");
    add("all", "ball_tests", r.ball_tests, "1");
    add("all", "triangle_tests", r.triangle_tests, "1");
    add("all", "balls_refitted", r.balls_refitted, "1");
    add("all", "vertices_skinned", r.vertices_skinned, "1");
    add("all", "us_per_frame", r.us_per_frame, "us");
    add("all", "ratio_to_repaired", r.ratio_to_repaired, "1");
    for (std::size_t l = 0; l < r.share_refitted.size(); ++l)
      add(std::to_string(l + 1), "share_refitted", r.share_refitted[l], "1");
  }
  file.write(path);
}

}  // namespace refitlab
