// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/clip_checks.hpp"

#include <algorithm>
#include <random>
#include <tuple>

#include "experiments/over_time/exact_places.hpp"
#include "experiments/over_time/sampled_boxes.hpp"

namespace refitlab {
namespace {

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
      const double ratio = volume_of_box(box_of<double>(bounds_.boxes[p])) / volume_of_box(box);
      if (p == 0) result_.whole_ratio = is_flat(box) ? 1 : ratio;
      else if (is_flat(box)) ++result_.flat_clusters;
      else sum += ratio, ++count;
    }
    result_.cluster_ratio = count > 0 ? sum / static_cast<double>(count) : 1;
  }

  // Returns how far a part gets beyond a wall of a bound. It is less than 0 if it does not.
  double beyond(std::size_t part, int wall, const Box<float>& box) const {
    if (wall == ball_wall) return seen_[part].values[wall] - bounds_.balls[part].radius;
    return seen_[part].values[wall] - walls_of(box)[wall];
  }

  Verdict is_in(std::size_t part, int wall, const Box<float>& box) {
    const Place& place = seen_[part].places[wall];
    return wall == ball_wall ? exact_.is_in(place, bounds_.balls[part]) : exact_.is_in(place, box);
  }

  // Checks the places that are closest to bounds, relative to their part's size. Otherwise only small parts would be checked.
  void check_closest() {
    std::vector<std::tuple<double, std::size_t, int>> close;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (int wall = 0; wall < wall_count; ++wall)
        close.emplace_back(-beyond(p, wall, bounds_.boxes[p]) / longest_side(bounds_.boxes[p]), p, wall);
    std::sort(close.begin(), close.end());
    close.resize(std::min(close.size(), static_cast<std::size_t>(settings_.exact_checks)));
    for (const auto& [gap, p, wall] : close) {
      const Verdict verdict = is_in(p, wall, bounds_.boxes[p]);
      ++result_.exact_checks;
      result_.exact_misses += verdict == Verdict::fails;
      result_.exact_undecided += verdict == Verdict::undecided;
    }
  }

  void add_misses(const std::string& way, const std::vector<Box<float>>& boxes, bool with_balls) {
    ClipMisses misses{way};
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      int worst = 0;
      for (int wall = 0; wall < (with_balls ? wall_count : ball_wall); ++wall)
        if (beyond(p, wall, boxes[p]) > beyond(p, worst, boxes[p])) worst = wall;
      const double by = beyond(p, worst, boxes[p]), error = watched_.errors()[p];
      Verdict missed = verdict_of(by > error);
      for (int wall = 0; wall < (with_balls ? wall_count : ball_wall); ++wall)
        if (missed != Verdict::holds && beyond(p, wall, boxes[p]) >= -error) missed |= !is_in(p, wall, boxes[p]);
      misses.undecided += missed == Verdict::undecided;
      if (missed != Verdict::holds) continue;
      const Place& place = seen_[p].places[worst];
      const Miss miss{place.vertex, place.time, std::max(by, 0.0) / longest_side(boxes[p])};
      if (p == 0) {
        misses.of_whole = miss;
        continue;
      }
      ++misses.clusters;
      if (misses.worst_cluster < 0 || miss.by > misses.of_cluster.by)
        misses.worst_cluster = static_cast<int>(p) - 1, misses.of_cluster = miss;
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

}  // namespace

std::vector<std::size_t> compared_parts(const ModelBounds& bounds) {
  std::vector<std::size_t> out = {0};
  for (std::size_t p = 0; p < bounds.parts.size(); ++p)
    if (bounds.parts[p].kind == PartKind::cluster) out.push_back(p);
  return out;
}

ClipResult check_clip(const Model& model, const JointSets& sets, const ModelBounds& bounds, std::size_t clip,
                      const OverTimeSettings& settings) {
  return ClipChecks(model, sets, model.clips[clip], bounds, clip, settings).result();
}

}  // namespace refitlab
