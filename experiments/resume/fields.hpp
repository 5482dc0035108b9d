// SPDX-License-Identifier: GPL-3.0-or-later
// These are the fields of every result and setting, in order, so that finished units can be kept and found again.
//
// A structured binding names all members or does not compile, so none can be forgotten here.
#pragma once

#include <tuple>

#include "experiments/collisions/collisions.hpp"
#include "experiments/deformations/deformations.hpp"
#include "experiments/engines/engines.hpp"
#include "experiments/growth/characters.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/over_time/crossfades.hpp"
#include "experiments/over_time/growth.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/rounding/rounding.hpp"
#include "experiments/speed/balls.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/synthetic/synthetic.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

namespace refitlab {

inline auto fields(SpeedSettings& v) {
  auto& [seconds, repetitions] = v;
  return std::tie(seconds, repetitions);
}
inline auto fields(TightnessSettings& v) {
  auto& [times] = v;
  return std::tie(times);
}
inline auto fields(VolumeSettings& v) {
  auto& [times, nodes, speed] = v;
  return std::tie(times, nodes, speed);
}
inline auto fields(RoundingSettings& v) {
  auto& [poses, vertices, speed, seed] = v;
  return std::tie(poses, vertices, speed, seed);
}
inline auto fields(CollisionSettings& v) {
  auto& [frames, speed, all, first] = v;
  return std::tie(frames, speed, all, first);
}
inline auto fields(TriangleGrowthSettings& v) {
  auto& [frames, million, speed] = v;
  return std::tie(frames, million, speed);
}
inline auto fields(SyntheticSettings& v) {
  auto& [count, seed] = v;
  return std::tie(count, seed);
}
inline auto fields(OverTimeSettings& v) {
  auto& [times, halvings, walls, clips, seed] = v;
  return std::tie(times, halvings, walls, clips, seed);
}
inline auto fields(CrossfadeSettings& v) {
  auto& [times, weights, clips, triangles, all] = v;
  return std::tie(times, weights, clips, triangles, all);
}
inline auto fields(OverTimeGrowthSettings& v) {
  auto& [repetitions, subdivisions, million] = v;
  return std::tie(repetitions, subdivisions, million);
}

inline auto fields(LevelTightness& v) {
  auto& [nodes, undefined, least, greatest, sum, optimal, misses, worst] = v;
  return std::tie(nodes, undefined, least, greatest, sum, optimal, misses, worst);
}
inline auto fields(TightnessResult& v) {
  auto& [model, pose, kind, poses, tightness] = v;
  return std::tie(model, pose, kind, poses, tightness);
}
inline auto fields(SpeedResult& v) {
  auto& [model, pose, variant, level, ns, ratio] = v;
  return std::tie(model, pose, variant, level, ns, ratio);
}
inline auto fields(BatchSpeed& v) {
  auto& [model, pose, what, how, item, ns, ratio, to_linear] = v;
  return std::tie(model, pose, what, how, item, ns, ratio, to_linear);
}
inline auto fields(BallSpeed& v) {
  auto& [clouds, space, variant, points, ns, ratio] = v;
  return std::tie(clouds, space, variant, points, ns, ratio);
}
inline auto fields(LevelVolumes& v) {
  auto& [nodes, misses, size, optimal, ball, solid, ratio] = v;
  return std::tie(nodes, misses, size, optimal, ball, solid, ratio);
}
inline auto fields(VolumeResult& v) {
  auto& [model, pose, kind, poses, volumes] = v;
  return std::tie(model, pose, kind, poses, volumes);
}
inline auto fields(VolumeCost& v) {
  auto& [model, pose, kind, variant, ns, ratio] = v;
  return std::tie(model, pose, kind, variant, ns, ratio);
}
inline auto fields(VolumeResults& v) {
  auto& [tightness, costs] = v;
  return std::tie(tightness, costs);
}
inline auto fields(RoundingResult& v) {
  auto& [model, variant, checks, misses, float_misses, as_computed, inflation, float_inflation, cost] = v;
  return std::tie(model, variant, checks, misses, float_misses, as_computed, inflation, float_inflation, cost);
}
inline auto fields(CollisionResult& v) {
  auto& [model, scene, detector, origin, query, differing, pairs, volumes, triangles, nodes, vertices, share, us, stages,
         to_engine, to_skin_all, to_repaired] = v;
  return std::tie(model, scene, detector, origin, query, differing, pairs, volumes, triangles, nodes, vertices, share, us, stages,
                  to_engine, to_skin_all, to_repaired);
}
inline auto fields(TriangleGrowth& v) {
  auto& [triangles, result] = v;
  return std::tie(triangles, result);
}
inline auto fields(JointGrowth& v) {
  auto& [joints, sets, many, own, below, own_root, root_below, root_known, ratio, ratio_below] = v;
  return std::tie(joints, sets, many, own, below, own_root, root_below, root_known, ratio, ratio_below);
}
inline auto fields(CharacterGrowth& v) {
  auto& [characters, boxes, contacts, triangles, skinned, full, yes_no, two_threads, skin_all] = v;
  return std::tie(characters, boxes, contacts, triangles, skinned, full, yes_no, two_threads, skin_all);
}
inline auto fields(Miss& v) {
  auto& [vertex, time, by] = v;
  return std::tie(vertex, time, by);
}
inline auto fields(ClipMisses& v) {
  auto& [way, whole, clusters, worst, of_cluster, undecided] = v;
  return std::tie(way, whole, clusters, worst, of_cluster, undecided);
}
inline auto fields(ClipResult& v) {
  auto& [clip, duration, random, close, places, checks, misses, undecided, whole, clusters, flat, ways] = v;
  return std::tie(clip, duration, random, close, places, checks, misses, undecided, whole, clusters, flat, ways);
}
inline auto fields(OverTimeResult& v) {
  auto& [model, skinning, triangles, clusters, seconds, refused, clips] = v;
  return std::tie(model, skinning, triangles, clusters, seconds, refused, clips);
}
inline auto fields(CrossfadeResult& v) {
  auto& [first, second, places, outside, undecided, whole, cluster, clusters, flat, out] = v;
  return std::tie(first, second, places, outside, undecided, whole, cluster, clusters, flat, out);
}
inline auto fields(CrossfadesResult& v) {
  auto& [model, skinning, seconds, refused, crossfades] = v;
  return std::tie(model, skinning, seconds, refused, crossfades);
}
inline auto fields(OverTimeGrowth& v) {
  auto& [by, length, triangles, clusters, seconds, bounding, all] = v;
  return std::tie(by, length, triangles, clusters, seconds, bounding, all);
}
inline auto fields(EngineSettings& v) {
  auto& [times, clips, speed, unseen] = v;
  return std::tie(times, clips, speed, unseen);
}
inline auto fields(BoxMeasure& v) {
  auto& [method, poses, misses, undecided, unbounded, flat, volume, area, radius, greatest, to_reference, by, at] = v;
  return std::tie(method, poses, misses, undecided, unbounded, flat, volume, area, radius, greatest, to_reference, by, at);
}
inline auto fields(EnginePoses& v) {
  auto& [name, kind, skinning, measures] = v;
  return std::tie(name, kind, skinning, measures);
}
inline auto fields(EngineCost& v) {
  auto& [method, skinning, ns, ratio, ns_of_matrices, ratio_of_matrices] = v;
  return std::tie(method, skinning, ns, ratio, ns_of_matrices, ratio_of_matrices);
}
inline auto fields(EngineResult& v) {
  auto& [model, vertices, joints, refused, poses, costs] = v;
  return std::tie(model, vertices, joints, refused, poses, costs);
}
inline auto fields(ReducedSettings& v) {
  auto& [frames, size, poses] = v;
  return std::tie(frames, size, poses);
}
inline auto fields(DeformationSettings& v) {
  auto& [times, reduced, speed] = v;
  return std::tie(times, reduced, speed);
}
inline auto fields(DeformationMeasure& v) {
  auto& [kind, variant, skinning, poses, levels] = v;
  return std::tie(kind, variant, skinning, poses, levels);
}
inline auto fields(DeformedCost& v) {
  auto& [kind, variant, ns, ratio, ratio_kept] = v;
  return std::tie(kind, variant, ns, ratio, ratio_kept);
}
inline auto fields(ReducedMeasure& v) {
  auto& [variant, balls, levels] = v;
  return std::tie(variant, balls, levels);
}
inline auto fields(ReducedResult& v) {
  auto& [kind, frames, size, share, poses, measures] = v;
  return std::tie(kind, frames, size, share, poses, measures);
}
inline auto fields(ReducedCost& v) {
  auto& [variant, balls, ns, ratio] = v;
  return std::tie(variant, balls, ns, ratio);
}
inline auto fields(DeformationResult& v) {
  auto& [model, vertices, joints, targets, measures, costs, reduced, reduced_costs] = v;
  return std::tie(model, vertices, joints, targets, measures, costs, reduced, reduced_costs);
}
inline auto fields(SyntheticResult& v) {
  auto& [variant, share, cases, undefined, unbounded, misses, beyond, worst, mean, median, greatest, ns] = v;
  return std::tie(variant, share, cases, undefined, unbounded, misses, beyond, worst, mean, median, greatest, ns);
}

}  // namespace refitlab
