// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/over_time.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <numeric>
#include <optional>
#include <random>

#include "algorithms/model/keyed.hpp"
#include "algorithms/results/result_file.hpp"
#include "experiments/over_time/exact_places.hpp"
#include "experiments/over_time/sampled_boxes.hpp"
#include "experiments/scenes/skinning_name.hpp"

namespace refitlab {
namespace {

constexpr double keys_a_second = 10;

// A cluster whose shortest side is a smaller share of its longest one has hardly a volume to compare.
constexpr double flattest_side = 0.02;

// The parts that are compared: the whole character first, then its clusters. Positions in ModelBounds::parts.
std::vector<std::size_t> compared_parts(const ModelBounds& bounds) {
  std::vector<std::size_t> out = {0};
  for (std::size_t p = 0; p < bounds.parts.size(); ++p)
    if (bounds.parts[p].kind == PartKind::cluster) out.push_back(p);
  return out;
}

std::vector<double> random_times(double duration, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(duration * share(random));
  return times;
}

// Compares one clip's bounds, and boxes around sampled times, with where the vertices get to.
class ClipChecks {
 public:
  ClipChecks(const Model& model, const JointSets& sets, const Clip& clip, const ModelBounds& bounds, std::size_t index,
             const OverTimeSettings& settings)
      : settings_(settings),
        exact_(model, clip.animation, bounds.skinning),
        parts_(watched(bounds, index, bounds_)),
        watched_(model, sets, clip.animation, bounds.skinning, parts_) {
    result_.clip = clip.name, result_.duration = watched_.key_times().back();
    look();
    measure_volumes();
    check_closest();
    add_misses("bounds", bounds_.boxes, true);
    for (const SamplingWay& way : sampling_ways()) add_misses(way.name, sampled_boxes(watched_, way), false);
  }

  const ClipResult& result() const { return result_; }

 private:
  struct Bounds {
    std::vector<Box<float>> boxes;
    std::vector<Ball3<float>> balls;
  };

  static std::vector<WatchedPart> watched(const ModelBounds& bounds, std::size_t index, Bounds& compared) {
    std::vector<WatchedPart> out;
    for (const std::size_t p : compared_parts(bounds)) {
      const BoundedPart& bound = bounds.clips[index].parts[p];
      compared.boxes.push_back(bound.box), compared.balls.push_back(bound.ball);
      out.push_back({bounds.parts[p].vertices, bound.ball.center.cast<double>()});
    }
    return out;
  }

  void look() {
    std::vector<double> times = watched_.key_times();
    const auto more = random_times(result_.duration, settings_.random_times, settings_.seed);
    times.insert(times.end(), more.begin(), more.end());
    seen_ = watched_.at(times);
    result_.random_times = settings_.random_times;
    result_.close_times =
        watched_.look_closer(seen_, result_.duration / static_cast<double>(times.size()), settings_.halvings, result_.places);
    for (const WatchedPart& part : parts_) result_.places += static_cast<long>(times.size() * part.vertices.size());
  }

  void measure_volumes() {
    double sum = 0;
    long count = 0;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const Box<double> box = seen_[p].box();
      const double ratio = volume_of(box_of<double>(bounds_.boxes[p])) / volume_of(box);
      if (p == 0) result_.whole_ratio = ratio;
      else if (box.edges().minCoeff() < flattest_side * box.edges().maxCoeff()) ++result_.flat_clusters;
      else sum += ratio, ++count;
    }
    result_.cluster_ratio = count > 0 ? sum / static_cast<double>(count) : 1;
  }

  // How far beyond a wall of a bound a part gets; less than 0 where it does not.
  double beyond(std::size_t part, int wall, const Box<float>& box) const {
    if (wall == ball_wall) return seen_[part].values[wall] - bounds_.balls[part].radius;
    return seen_[part].values[wall] - walls_of(box)[wall];
  }

  Verdict is_in(std::size_t part, int wall, const Box<float>& box) {
    const Place& place = seen_[part].places[wall];
    return wall == ball_wall ? exact_.is_in(place, bounds_.balls[part]) : exact_.is_in(place, box);
  }

  void check_closest() {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      std::array<int, wall_count> walls;
      std::iota(walls.begin(), walls.end(), 0);
      std::sort(walls.begin(), walls.end(),
                [&](int a, int b) { return beyond(p, a, bounds_.boxes[p]) > beyond(p, b, bounds_.boxes[p]); });
      for (int i = 0; i < settings_.exact_walls; ++i) {
        const Verdict verdict = is_in(p, walls[i], bounds_.boxes[p]);
        ++result_.exact_checks;
        result_.exact_misses += verdict == Verdict::fails;
        result_.exact_undecided += verdict == Verdict::undecided;
      }
    }
  }

  void add_misses(const std::string& way, const std::vector<Box<float>>& boxes, bool with_balls) {
    ClipMisses misses{way};
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      int worst = -1;
      double by = -infinite;
      Verdict missed = Verdict::fails;
      for (int wall = 0; wall < (with_balls ? wall_count : ball_wall); ++wall) {
        const double out = beyond(p, wall, boxes[p]), error = watched_.errors()[p];
        const Verdict outside = out > error ? Verdict::holds : out < -error ? Verdict::fails : !is_in(p, wall, boxes[p]);
        missed |= outside;
        if (outside == Verdict::holds && out > by) by = out, worst = wall;
      }
      misses.undecided += missed == Verdict::undecided;
      if (missed != Verdict::holds) continue;
      const double share = std::max(by, 0.0) / longest_side(boxes[p]);
      if (p == 0) {
        misses.whole_missed = true, misses.whole_by = share;
        continue;
      }
      ++misses.clusters;
      if (misses.cluster >= 0 && share <= misses.cluster_by) continue;
      const Place& place = seen_[p].places[worst];
      misses.cluster_by = share, misses.cluster = static_cast<int>(p) - 1, misses.vertex = place.vertex, misses.time = place.time;
    }
    result_.misses.push_back(misses);
  }

  const OverTimeSettings& settings_;
  ExactPlaces exact_;
  Bounds bounds_;
  const std::vector<WatchedPart> parts_;
  const WatchedClip watched_;
  std::vector<Extremes> seen_;
  ClipResult result_;
};

// The model with those of its clips that have bounds.
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

}  // namespace

Model with_keys(const Model& model) {
  return model.skeleton.joints.size() == model.joints.size() ? model : keyed(model, keys_a_second);
}

std::vector<OverTimeResult> run_over_time(const Model& made, const OverTimeSettings& settings) {
  Model model = with_keys(made);
  if (settings.clips > 0 && model.clips.size() > static_cast<std::size_t>(settings.clips)) model.clips.resize(settings.clips);
  const JointSets sets(model);
  std::vector<OverTimeResult> results;
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}) {
    const Bounded found = bounded(model, skinning);
    OverTimeResult& r = results.emplace_back(OverTimeResult{model.name, skinning, static_cast<long>(model.triangles.size())});
    r.clusters = static_cast<long>(compared_parts(found.bounds).size()) - 1;
    r.seconds = found.seconds, r.refused = found.refused;
    std::printf("  %s: %ld clusters, bounded in %.2f s\n", table_name_of(skinning), r.clusters, r.seconds);
    for (const std::string& why : r.refused) std::printf("    no bound of %s\n", why.c_str());
    for (std::size_t c = 0; c < found.model.clips.size(); ++c) {
      r.clips.push_back(ClipChecks(found.model, sets, found.model.clips[c], found.bounds, c, settings).result());
      const ClipResult& clip = r.clips.back();
      std::printf("    %-12s volume of the whole %.4f, of clusters %.4f; %ld exact checks, %ld misses, %ld undecided\n",
                  clip.clip.c_str(), clip.whole_ratio, clip.cluster_ratio, clip.exact_checks, clip.exact_misses,
                  clip.exact_undecided);
      for (const ClipMisses& m : clip.misses)
        std::printf("      %-7s %s %.4f, clusters missed %3ld, worst %.4f, undecided %ld\n", m.way.c_str(),
                    m.whole_missed ? "whole missed" : "whole held  ", m.whole_by, m.clusters, m.cluster_by, m.undecided);
      std::cout << std::flush;
    }
  }
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
    add("all", "bounds", "seconds", r.seconds, "s");
    add("all", "bounds", "refused_clips", static_cast<double>(r.refused.size()));
    for (const ClipResult& c : r.clips) {
      const auto add_count = [&](const char* quantity, long value) { add(c.clip, "bounds", quantity, static_cast<double>(value)); };
      add(c.clip, "bounds", "duration", c.duration, "s");
      add_count("random_times", c.random_times);
      add_count("close_times", c.close_times);
      add_count("places", c.places);
      add_count("exact_checks", c.exact_checks);
      add_count("exact_misses", c.exact_misses);
      add_count("exact_undecided", c.exact_undecided);
      add(c.clip, "bounds", "whole_ratio", c.whole_ratio);
      add(c.clip, "bounds", "cluster_ratio", c.cluster_ratio);
      add_count("flat_clusters", c.flat_clusters);
      for (const ClipMisses& m : c.misses) {
        add(c.clip, m.way, "whole_missed", m.whole_missed);
        add(c.clip, m.way, "whole_by", m.whole_by);
        add(c.clip, m.way, "clusters_missed", static_cast<double>(m.clusters));
        add(c.clip, m.way, "cluster_by", m.cluster_by);
        add(c.clip, m.way, "worst_cluster", m.cluster);
        add(c.clip, m.way, "worst_vertex", m.vertex);
        add(c.clip, m.way, "worst_time", m.time, "s");
        add(c.clip, m.way, "undecided", static_cast<double>(m.undecided));
      }
    }
  }
  file.write(path);
}

}  // namespace refitlab
