// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/watched_clip.hpp"

#include <atomic>
#include <mutex>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/parallel.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// AnimatedJoints keeps the pose of every time that it is asked for. So each of them is asked for at most this many times.
constexpr std::size_t times_at_once = 128;

}  // namespace

WatchedClip::WatchedClip(const Model& model, const JointSets& sets, const Animation& animation, Skinning skinning,
                         const std::vector<WatchedPart>& parts)
    : model_(model),
      sets_(sets),
      animation_(animation),
      skinning_(skinning),
      parts_(parts),
      errors_(parts.size(), 0) {
  const AnimatedJoints joints(model, animation, skinning != Skinning::linear);
  key_times_ = joints.times();
  parallel_for(parts.size(), [&](std::size_t p) {
    const MovingVertices moving(model, sets, skinning, parts[p].vertices);
    for (const ParameterBox& box : joints.boxes()) errors_[p] = std::max(errors_[p], moving.placing_error(joints.cell(box)));
  });
}

std::vector<Extremes> WatchedClip::at(std::span<const double> times) const {
  std::vector<Extremes> found(parts_.size());
  std::mutex guard;
  const MovingVertices moving(model_, sets_, skinning_, indices_below(model_.vertices.size()));
  parallel_for((times.size() + times_at_once - 1) / times_at_once, [&](std::size_t batch) {
    const DefaultFloatEnvironment environment;
    const AnimatedJoints joints(model_, animation_, skinning_ != Skinning::linear);
    std::vector<Extremes> own(parts_.size());
    std::vector<Point3> points;
    const std::size_t first = batch * times_at_once;
    for (const double time : times.subspan(first, std::min(times_at_once, times.size() - first)))
      for (const Side side : {Side::before, Side::after}) {
        if (joints.side_of(time, side) != side) continue;
        moving.place(*joints.at(time, side), Followed::skinned, points);
        for (std::size_t p = 0; p < parts_.size(); ++p)
          for (const int v : parts_[p].vertices) own[p].add(points[v], parts_[p].center, {v, time, side});
      }
    const std::lock_guard lock(guard);
    for (std::size_t p = 0; p < parts_.size(); ++p) found[p].merge(own[p]);
  });
  return found;
}

long WatchedClip::look_closer(std::vector<Extremes>& found, double step, int halvings, long& places) const {
  std::atomic<long> looks = 0, places_seen = 0;
  parallel_for(parts_.size(), [&](std::size_t p) {
    const DefaultFloatEnvironment environment;
    long own = 0;
    look_closer(p, found[p], step, halvings, own);
    looks += own, places_seen += own * static_cast<long>(parts_[p].vertices.size());
  });
  places += places_seen;
  return looks;
}

void WatchedClip::look_closer(std::size_t part, Extremes& found, double step, int halvings, long& looks) const {
  const AnimatedJoints joints(model_, animation_, skinning_ != Skinning::linear);
  const MovingVertices moving(model_, sets_, skinning_, parts_[part].vertices);
  std::vector<Point3> points;
  for (int halving = 0; halving < halvings; ++halving, step /= 2) {
    std::vector<double> near;
    for (const Place& place : found.places)
      for (const double time : {place.time - step, place.time + step})
        if (time >= 0 && time <= key_times_.back()) near.push_back(time);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    looks += static_cast<long>(near.size());
    for (const double time : near) {
      moving.place(*joints.at(time, Side::after), Followed::skinned, points);
      for (std::size_t i = 0; i < points.size(); ++i)
        found.add(points[i], parts_[part].center, {moving.vertices()[i], time, Side::after});
    }
  }
}

}  // namespace refitlab
