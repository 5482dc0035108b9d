// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/growth/characters.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numbers>
#include <random>
#ifdef REFITLAB_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/collide/skinned_clusters.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {
namespace {

constexpr int frames = 4;
constexpr unsigned seed = 7;

// In the Square men walk straight ahead, each in a direction and from a time of the clip of his own.
class Square {
 public:
  Square(const Clip& walk, int count) {
    std::mt19937 random(seed);
    const double side = std::sqrt(2.0 * count);
    std::uniform_real_distribution<double> place(0, side), angle(0, 2 * std::numbers::pi), share(0, 1);
    for (int i = 0; i < count; ++i) {
      const double turn = angle(random), start = share(random), x = place(random), z = place(random);
      for (int f = 0; f < frames; ++f) {
        poses_[f].push_back(walk.sample(std::fmod(start + f / 30.0 / walk.duration, 1.0) * walk.duration));
        const double ahead = 1.2 * f / 30;  // metres, at walking speed
        placements_[f].push_back(
            {{std::cos(turn / 2), 0, std::sin(turn / 2), 0}, {x + ahead * std::sin(turn), 0, z + ahead * std::cos(turn)}});
      }
    }
  }
  const std::vector<Pose>& poses(int frame) const { return poses_[frame]; }
  const std::vector<RigidTransform<double>>& placements(int frame) const { return placements_[frame]; }

 private:
  std::vector<Pose> poses_[frames];
  std::vector<RigidTransform<double>> placements_[frames];
};

#ifdef REFITLAB_TBB
Workers workers_of(tbb::task_arena& arena) {
  return {[](void* self, std::size_t count, void (*task)(void*, std::size_t), void* data) {
            static_cast<tbb::task_arena*>(self)->execute(
                [&] { tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) { task(data, i); }); });
          },
          &arena};
}
#endif

class Crowd {
 public:
  Crowd(const ClusterTree& tree, const Square& square, int count) : square_(square) {
    for (int i = 0; i < count; ++i) {
      bodies_.push_back(std::make_unique<ClusterBody>(tree, Skinning::spherical));
      list_.push_back(bodies_.back().get());
    }
  }
  std::vector<Contact> frame(int f, Query query, CrowdCounts& counts, const Workers& workers) {
    for (std::size_t i = 0; i < list_.size(); ++i) list_[i]->begin(square_.poses(f)[i], square_.placements(f)[i]);
    return collide_all(list_, query, counts, workers);
  }
  void all_frames(Query query, const Workers& workers) {
    CrowdCounts unused;
    for (int f = 0; f < frames; ++f) benchmark::DoNotOptimize(frame(f, query, unused, workers));
  }
  void count(CharacterGrowth& out) {
    CrowdCounts counts;
    for (int f = 0; f < frames; ++f) {
      for (const Contact& c : frame(f, Query::full, counts, one_worker())) {
        out.contacts += 1. / frames;
        out.triangle_pairs += static_cast<double>(c.pairs.size()) / frames;
      }
      for (const ClusterBody* b : list_)
        out.clusters_skinned +=
            static_cast<double>(b->clusters_skinned()) / static_cast<double>(b->tree().clusters().size() * list_.size() * frames);
    }
    out.pairs_of_boxes = static_cast<double>(counts.pairs_of_boxes) / frames;
  }

 private:
  const Square& square_;
  std::vector<std::unique_ptr<ClusterBody>> bodies_;
  std::vector<ClusterBody*> list_;
};

CharacterGrowth measure(const ClusterTree& tree, const Clip& walk, int count, const SpeedSettings& speed) {
  const Square square(walk, count);
  Crowd crowd(tree, square, count);
  CharacterGrowth out{.characters = count};
  crowd.count(out);

  SkinnedClusters clusters(tree, Skinning::spherical);  // as the fastest detector that skins everything has them
  std::vector<Timed> timed{{"full", frames, [&] { crowd.all_frames(Query::full, one_worker()); }},
                           {"yes_no", frames, [&] { crowd.all_frames(Query::yes_no, one_worker()); }},
                           {"skin_all", frames, [&] {
                              for (int f = 0; f < frames; ++f)
                                for (std::size_t i = 0; i < square.poses(f).size(); ++i) {
                                  const RigidTransform<double>& placement = square.placements(f)[i];
                                  clusters.begin(square.poses(f)[i], placement, placement.translation);
                                  clusters.make_all_palettes(), clusters.skin_all();
                                  float slack = clusters.cluster(0).slack;
                                  benchmark::DoNotOptimize(slack);
                                }
                            }}};
#ifdef REFITLAB_TBB
  tbb::task_arena two(2);
  timed.push_back({"full_on_two_threads", frames, [&] { crowd.all_frames(Query::full, workers_of(two)); }});
#endif
  const auto times = ns_per_item(timed, speed, Clock::wall);
  const auto us = [&](const char* name) { return times.count(name) ? median(times.at(name)) / 1000 : 0.0; };
  out.full = us("full"), out.yes_no = us("yes_no"), out.full_on_two_threads = us("full_on_two_threads"),
  out.skin_all = us("skin_all");
  return out;
}

}  // namespace

std::vector<CharacterGrowth> run_character_growth(const SpeedSettings& settings) {
  const auto man = bake_animated(make_man());
  const ClusterTree tree(man);
  std::vector<CharacterGrowth> rows;
  for (const int count : {10, 30, 100, 300, 1000}) {
    std::cout << "[growth] " << count << " walking men in a square; the last will be 1000" << std::endl;
    rows.push_back(measure(tree, man.clips[0], count, settings));
    const CharacterGrowth& r = rows.back();
    std::printf(
        "  %6.0f pairs of boxes, %5.0f contacts, %6.0f pairs of triangles, %4.1f %% of the clusters skinned: %8.0f us "
        "full, %8.0f on two "
        "threads, %8.0f yes/no; skinning all of them alone %8.0f us\n",
        r.pairs_of_boxes, r.contacts, r.triangle_pairs, 100 * r.clusters_skinned, r.full, r.full_on_two_threads, r.yes_no,
        r.skin_all);
  }
  return rows;
}

void write_character_growth(const std::vector<CharacterGrowth>& rows, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "characters"});
  for (const CharacterGrowth& r : rows) {
    const auto add = [&](const char* variant, const char* quantity, double value, const char* unit) {
      file.add({"character_growth", std::to_string(r.characters) + " men", "walk", variant, "all", quantity, format_number(value),
                unit, std::to_string(r.characters)},
               seed);
    };
    add("clusters", "pairs_of_boxes", r.pairs_of_boxes, "1");
    add("clusters", "contacts", r.contacts, "1");
    add("clusters", "triangle_pairs", r.triangle_pairs, "1");
    add("clusters", "share_of_clusters_skinned", r.clusters_skinned, "1");
    add("clusters", "us_per_frame", r.full, "us");
    add("clusters_yes_no", "us_per_frame", r.yes_no, "us");
    if (r.full_on_two_threads > 0) add("clusters_on_two_threads", "us_per_frame", r.full_on_two_threads, "us");
    add("skinning_alone", "us_per_frame", r.skin_all, "us");
  }
  file.write(path);
}

}  // namespace refitlab
