// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what the experiment on bounds over time makes of a clip: the farthest places, clips played several times, and what leaves
// its bounds.
#include <algorithm>
#include <cmath>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/model/keyed.hpp"
#include "algorithms/results/result_file.hpp"
#include "experiments/over_time/clip_checks.hpp"
#include "experiments/over_time/crossfade_checks.hpp"
#include "experiments/over_time/exact_places.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/over_time/repeated.hpp"
#include "experiments/over_time/sampled_boxes.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/skinning_name.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"

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

// Returns the value along the direction of a wall; for the last one it is the distance from the center.
double value_of(int wall, const Point3& p, const Point3& center) {
  return wall == ball_wall ? norm<double, 3>(p - center) : wall < 3 ? -p[wall] : p[wall - 3];
}

ClipResult checked(const ModelBounds& some) {
  return check_clip(man(), sets(), some, 0, {.random_times = 60, .halvings = 4, .exact_checks = 3});
}

// Returns the bound of the whole character (part 0) or of a cluster in the first clip.
BoundedPart& bound_of(ModelBounds& some, std::size_t part) { return some.clips[0].parts[compared_parts(some)[part]]; }

// Lowers the top of a box by a share of its height.
void lower(Box<float>& box, float share) { box.high[1] -= share * (box.high[1] - box.low[1]); }

ModelBounds too_small(std::initializer_list<std::pair<std::size_t, float>> shares) {
  ModelBounds some = bounds();
  for (const auto& [part, share] : shares) lower(bound_of(some, part).box, share);
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
  t.example("the ways of sampling take 30 and 60 times a second, and the keys", {}, [] {
    const auto count_of = [](const std::string& name) {
      const auto& ways = sampling_ways();
      return sampled_times(*std::find_if(ways.begin(), ways.end(), [&](const SamplingWay& way) { return way.name == name; }),
                           {0, 0.25, 1})
          .size();
    };
    return sampling_ways().size() == 3 && count_of("keys") == 3 && count_of("30 Hz") == 31 && count_of("60 Hz") == 61;
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
        const ModelBounds some = too_small({{part, share}});
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
}

void whoever_gets_out_is_found(Suite& t) {
  t.example("of clusters that get out the worst one is kept, whichever comes first", {}, [] {
    constexpr std::size_t one = 4, other = 8;
    const auto by_alone = [](std::size_t part, float share) {
      return of_bounds(checked(too_small({{part, share}}))).of_cluster.by;
    };
    for (const auto& [share, of_other] : {std::pair(0.05F, 0.3F), std::pair(0.3F, 0.05F)}) {
      const ClipMisses both = of_bounds(checked(too_small({{one, share}, {other, of_other}})));
      const double by = by_alone(one, share), by_other = by_alone(other, of_other);
      if (by == by_other || both.clusters != 2 || both.of_cluster.by != std::max(by, by_other)) return false;
      if (both.worst_cluster != static_cast<int>(by > by_other ? one : other) - 1) return false;
    }
    return true;
  });
  t.example("who gets out of a ball is found as well as who gets out of a box, and only our bounds have balls", {}, [] {
    const ClipResult good = checked(bounds());
    for (const std::size_t part : {0, 1}) {
      ModelBounds some = bounds();
      bound_of(some, part).ball.radius = 0;
      const ClipResult result = checked(some);
      const ClipMisses& ours = of_bounds(result);
      if ((ours.of_whole.vertex >= 0) != (part == 0) || ours.clusters != (part == 0 ? 0 : 1)) return false;
      for (std::size_t way = 1; way < result.misses.size(); ++way)
        if (result.misses[way].clusters != good.misses[way].clusters) return false;
    }
    return true;
  });
  t.example("every vertex of every part is compared at every time", {}, [] {
    long vertices = 0;
    for (const std::size_t p : compared_parts(bounds())) vertices += static_cast<long>(bounds().parts[p].vertices.size());
    const auto places = [](int times) {
      return check_clip(man(), sets(), bounds(), 0, {.random_times = times, .halvings = 0, .exact_checks = 0}).places;
    };
    return places(60) - places(20) == 40 * vertices && places(20) >= 20 * vertices && checked(bounds()).places > places(60);
  });
}

void crossfades_are_compared_with_what_is_seen(Suite& t) {
  t.example("what gets out of the bounds of a crossfade is counted, and they are compared with what is seen", {}, [] {
    Model model = man();
    model.clips = {model.clips[0], model.clips[0]};
    ModelBounds some = bound_model(model, {.cluster_triangles = 512, .crossfades = true});
    const CrossfadeSettings settings{.times = 9, .weights = 3};
    const CrossfadeResult good = check_crossfade(model, sets(), some, 0, settings);
    const std::size_t cluster = compared_parts(some)[1];
    for (const std::size_t p : {std::size_t{0}, cluster}) lower(some.crossfades[0].parts[p].box, 0.5F);
    const CrossfadeResult bad = check_crossfade(model, sets(), some, 0, settings);
    // All places but the center are outside of a ball without a radius.
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
  t.example("the parts that leave the bounds of both clips are counted, which none does while either clip plays alone", {}, [] {
    Model model = man();
    model.clips = {model.clips[0], model.clips[0]};
    ModelBounds some = bound_model(model, {.cluster_triangles = 512, .crossfades = true});
    const CrossfadeSettings alone{.times = 9, .weights = 2};  // The weights are 0 and 1.
    const long of_good = check_crossfade(model, sets(), some, 0, alone).out_of_both_clips;
    // All vertices but the lowest are above a box without height.
    for (BoundedClip& clip : some.clips)
      for (BoundedPart& part : clip.parts) lower(part.box, 1);
    const CrossfadeResult flat = check_crossfade(model, sets(), some, 0, alone);
    return of_good == 0 && flat.out_of_both_clips == flat.clusters + 1 && flat.clusters > 3 && flat.outside == 0;
  });
}

// Counts the rows of a result file that have these cells one after another.
long rows_with(const std::string& text, const std::string& cells) {
  long count = 0;
  for (std::size_t at = text.find(cells); at != std::string::npos; at = text.find(cells, at + 1)) ++count;
  return count;
}

void results_are_written(Suite& t) {
  t.example("the results of a model are of all ways of skinning and of its clusters, and rows have each number of them", {}, [] {
    const Model model = keyed(make_man(1034), 10);
    const std::vector<ModelPart> parts = parts_of(model, ModelBoundsOptions{}.cluster_triangles);
    const long clusters =
        std::count_if(parts.begin(), parts.end(), [](const ModelPart& part) { return part.kind == PartKind::cluster; });
    const OverTimeSettings settings{.random_times = 10, .halvings = 1, .exact_checks = 2, .clips = 1};
    const std::vector<OverTimeResult> results = run_over_time(model, settings);
    const TemporaryFolder folder;
    write_over_time(results, settings, folder.file("over_time.csv"));
    const std::string text = read_whole(folder.file("over_time.csv"));
    if (results.size() != 3 || clusters < 3) return false;
    for (const OverTimeResult& r : results) {
      const std::string skinning = table_name_of(r.skinning);
      const auto has = [&](const std::string& clip, const std::string& way, const std::string& quantity, double value,
                           const std::string& unit = "1") {
        return rows_with(text, "," + clip + "," + way + ",all," + quantity + "," + format_number(value) + "," + unit + "," +
                                   skinning + ",") == 1;
      };
      if (r.clusters != clusters || r.triangles != static_cast<long>(model.triangles.size())) return false;
      if (r.clips.size() + r.refused.size() != 1) return false;
      if (!has("all", "bounds", "clusters", static_cast<double>(clusters)) ||
          !has("all", "bounds", "refused_clips", static_cast<double>(r.refused.size())))
        return false;
      for (const ClipResult& c : r.clips) {
        for (const auto& [quantity, value] :
             {std::pair("checks", c.places), std::pair("close_times", c.close_times), std::pair("exact_checks", c.exact_checks),
              std::pair("flat_clusters", c.flat_clusters)})
          if (!has(c.clip, "bounds", quantity, static_cast<double>(value))) return false;
        if (!has(c.clip, "bounds", "character_volume_ratio", c.whole_ratio) ||
            !has(c.clip, "bounds", "mean_cluster_volume_ratio", c.cluster_ratio))
          return false;
        for (const ClipMisses& m : c.misses)
          if (!has(c.clip, m.way, "character_misses", m.of_whole.vertex >= 0) ||
              !has(c.clip, m.way, "character_miss_distance_over_box_side", m.of_whole.by) ||
              !has(c.clip, m.way, "cluster_misses", static_cast<double>(m.clusters)) ||
              !has(c.clip, m.way, "cluster_miss_distance_over_box_side", m.of_cluster.by))
            return false;
      }
    }
    return results[0].clips.size() == 1;
  });
}

}  // namespace

PROPTEST(over_time_experiment) {
  clips_repeated_and_sampled(t);
  bounds_are_compared_with_what_is_seen(t);
  whoever_gets_out_is_found(t);
  crossfades_are_compared_with_what_is_seen(t);
  results_are_written(t);
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
