// SPDX-License-Identifier: GPL-3.0-or-later
// These are the fields of every result and setting, in order, so that finished units can be kept and found again.
//
// A structured binding names all members or does not compile. Each list of names stands once, for the binding and for what is
// kept, so none can be forgotten here.
#pragma once

#include <tuple>

#include "experiments/collisions/collisions.hpp"
#include "experiments/crowds/crowds.hpp"
#include "experiments/deformations/deformations.hpp"
#include "experiments/engines/engines.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/over_time/crossfades.hpp"
#include "experiments/over_time/growth.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/rounding/rounding.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/synthetic/synthetic.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

#define REFITLAB_FIELDS(Type, ...) \
  inline auto fields(Type& v) {    \
    auto& [__VA_ARGS__] = v;       \
    return std::tie(__VA_ARGS__);  \
  }

namespace refitlab {

REFITLAB_FIELDS(SpeedSettings, seconds, repetitions)
REFITLAB_FIELDS(TightnessSettings, times)
REFITLAB_FIELDS(VolumeSettings, times, nodes, speed)
REFITLAB_FIELDS(RoundingSettings, poses, vertices, speed, seed)
REFITLAB_FIELDS(CollisionSettings, frames, speed, all, first)
REFITLAB_FIELDS(TriangleGrowthSettings, frames, subdivisions, speed)
REFITLAB_FIELDS(CrowdSettings, most, speed)
REFITLAB_FIELDS(SyntheticSettings, count, seed)
REFITLAB_FIELDS(OverTimeSettings, times, halvings, walls, clips, seed)
REFITLAB_FIELDS(CrossfadeSettings, times, weights, clips, triangles, all)
REFITLAB_FIELDS(OverTimeGrowthSettings, repetitions, subdivisions, million)

REFITLAB_FIELDS(LevelTightness, nodes, undefined, least, greatest, sum, optimal, misses, worst)
REFITLAB_FIELDS(TightnessResult, model, pose, kind, poses, tightness)
REFITLAB_FIELDS(SpeedResult, model, pose, variant, level, ns, ratio)
REFITLAB_FIELDS(BatchSpeed, model, pose, what, how, item, ns, ratio, to_linear, chain, lanes)
REFITLAB_FIELDS(LevelVolumes, nodes, misses, size, optimal, ball, solid, ratio)
REFITLAB_FIELDS(VolumeResult, model, pose, kind, poses, volumes)
REFITLAB_FIELDS(VolumeCost, model, pose, kind, variant, ns, ratio)
REFITLAB_FIELDS(VolumeResults, tightness, costs)
REFITLAB_FIELDS(RoundingResult, model, variant, checks, misses, float_misses, as_computed, inflation, float_inflation, cost)
REFITLAB_FIELDS(CollisionResult, model, pose, scene, detector, origin, query, differing, pairs, volumes, triangles, nodes,
                vertices, share, us, stages, to_engine, to_skin_all, to_repaired)
REFITLAB_FIELDS(TriangleGrowth, triangles, result)
REFITLAB_FIELDS(JointGrowth, joints, sets, many, own, below, own_root, root_below, root_known, ratio, ratio_below)
REFITLAB_FIELDS(CrowdResult::Time, detector, us, ratio_to_clusters)
REFITLAB_FIELDS(CrowdResult, scene, characters, boxes, contacts, triangles, skinned, times)
REFITLAB_FIELDS(Miss, vertex, time, by)
REFITLAB_FIELDS(ClipMisses, way, whole, clusters, worst, of_cluster, undecided)
REFITLAB_FIELDS(ClipResult, clip, duration, random, close, places, checks, misses, undecided, whole, clusters, flat, ways)
REFITLAB_FIELDS(OverTimeResult, model, skinning, triangles, clusters, seconds, refused, clips)
REFITLAB_FIELDS(CrossfadeResult, first, second, places, outside, undecided, whole, cluster, clusters, flat, out)
REFITLAB_FIELDS(CrossfadesResult, model, skinning, seconds, refused, crossfades)
REFITLAB_FIELDS(OverTimeGrowth, grown, walk_cycles, triangles, clusters, seconds, bounding, all)
REFITLAB_FIELDS(EngineSettings, times, clips, speed, unseen)
REFITLAB_FIELDS(BoxMeasure, method, poses, misses, undecided, unbounded, flat, volume, area, radius, to_reference, by)
REFITLAB_FIELDS(EnginePoses, name, kind, skinning, measures)
REFITLAB_FIELDS(EngineCost, method, skinning, ns, ratio, ns_of_matrices, ratio_of_matrices)
REFITLAB_FIELDS(EngineResult, model, refused, poses, costs)
REFITLAB_FIELDS(ReducedSettings, frames, size, poses)
REFITLAB_FIELDS(DeformationSettings, times, reduced, speed)
REFITLAB_FIELDS(DeformationMeasure, kind, variant, skinning, poses, levels)
REFITLAB_FIELDS(DeformedCost, kind, variant, ns, ratio, ratio_kept)
REFITLAB_FIELDS(ReducedMeasure, variant, balls, levels)
REFITLAB_FIELDS(ReducedResult, kind, frames, size, share, poses, measures)
REFITLAB_FIELDS(ReducedCost, variant, balls, ns, ratio)
REFITLAB_FIELDS(DeformationResult, model, joints, targets, measures, costs, reduced, reduced_costs)
REFITLAB_FIELDS(SyntheticResult, variant, cases, undefined, unbounded, misses, beyond, worst, mean, median, greatest, ns)

}  // namespace refitlab

#undef REFITLAB_FIELDS
