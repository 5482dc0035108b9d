// SPDX-License-Identifier: GPL-3.0-or-later
// What the experiment on bounds over time makes of a clip: the farthest places, clips several times over, and what gets out of bounds.
#include <algorithm>
#include <cmath>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/model/keyed.hpp"
#include "experiments/over_time/clip_checks.hpp"
#include "experiments/over_time/crossfade_checks.hpp"
#include "experiments/over_time/exact_places.hpp"
#include "experiments/over_time/repeated.hpp"
#include "experiments/over_time/sampled_boxes.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_over_time_experiment {
namespace {

using namespace refitlab;

const Model& man() {
  static const Model model = keyed(make_man(1500), 10);
  return model;
}

const JointSets& sets() {
  static const JointSets made(man());
  return made;
}

const ModelBounds& bounds() {
  static const ModelBounds made = bound_model(man());
  return made;
}

double half() { return *rc::gen::inRange(-20, 20) / 2.; }

// Along the way of a wall, which is the last one away from the center.
double value_of(int wall, const Point3& p, const Point3& center) {
  return wall == ball_wall ? norm<double, 3>(p - center) : wall < 3 ? -p[wall] : p[wall - 3];
}

ClipResult checked(const ModelBounds& some) {
  return check_clip(man(), sets(), some, 0, {.random_times = 60, .halvings = 4, .exact_checks = 3});
}

// Closes in on the vertices from above, by a share of a side: of the whole character, or of a cluster.
ModelBounds too_small(std::size_t part, float share) {
  ModelBounds some = bounds();
  Box<float>& box = some.clips[0].parts[compared_parts(some)[part]].box;
  box.high[1] -= share * (box.high[1] - box.low[1]);
  return some;
}

const ClipMisses& of_bounds(const ClipResult& result) { return result.misses[0]; }

Point3 place_of(const Place& place, Skinning skinning) {
  const AnimatedJoints joints(man(), man().clips[0].animation, skinning != Skinning::linear);
  std::vector<Point3> points;
  MovingVertices(man(), sets(), skinning, {place.vertex}).place(*joints.at(place.time, place.side), Followed::skinned, points);
  return points[0];
}

void clips_repeated_and_sampled(Suite& t) {
  t.holds("extremes are the farthest of all places, whichever came first, and of whichever part", {.cases = 500}, [] {
    const Point3 center(half(), half(), half());
    const auto count = *rc::gen::inRange(1, 12), first = *rc::gen::inRange(0, count + 1);
    std::vector<Point3> points;
    Extremes one, other;
    for (int i = 0; i < count; ++i) {
      points.emplace_back(half(), half(), half());
      (i < first ? one : other).add(points[i], center, {i, i / 8., Side::after});
    }
    one.merge(other);
    for (int wall = 0; wall < wall_count; ++wall) {
      double greatest = -infinite;
      for (const Point3& p : points) greatest = std::max(greatest, value_of(wall, p, center));
      RC_ASSERT(one.values[wall] == greatest);
      RC_ASSERT(value_of(wall, points[one.places[wall].vertex], center) == greatest);
      RC_ASSERT(one.places[wall].time == one.places[wall].vertex / 8.);
    }
    for (const Point3& p : points)
      RC_ASSERT((one.box().low.array() <= p.array()).all() && (one.box().high.array() >= p.array()).all());
  });
  t.holds("a clip several times over moves the joints as the clip does, each time", {.cases = 60}, [] {
    const Animation& walk = man().clips[0].animation;
    const int times = *rc::gen::inRange(1, 5), which = *rc::gen::inRange(0, times);
    const double time = walk.duration * *rc::gen::inRange(0, 1000) / 1000.;
    const Animation longer = repeated(walk, times);
    RC_ASSERT(longer.duration == times * walk.duration);
    RC_ASSERT(longer.tracks[0].rotations.keys.size() == times * (walk.tracks[0].rotations.keys.size() - 1) + 1);
    const auto once = skin_matrices(man().skeleton, walk, time),
               again = skin_matrices(man().skeleton, longer, time + which * walk.duration);
    for (std::size_t j = 0; j < once.size(); ++j) RC_ASSERT((once[j] - again[j]).norm() < 1e-9);
  });
  t.holds("a spline several times over has the tangents that it has once, on both sides of a seam", {.cases = 200}, [] {
    WeightTrack track{0, {{}, Interpolation::cubic, {}}};
    for (const double time : {0., 1., 3.}) {
      track.weights.keys.push_back({time, Eigen::VectorXd::Constant(1, time == 1 ? half() : 2)});
      track.weights.tangents.push_back({Eigen::VectorXd::Constant(1, half()), Eigen::VectorXd::Constant(1, half())});
    }
    const WeightTrack longer{0, repeated(track.weights, 3, 3)};
    const double time = *rc::gen::inRange(0, 3000) / 1000.;
    for (int n = 0; n < 3; ++n) RC_ASSERT(std::abs(weights_at(longer, time + 3 * n)[0] - weights_at(track, time)[0]) < 1e-9);
  });
  t.holds("sampled times are no more than a step apart and end with the clip", {.cases = 200}, [] {
    const double end = *rc::gen::inRange(0, 200) / 64.;
    for (const SamplingWay& way : sampling_ways()) {
      const std::vector<double> times = sampled_times(way, {0, end});
      RC_ASSERT(times.front() == 0 && times.back() == end && std::is_sorted(times.begin(), times.end()));
      for (std::size_t i = 0; i + 1 < times.size(); ++i) RC_ASSERT(way.rate == 0 || times[i + 1] - times[i] <= 1.0001 / way.rate);
    }
  });
}

void bounds_are_compared_with_what_is_seen(Suite& t) {
  t.example("the bounds hold, and are hardly larger than what was seen; boxes at the keys do not hold", {}, [] {
    const ClipResult result = checked(bounds());
    const ClipMisses& ours = of_bounds(result);
    return Checked(ours.of_whole.vertex < 0 && ours.clusters == 0 && ours.undecided == 0 && result.exact_checks == 3 &&
                       result.exact_misses == 0 && result.whole_ratio >= 1 && result.whole_ratio < 1.05 &&
                       result.cluster_ratio >= 1 && result.cluster_ratio < 1.05 && result.misses[1].clusters > 0,
                   1);
  });
  t.example("who gets out of a bound that is too small is found, with the vertex, the time and the share of a side", {}, [] {
    const std::size_t clusters = compared_parts(bounds()).size() - 1;
    long cases = 0;
    for (std::size_t part = 0; part <= clusters; part += 4)
      for (const float share : {0.05F, 0.3F}) {
        const ModelBounds some = too_small(part, share);
        const ClipResult result = checked(some);
        const ClipMisses& ours = of_bounds(result);
        const Miss& miss = part == 0 ? ours.of_whole : ours.of_cluster;
        if (ours.clusters != (part == 0 ? 0 : 1) || (ours.of_whole.vertex >= 0) != (part == 0)) return Checked(false, cases);
        if (part > 0 && ours.worst_cluster != static_cast<int>(part) - 1) return Checked(false, cases);
        if (result.exact_misses == 0) return Checked(false, cases);
        const Box<float>& box = some.clips[0].parts[compared_parts(some)[part]].box;
        const double out = place_of({miss.vertex, miss.time, Side::after}, Skinning::linear)[1] - box.high[1];
        if (!(out > 0) || std::abs(out / longest_side(box) - miss.by) > 1e-6) return Checked(false, cases);
        ++cases;
      }
    return Checked(cases > 0, cases);
  });
  t.example("what gets out of the bounds of a crossfade is counted, and they are compared with what is seen", {}, [] {
    Model model = man();
    model.clips = {model.clips[0], model.clips[0]};
    ModelBounds some = bound_model(model, {.cluster_triangles = 512, .crossfades = true});
    const CrossfadeSettings settings{.times = 9, .weights = 3};
    const CrossfadeResult good = check_crossfade(model, sets(), some, 0, settings);
    const std::size_t cluster = compared_parts(some)[1];
    for (const std::size_t p : {std::size_t{0}, cluster}) {
      Box<float>& box = some.crossfades[0].parts[p].box;
      box.high[1] -= 0.5f * (box.high[1] - box.low[1]);
    }
    const CrossfadeResult bad = check_crossfade(model, sets(), some, 0, settings);
    // Of a ball around a place at the middle, all but that place is outside.
    ModelBounds flat = bound_model(model, {.cluster_triangles = 0, .crossfades = true});
    flat.crossfades[0].parts[0].ball.radius = 0;
    const CrossfadeResult none = check_crossfade(model, sets(), flat, 0, settings);
    const long vertices = static_cast<long>(model.vertices.size());
    return Checked(good.outside == 0 && good.undecided == 0 && good.whole_ratio >= 1 && good.whole_ratio < 1.4 &&
                       good.cluster_ratio >= 1 && good.cluster_ratio < 1.5 && good.clusters > 3 &&
                       good.places >= 2 * 9 * 9 * 3 * vertices && bad.outside == 2 && bad.whole_ratio < 0.6 * good.whole_ratio &&
                       none.outside == 1 && none.clusters == 0 && none.cluster_ratio == 1,
                   3);
  });
}

}  // namespace

PROPTEST(over_time_experiment) {
  clips_repeated_and_sampled(t);
  bounds_are_compared_with_what_is_seen(t);
  t.holds("many digits decide for a box or a ball what is well inside or outside, for each skinning", {.cases = 40}, [] {
    const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::dual_quaternion);
    const Place place{*rc::gen::inRange(0, static_cast<int>(man().vertices.size())),
                      man().clips[0].duration * *rc::gen::inRange(0, 1000) / 1000., Side::after};
    ExactPlaces exact(man(), man().clips[0].animation, skinning);
    const Vec<float, 3> p = place_of(place, skinning).cast<float>();
    const float room = 1e-4F;
    Box<float> box{p, p};
    box.grow(room);
    RC_ASSERT(exact.is_in(place, box) == Verdict::holds);
    const int axis = *rc::gen::inRange(0, 3);
    const bool is_low = *rc::gen::arbitrary<bool>();
    (is_low ? box.low : box.high)[axis] = p[axis] + (is_low ? room : -room) / 2;
    RC_ASSERT(exact.is_in(place, box) == Verdict::fails);
    const Vec<float, 3> beside = p + Vec<float, 3>(0, 1, 0);
    RC_ASSERT(exact.is_in(place, Ball3<float>{beside, 1 + room}) == Verdict::holds);
    RC_ASSERT(exact.is_in(place, Ball3<float>{beside, 1 - room}) == Verdict::fails);
  });
}

}  // namespace proptests::suite_over_time_experiment
