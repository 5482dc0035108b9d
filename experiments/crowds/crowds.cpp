// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/crowds.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>
#ifdef REFITLAB_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/collide/meeting_boxes.hpp"
#include "experiments/crowds/skinned_crowd.hpp"
#include "experiments/crowds/walkers.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr Spacing dense{"dense", 1.41421356, false}, apart{"apart", 4, true};
constexpr int numbers[] = {10, 30, 100, 300, 1000, 3000, 10000};

#ifdef REFITLAB_TBB
Workers workers_of(tbb::task_arena& arena) {
  return {[](void* self, std::size_t count, void (*task)(void*, std::size_t), void* data) {
            static_cast<tbb::task_arena*>(self)->execute(
                [&] { tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) { task(data, i); }); });
          },
          &arena};
}
#endif

// A Crowd is our own way.
class Crowd {
 public:
  Crowd(const ClusterTree& tree, const Walkers& walkers) : walkers_(walkers) {
    for (int i = 0; i < walkers.count(); ++i) {
      bodies_.push_back(std::make_unique<ClusterBody>(tree, Skinning::spherical));
      list_.push_back(bodies_.back().get());
    }
  }
  std::vector<Contact> frame(int f, Query query, CrowdCounts& counts, const Workers& workers) {
    begin(f, workers);
    return collide_all(list_, query, counts, workers);
  }
  double share_of_clusters_skinned() const {
    double skinned = 0, all = 0;
    for (const ClusterBody* b : list_)
      skinned += static_cast<double>(b->clusters_skinned()), all += static_cast<double>(b->tree().clusters().size());
    return skinned / all;
  }
  std::vector<Box<double>> motion_bounds(int f) {
    begin(f, one_worker());
    std::vector<Box<double>> boxes;
    for (ClusterBody* b : list_) boxes.push_back(b->motion_bound());
    return boxes;
  }

 private:
  void begin(int f, const Workers& workers) {
    frame_ = f;
    workers.for_each(
        workers.self, list_.size(),
        [](void* self, std::size_t i) {
          Crowd& crowd = *static_cast<Crowd*>(self);
          crowd.list_[i]->begin(crowd.walkers_.poses(crowd.frame_)[i], crowd.walkers_.placements(crowd.frame_)[i]);
        },
        this);
  }

  const Walkers& walkers_;
  std::vector<std::unique_ptr<ClusterBody>> bodies_;
  std::vector<ClusterBody*> list_;
  int frame_ = 0;
};

// Throws unless all contacts are the same.
void require_same(std::vector<Contact> expected, std::vector<Contact> found, const std::string& detector) {
  for (auto* list : {&expected, &found})
    for (Contact& contact : *list) std::sort(contact.pairs.begin(), contact.pairs.end());
  const auto is_same = [](const Contact& a, const Contact& b) {
    return a.first == b.first && a.second == b.second && a.pairs == b.pairs;
  };
  if (!std::equal(expected.begin(), expected.end(), found.begin(), found.end(), is_same))
    throw std::logic_error("crowds: " + detector + " finds other contacts than clusters");
}

// A Rival skins whole bodies.
struct Rival {
  std::string name;
  SkinnedCrowd* crowd;
  SkinnedCrowd::Skinned skinned;

  std::vector<Contact> frame(const Walkers& walkers, int f) const {
    return crowd->frame(walkers.poses(f), walkers.placements(f), skinned);
  }
};

// Goes through all frames once, and counts and checks everything.
CrowdResult count(Crowd& crowd, const Walkers& walkers, const Spacing& spacing, const std::vector<Rival>& rivals) {
  CrowdResult out{.scene = spacing.scene, .characters = walkers.count()};
  CrowdCounts counts;
  constexpr double share = 1. / Walkers::frames;
  for (int f = 0; f < Walkers::frames; ++f) {
    const auto contacts = crowd.frame(f, Query::full, counts, one_worker());
    out.contacts += share * static_cast<double>(contacts.size());
    for (const Contact& c : contacts) out.triangle_pairs += share * static_cast<double>(c.pairs.size());
    out.clusters_skinned += share * crowd.share_of_clusters_skinned();
    for (const Rival& rival : rivals) require_same(contacts, rival.frame(walkers, f), rival.name);
  }
  out.pairs_of_boxes = share * static_cast<double>(counts.pairs_of_boxes);
  if (spacing.is_even && counts.pairs_of_boxes > 0) throw std::logic_error("crowds: boxes meet among characters that are apart");
  return out;
}

CrowdResult measure(const ClusterTree& tree, const ClusterTree& coarse, const Walkers& walkers, const Spacing& spacing,
                    const SpeedSettings& speed) {
  using Skinned = SkinnedCrowd::Skinned;
  Crowd crowd(tree, walkers);
  SkinnedCrowd skinned(tree, walkers.count()), coarsely_skinned(coarse, walkers.count());
  const std::vector<Rival> rivals{{"skin_all_float", &skinned, Skinned::all},
                                  {"skin_all_float_512", &coarsely_skinned, Skinned::all},
                                  {"skin_all_float_bounded", &skinned, Skinned::where_motion_bounds_meet},
                                  {"skin_all_float_512_bounded", &coarsely_skinned, Skinned::where_motion_bounds_meet}};
  CrowdResult out = count(crowd, walkers, spacing, rivals);

  std::vector<Timed> timed;
  const auto add = [&](const std::string& name, const auto& frame) {
    timed.push_back({name, Walkers::frames, [frame] {
                       for (int f = 0; f < Walkers::frames; ++f) benchmark::DoNotOptimize(frame(f));
                     }});
  };
  CrowdCounts unused;
  add("clusters", [&](int f) { return crowd.frame(f, Query::full, unused, one_worker()); });
  add("clusters_yes_no", [&](int f) { return crowd.frame(f, Query::yes_no, unused, one_worker()); });
#ifdef REFITLAB_TBB
  tbb::task_arena two(2);
  add("clusters_on_two_threads", [&](int f) { return crowd.frame(f, Query::full, unused, workers_of(two)); });
#endif
  for (const Rival& rival : rivals) add(rival.name, [&](int f) { return rival.frame(walkers, f); });
  std::vector<std::vector<Box<double>>> boxes;
  for (int f = 0; f < Walkers::frames; ++f) boxes.push_back(crowd.motion_bounds(f));
  add("broad_phase", [&](int f) { return meeting_boxes(boxes[static_cast<std::size_t>(f)]); });
  const auto times = ns_per_item(timed, speed, Clock::wall);
  for (const Timed& t : timed) out.times.push_back({t.name, median(times.at(t.name)) / 1000});
  return out;
}

void print(const CrowdResult& r) {
  std::printf("  %6.0f pairs of boxes, %5.0f contacts, %6.0f pairs of triangles, %4.1f %% of the clusters skinned; us a frame:\n",
              r.pairs_of_boxes, r.contacts, r.triangle_pairs, 100 * r.clusters_skinned);
  for (const auto& [detector, us] : r.times)
    std::printf("    %-28s %11.1f, %8.3f a man\n", detector.c_str(), us, us / r.characters);
}

}  // namespace

std::vector<CrowdResult> run_crowds(const CrowdSettings& settings) {
  const auto man = bake_animated(make_man());
  const ClusterTree tree(man), coarse(man, {.most_triangles = 512});
  std::vector<CrowdResult> rows;
  for (const int count : numbers) {
    if (count > settings.most_characters) break;
    for (const Spacing& spacing : {dense, apart}) {
      std::cout << "[crowds] " << count << " walking men, " << spacing.scene << "; the last will be " << settings.most_characters
                << std::endl;
      rows.push_back(measure(tree, coarse, Walkers(man.clips[0], count, spacing), spacing, settings.speed));
      print(rows.back());
    }
  }
  return rows;
}

void write_crowds(const std::vector<CrowdResult>& rows, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "scene", "characters"});
  for (const CrowdResult& r : rows) {
    const auto add = [&](const std::string& variant, const char* quantity, double value, const char* unit) {
      file.add({"crowds", std::to_string(r.characters) + " men", "walk", variant, "all", quantity, format_number(value), unit,
                r.scene, std::to_string(r.characters)},
               Walkers::seed);
    };
    add("clusters", "pairs_of_boxes", r.pairs_of_boxes, "1");
    add("clusters", "contacts", r.contacts, "1");
    add("clusters", "triangle_pairs", r.triangle_pairs, "1");
    add("clusters", "share_of_clusters_skinned", r.clusters_skinned, "1");
    for (const auto& [detector, us] : r.times) add(detector, "us_per_frame", us, "us");
  }
  file.write(path);
}

}  // namespace refitlab
