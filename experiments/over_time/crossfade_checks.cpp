// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/over_time/crossfade_checks.hpp"

#include <mutex>

#include "algorithms/bake/over_time/crossfaded_joints.hpp"
#include "algorithms/bake/parallel.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "experiments/over_time/clip_checks.hpp"
#include "experiments/over_time/extremes.hpp"

namespace refitlab {
namespace {

ParameterMoment::Coordinate evenly_spaced(double end, int index, int count) { return {end * index / (count - 1), Side::after}; }

// Returns how far a part gets beyond the farthest wall. It is less than 0 if it stays inside.
double beyond(const Extremes& seen, const Box<float>& box) {
  double most = -infinite;
  for (int wall = 0; wall < ball_wall; ++wall) most = std::max(most, seen.values[wall] - walls_of(box)[wall]);
  return most;
}

}  // namespace

CrossfadeResult check_crossfade(const Model& model, const JointSets& sets, const ModelBounds& bounds, std::size_t crossfade,
                                const CrossfadeSettings& settings) {
  const BoundedCrossfade& bound = bounds.crossfades[crossfade];
  const Clip &first = model.clips[bound.first], &second = model.clips[bound.second];
  const bool needs_pose = bounds.skinning != Skinning::linear;
  const std::vector<int> joints = indices_below(model.joints.size());
  const std::vector<std::size_t> compared = compared_parts(bounds);
  const MovingVertices moving(model, sets, bounds.skinning, indices_below(model.vertices.size()));
  CrossfadeResult result{first.name, second.name};
  result.clusters = static_cast<long>(compared.size()) - 1;

  std::vector<Extremes> seen(compared.size());
  std::mutex guard;
  parallel_for(static_cast<std::size_t>(settings.times), [&](std::size_t a) {
    const DefaultFloatEnvironment environment;
    const CrossfadedJoints fading(model, first.animation, second.animation, joints, bounds.rotations, needs_pose);
    const std::vector<ParameterRange> ranges = fading.boxes()[0].ranges;
    std::vector<Extremes> own(compared.size());
    std::vector<Point3> points;
    for (int b = 0; b < settings.times; ++b)
      for (int w = 0; w < settings.weights; ++w) {
        const ParameterMoment moment{{evenly_spaced(ranges[0].end, static_cast<int>(a), settings.times),
                                      evenly_spaced(ranges[1].end, b, settings.times), evenly_spaced(1, w, settings.weights)}};
        moving.place(*fading.at(moment), Followed::skinned, points);
        for (std::size_t p = 0; p < compared.size(); ++p)
          for (const int v : bounds.parts[compared[p]].vertices)
            own[p].add(points[v], bound.parts[compared[p]].ball.center.cast<double>(), {v, moment.coordinates[0].value});
      }
    const std::lock_guard lock(guard);
    for (std::size_t p = 0; p < compared.size(); ++p) seen[p].merge(own[p]);
  });

  const CrossfadedJoints fading(model, first.animation, second.animation, joints, bounds.rotations, needs_pose);
  const double error = moving.placing_error(fading.cell(fading.boxes()[0]));
  double sum = 0;
  long count = 0;
  for (std::size_t p = 0; p < compared.size(); ++p) {
    result.places +=
        static_cast<long>(bounds.parts[compared[p]].vertices.size()) * settings.times * settings.times * settings.weights;
    const BoundedPart& part = bound.parts[compared[p]];
    const double by = std::max(beyond(seen[p], part.box), seen[p].values[ball_wall] - part.ball.radius);
    result.outside += by > error;
    result.undecided += by <= error && by > -error;
    Box<float> of_clips = bounds.clips[bound.first].parts[compared[p]].box;
    of_clips.merge(bounds.clips[bound.second].parts[compared[p]].box);
    result.out_of_both_clips += beyond(seen[p], of_clips) > error;
    const Box<double> box = seen[p].box();
    const double ratio = volume_of_box(box_of<double>(part.box)) / volume_of_box(box);
    if (p == 0) result.whole_ratio = is_flat(box) ? 1 : ratio;
    else if (is_flat(box)) ++result.flat_clusters;
    else sum += ratio, ++count;
  }
  result.cluster_ratio = count > 0 ? sum / static_cast<double>(count) : 1;
  return result;
}

}  // namespace refitlab
