// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/bound_over_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The shortest side counts as no shorter than this share of the longest one: what is flat has no volume to be kept.
constexpr double flattest_side = 0.02;

// Intervals are halved this many times at most; those of which nothing is known, fewer times.
constexpr int most_halvings = 24, most_blind_halvings = 10;

// After so many intervals none is halved any more: what hardly has a size would be looked at for ever.
constexpr int most_intervals = 1 << 13;

// The greatest values of convex functions that change by no more than their scale times the distance: (n, x) and (-n, x) for each
// direction n, or the distance from a point. By function.
using Values = std::vector<double>;

// What is bounded: the functions, their scales, and how far above the greatest value seen a bound may be.
class Functions {
 public:
  virtual ~Functions() = default;
  // Over balls: beyond has their radii, or is empty where they are points.
  virtual Values greatest(std::span<const Point3> points, std::span<const double> beyond) = 0;
  virtual const Values& scales() const = 0;
  virtual Values tolerances(const Values& seen) const = 0;
};

class DirectionFunctions : public Functions {
 public:
  DirectionFunctions(const std::vector<Point3>& directions, double tolerance) : directions_(directions), tolerance_(tolerance) {
    for (const Point3& n : directions) scales_.insert(scales_.end(), 2, norm<double, 3>(n));
  }
  Values greatest(std::span<const Point3> points, std::span<const double> beyond) override {
    Values values(scales_.size(), -infinity);
    std::vector<const Point3*> farthest(scales_.size(), nullptr);
    for (std::size_t d = 0; d < directions_.size(); ++d)
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double along = dot(directions_[d], points[i]), more = beyond.empty() ? 0 : beyond[i] * scales_[2 * d];
        if (values[2 * d] < along + more) values[2 * d] = along + more, farthest[2 * d] = &points[i];
        if (values[2 * d + 1] < more - along) values[2 * d + 1] = more - along, farthest[2 * d + 1] = &points[i];
      }
    for (const Point3* p : farthest)
      if (p) extremes.push_back(*p);
    return values;
  }
  const Values& scales() const override { return scales_; }
  Values tolerances(const Values& seen) const override {
    double longest = 0;
    for (std::size_t d = 0; d < directions_.size(); ++d) longest = std::max(longest, side(seen, d));
    Values out;
    for (std::size_t d = 0; d < directions_.size(); ++d)
      out.insert(out.end(), 2, scales_[2 * d] * tolerance_ / 6 * std::max(side(seen, d), flattest_side * longest));
    return out;
  }

  std::vector<Point3> extremes;  // points with greatest values, at all moments

 private:
  double side(const Values& seen, std::size_t d) const { return (seen[2 * d] + seen[2 * d + 1]) / scales_[2 * d]; }

  const std::vector<Point3>& directions_;
  double tolerance_;
  Values scales_;
};

class DistanceFunction : public Functions {
 public:
  DistanceFunction(const Point3& center, double tolerance) : center_(center), tolerance_(tolerance) {}
  Values greatest(std::span<const Point3> points, std::span<const double> beyond) override {
    double greatest = 0;
    if (beyond.empty()) {
      for (const Point3& p : points) greatest = std::max(greatest, squared_distance(p, center_));
      return {std::sqrt(greatest)};
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      greatest = std::max(greatest, std::sqrt(squared_distance(points[i], center_)) + beyond[i]);
    return {greatest};
  }
  const Values& scales() const override { return scales_; }
  Values tolerances(const Values& seen) const override { return {seen[0] * tolerance_ / 3}; }

 private:
  Point3 center_;
  double tolerance_;
  Values scales_ = {1};
};

void raise(Values& values, const Values& to) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::max(values[i], to[i]);
}

// Of Values, over an animation.
class Search {
 public:
  Search(const AnimatedJoints& joints, const MovingVertices& vertices, Functions& functions)
      : joints_(joints),
        vertices_(vertices),
        functions_(functions),
        seen_(functions.scales().size(), -infinity),
        bound_(functions.scales().size(), -infinity) {}

  void run() {
    const std::vector<double>& times = joints_.times();
    // What the parts' ends show is known before any part is looked into.
    std::vector<Interval> parts;
    for (int part = 0; part < joints_.part_count(); ++part)
      parts.push_back(interval(part, times[part], times[part + 1], 0, vertices_.placing_error(part),
                               vertices_.slack(part, times[part], times[part + 1], false)));
    for (const Interval& part : parts) look_into(part);
  }

  const Values& bound() const { return bound_; }
  int moments() const { return moments_; }
  double gap() const {
    double gap = 0;
    for (std::size_t i = 0; i < bound_.size(); ++i) gap = std::max(gap, (bound_[i] - seen_[i]) / functions_.scales()[i]);
    return gap;
  }

 private:
  struct Interval {
    int part;
    double start, end;
    int halvings;
    double error, chord;
    Values at_ends;  // the greatest of both ends
  };

  Interval interval(int part, double start, double end, int halvings, double error, const IntervalSlack& slack) {
    Interval out{part, start, end, halvings, error, slack.chord, values_at(start, Side::after, slack)};
    raise(out.at_ends, values_at(end, side_of_end(start, end), slack));
    return out;
  }

  // What is seen is what vertices reach; what is returned, what the curves that are followed allow them to.
  Values values_at(double time, Side side, const IntervalSlack& slack) {
    side = joints_.side_of(time, side);
    const bool is_shared = slack.followed == Followed::skinned;
    if (is_shared)
      if (const auto found = known_.find({time, side}); found != known_.end()) return found->second;
    vertices_.place(time, side, slack.followed, points_);
    ++moments_;
    Values values = functions_.greatest(points_, slack.beyond);
    if (is_shared) {
      known_.emplace(std::pair{time, side}, values);
      raise(seen_, values);
    } else {
      vertices_.place(time, side, Followed::skinned, points_);
      raise(seen_, functions_.greatest(points_, {}));
    }
    return values;
  }

  void look_into(const Interval& whole) {
    std::vector<Interval> open = {whole};
    while (!open.empty()) {
      const Interval now = std::move(open.back());
      open.pop_back();
      const bool is_known = now.chord < infinity;
      const double middle = now.start + (now.end - now.start) / 2;
      const bool can_halve =
          now.halvings < (is_known ? most_halvings : most_blind_halvings) && now.start < middle && middle < now.end;
      if (can_halve && intervals_ < most_intervals && is_worth_halving(now)) {
        intervals_ += 2;
        for (const auto& [start, end] : {std::pair{now.start, middle}, {middle, now.end}})
          open.push_back(
              interval(now.part, start, end, now.halvings + 1, now.error, vertices_.slack(now.part, start, end, false)));
      } else if (is_known) {
        raise(bound_, above(now));
      } else {
        raise(bound_,
              above(interval(now.part, now.start, now.end, 0, now.error, vertices_.slack(now.part, now.start, now.end, true))));
      }
    }
  }

  Values above(const Interval& interval) const {
    Values above = interval.at_ends;
    for (std::size_t i = 0; i < above.size(); ++i) above[i] += functions_.scales()[i] * (interval.chord + interval.error);
    return above;
  }

  // Whether some value is beyond what may be, and halving would lower it by more than rounding matters.
  bool is_worth_halving(const Interval& interval) const {
    const Values reached = above(interval), tolerances = functions_.tolerances(seen_);
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (reached[i] > std::max(bound_[i], seen_[i] + tolerances[i]) &&
          functions_.scales()[i] * interval.chord > std::max(tolerances[i] / 2, functions_.scales()[i] * interval.error))
        return true;
    return false;
  }

  const AnimatedJoints& joints_;
  const MovingVertices& vertices_;
  Functions& functions_;
  std::vector<Point3> points_;
  Values seen_, bound_;
  std::map<std::pair<double, Side>, Values> known_;
  int moments_ = 0, intervals_ = 0;
};

float float_below(double x) { return -float_above(-x); }

}  // namespace

BoundOverTime bound_over_time(const AnimatedJoints& joints, const MovingVertices& vertices, const OverTimeOptions& options) {
  const DefaultFloatEnvironment environment;
  if (!(options.tolerance > 0)) throw std::invalid_argument("bound_over_time: the tolerance is not positive");
  BoundOverTime out;
  DirectionFunctions directions(options.directions, options.tolerance);
  Search slabs(joints, vertices, directions);
  slabs.run();
  for (std::size_t d = 0; d < options.directions.size(); ++d)
    out.slabs.push_back({-slabs.bound()[2 * d + 1], slabs.bound()[2 * d]});
  out.moments = slabs.moments(), out.gap = slabs.gap();
  if (!options.with_ball) return out;

  const Point3 center = smallest_ball<double, 3>(directions.extremes).center;
  DistanceFunction distance(center, options.tolerance);
  Search radius(joints, vertices, distance);
  radius.run();
  out.ball = {center, radius.bound()[0]};
  out.moments += radius.moments();
  return out;
}

Box<double> box_of(std::span<const Slab<double>> slabs) {
  return {{slabs[0].low, slabs[1].low, slabs[2].low}, {slabs[0].high, slabs[1].high, slabs[2].high}};
}

Box<float> rounded_outward(const Box<double>& box) {
  Box<float> out;
  for (int i = 0; i < 3; ++i) out.low[i] = float_below(box.low[i]), out.high[i] = float_above(box.high[i]);
  return out;
}

}  // namespace refitlab
