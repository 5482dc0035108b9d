// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/crowds/crowds.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
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
constexpr int men_in_contact = 100;  // at least, over all starts

// Returns the way of collide_all that a detector is compared with: on as many threads, by the same query.
std::string of_same_kind(const std::string& detector) {
  for (const char* kind : {"_yes_no", "_on_two_threads"})
    if (detector.ends_with(kind)) return std::string("clusters") + kind;
  return "clusters";
}

#ifdef REFITLAB_TBB
Workers workers_of(tbb::task_arena& arena) {
  return {[](void* self, std::size_t count, void (*task)(void*, std::size_t), void* data) {
            static_cast<tbb::task_arena*>(self)->execute(
                [&] { tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) { task(data, i); }); });
          },
          &arena};
}
#endif

// A BoundedCrowd has the bodies that collide_all compares.
class BoundedCrowd {
 public:
  BoundedCrowd(const ClusterTree& tree, const Walkers& walkers) : walkers_(walkers) {
    for (int i = 0; i < walkers.count(); ++i) {
      bodies_.push_back(std::make_unique<ClusterBody>(tree, Skinning::spherical));
      list_.push_back(bodies_.back().get());
    }
  }
  std::vector<Contact> frame(int f, Query query, CrowdCounts& counts, const Workers& workers) {
    return collide_all(list_, walkers_.poses(f), walkers_.placements(f), query, counts, workers);
  }
  double share_of_clusters_skinned() const {
    double skinned = 0, all = 0;
    for (const ClusterBody* b : list_)
      skinned += static_cast<double>(b->clusters_skinned()), all += static_cast<double>(b->tree().clusters().size());
    return skinned / all;
  }
  std::vector<Box<double>> motion_bounds(int f) {
    std::vector<Box<double>> boxes;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      list_[i]->begin(walkers_.poses(f)[i], walkers_.placements(f)[i]);
      boxes.push_back(list_[i]->motion_bound());
    }
    return boxes;
  }

 private:
  const Walkers& walkers_;
  std::vector<std::unique_ptr<ClusterBody>> bodies_;
  std::vector<ClusterBody*> list_;
};

// A CrowdDetector finds the contacts of a frame in one way.
struct CrowdDetector {
  std::string name;
  Query query;
  std::function<std::vector<Contact>(int frame)> frame;
};

// Returns the ways to be measured: collide_all, and the baselines, which skin whole bodies. All of these must outlive them.
std::vector<CrowdDetector> detectors_of(const Walkers& walkers, BoundedCrowd& crowd, SkinnedCrowd& skinned,
                                        SkinnedCrowd& coarsely_skinned, CrowdCounts& counts,
                                        const std::optional<Workers>& two_threads) {
  std::vector<CrowdDetector> out;
  const auto add = [&](const std::string& name, const auto& frame) {
    out.push_back({name, Query::full, [=](int f) { return frame(f, Query::full, one_worker()); }});
  };
  const auto add_all_ways = [&](const std::string& name, const auto& frame) {
    add(name, frame);
    out.push_back({name + "_yes_no", Query::yes_no, [=](int f) { return frame(f, Query::yes_no, one_worker()); }});
    if (two_threads)
      out.push_back({name + "_on_two_threads", Query::full, [=](int f) { return frame(f, Query::full, *two_threads); }});
  };
  add_all_ways("clusters", [&](int f, Query query, const Workers& workers) { return crowd.frame(f, query, counts, workers); });
  for (const auto& [name, baseline] :
       {std::pair<std::string, SkinnedCrowd*>("skin_all_float", &skinned), {"skin_all_float_512", &coarsely_skinned}}) {
    const auto frame_of = [&walkers, baseline = baseline](SkinnedCrowd::Skinned which) {
      return [=, &walkers](int f, Query query, const Workers& workers) {
        return baseline->frame(walkers.poses(f), walkers.placements(f), which, query, workers);
      };
    };
    add(name, frame_of(SkinnedCrowd::Skinned::all));
    add_all_ways(name + "_bounded", frame_of(SkinnedCrowd::Skinned::where_motion_bounds_meet));
  }
  return out;
}

// Throws unless the contacts are those that a full query found: the same bodies, and all of the same pairs of triangles, or one
// of them.
void require_same(const std::vector<Contact>& expected, std::vector<Contact> found, const CrowdDetector& detector) {
  for (Contact& contact : found) std::sort(contact.pairs.begin(), contact.pairs.end());
  const auto is_same = [&](const Contact& a, const Contact& b) {
    if (a.first != b.first || a.second != b.second) return false;
    if (detector.query == Query::full) return a.pairs == b.pairs;
    return b.pairs.size() == 1 && std::binary_search(a.pairs.begin(), a.pairs.end(), b.pairs[0]);
  };
  if (!std::equal(expected.begin(), expected.end(), found.begin(), found.end(), is_same))
    throw std::logic_error("crowds: " + detector.name + " finds other contacts than clusters");
}

// Goes through all frames once, and counts and checks everything.
CrowdResult count(BoundedCrowd& crowd, const Walkers& walkers, const Spacing& spacing,
                  const std::vector<CrowdDetector>& detectors) {
  CrowdResult out{.scene = spacing.scene, .characters = walkers.count()};
  CrowdCounts counts;
  const double share = 1. / walkers.frames();
  for (int f = 0; f < walkers.frames(); ++f) {
    auto contacts = crowd.frame(f, Query::full, counts, one_worker());
    out.contacts += share * static_cast<double>(contacts.size());
    for (Contact& c : contacts) {
      out.triangle_pairs += share * static_cast<double>(c.pairs.size());
      std::sort(c.pairs.begin(), c.pairs.end());
    }
    out.clusters_skinned += share * crowd.share_of_clusters_skinned();
    for (const CrowdDetector& detector : detectors) require_same(contacts, detector.frame(f), detector);
  }
  out.pairs_of_boxes = share * static_cast<double>(counts.pairs_of_boxes);
  if (spacing.is_even && counts.pairs_of_boxes > 0) throw std::logic_error("crowds: boxes meet among characters that are apart");
  return out;
}

CrowdResult measure(const ClusterTree& tree, const ClusterTree& coarse, const Walkers& walkers, const Spacing& spacing,
                    const SpeedSettings& speed) {
  std::optional<Workers> two_threads;
#ifdef REFITLAB_TBB
  tbb::task_arena arena(2);
  two_threads = workers_of(arena);
#endif
  BoundedCrowd crowd(tree, walkers);
  SkinnedCrowd skinned(tree, walkers.count()), coarsely_skinned(coarse, walkers.count());
  CrowdCounts unused;
  const auto detectors = detectors_of(walkers, crowd, skinned, coarsely_skinned, unused, two_threads);
  CrowdResult out = count(crowd, walkers, spacing, detectors);

  std::vector<Timed> timed;
  const auto add = [&](const std::string& name, const auto& frame) {
    timed.push_back({name, walkers.frames(), [&walkers, frame] {
                       for (int f = 0; f < walkers.frames(); ++f) benchmark::DoNotOptimize(frame(f));
                     }});
  };
  for (const CrowdDetector& detector : detectors) add(detector.name, detector.frame);
  std::vector<std::vector<Box<double>>> boxes;
  for (int f = 0; f < walkers.frames(); ++f) boxes.push_back(crowd.motion_bounds(f));
  add("broad_phase", [&](int f) { return meeting_boxes(boxes[static_cast<std::size_t>(f)]); });
  const auto times = ns_per_item(timed, speed, Clock::wall);
  for (const Timed& t : timed)
    out.times.push_back(
        {t.name, median(times.at(t.name)) / 1000, median_ratio(times.at(t.name), times.at(of_same_kind(t.name)))});
  return out;
}

void print(const CrowdResult& r) {
  std::printf("  %6.0f pairs of boxes, %5.0f contacts, %6.0f pairs of triangles, %4.1f %% of the clusters skinned; us a frame:\n",
              r.pairs_of_boxes, r.contacts, r.triangle_pairs, 100 * r.clusters_skinned);
  for (const auto& [detector, us, ratio] : r.times)
    std::printf("    %-42s %11.1f, %8.3f a man, %5.2f of ours\n", detector.c_str(), us, us / r.characters, ratio);
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
      // Few men start several times, so that more than a few contacts count.
      const int starts = std::max(1, men_in_contact / count);
      rows.push_back(measure(tree, coarse, Walkers(man.clips[0], count, spacing, starts), spacing, settings.speed));
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
    for (const CrowdResult::Time& time : r.times) {
      add(time.detector, "us_per_frame", time.us, "us");
      add(time.detector, "ratio_to_clusters", time.ratio_to_clusters, "1");
    }
  }
  file.write(path);
}

}  // namespace refitlab
