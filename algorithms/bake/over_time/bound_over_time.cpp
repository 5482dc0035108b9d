// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/bake/over_time/bound_over_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/packs/float_above.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/c6_interval_hull.hpp"

namespace refitlab {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The shortest side counts as no shorter than this share of the longest one, since a flat box has no volume to be kept.
constexpr double flattest_side = 0.02;

// Cells are halved in each parameter at most this many times. Cells of which nothing is known are halved fewer times.
constexpr int most_halvings = 24, most_blind_halvings = 10;

// Values are the greatest values of convex functions, by function. A function changes by no more than its scale times the
// distance. The functions are (n, x) and (-n, x) for each direction n, or the distance from a point.
using Values = std::vector<double>;

// Functions has the functions that are bounded, their scales, and how far above the greatest value seen a bound may be.
class Functions {
 public:
  virtual ~Functions() = default;
  // Returns the greatest values over balls. beyond has their radii, or is empty if they are points.
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

// A Search bounds the Values over all cells.
class Search {
 public:
  Search(std::span<const MovingJoints* const> joints, const MovingVertices& vertices, Functions& functions,
         std::size_t most_halvings)
      : joints_(joints),
        halvings_left_(most_halvings),
        vertices_(vertices),
        functions_(functions),
        seen_(functions.scales().size(), -infinity),
        bound_(functions.scales().size(), -infinity) {}

  void run() {
    for (std::size_t of = 0; of < joints_.size(); ++of) {
      known_.clear();
      for (const ParameterBox& box : joints_[of]->boxes())
        open(cell(*joints_[of], box, std::vector<int>(box.ranges.size(), 0), vertices_.placing_error(joints_[of]->cell(box))));
      look_into(*joints_[of]);
    }
  }

  const Values& bound() const { return bound_; }
  int moments() const { return moments_; }
  std::vector<ProvenInterval> intervals() const {
    std::vector<ProvenInterval> ordered = intervals_;
    std::sort(ordered.begin(), ordered.end(), [](const ProvenInterval& a, const ProvenInterval& b) {
      return std::pair(a.start, a.end) < std::pair(b.start, b.end);
    });
    return ordered;
  }
  double gap() const {
    double gap = 0;
    for (std::size_t i = 0; i < bound_.size(); ++i) gap = std::max(gap, (bound_[i] - seen_[i]) / functions_.scales()[i]);
    return gap;
  }

 private:
  struct Cell {
    ParameterBox box;
    std::vector<int> halvings;  // by parameter
    double error, chord;
    std::vector<double> chords;  // by parameter
    Values at_corners;           // the greatest of all corners
    double excess = 0;           // by how much of the tolerance it reaches beyond what was seen when it was opened
    bool operator<(const Cell& other) const { return excess < other.excess; }
  };

  Cell cell(const MovingJoints& joints, const ParameterBox& box, const std::vector<int>& halvings, double error,
            Finite finite = Finite::may_be) {
    const JointCell where = joints.cell(box);
    const CellSlack slack = vertices_.slack(where, finite);
    Cell out{box, halvings, error, slack.chord, slack.chords, Values(functions_.scales().size(), -infinity)};
    for (const ParameterMoment& corner : where.corners) raise(out.at_corners, values_at(joints, corner, slack));
    return out;
  }

  // Records the values that vertices reach at a moment. Returns the values that the followed points allow them to reach.
  Values values_at(const MovingJoints& joints, const ParameterMoment& moment, const CellSlack& slack) {
    const bool is_shared = slack.followed == Followed::skinned;
    if (is_shared)
      if (const auto found = known_.find(moment); found != known_.end()) return found->second;
    const auto posed = joints.at(moment);
    vertices_.place(*posed, slack.followed, points_);
    ++moments_;
    Values values = functions_.greatest(points_, slack.beyond);
    if (is_shared) {
      known_.emplace(moment, values);
      raise(seen_, values);
    } else {
      vertices_.place(*posed, Followed::skinned, points_);
      raise(seen_, functions_.greatest(points_, {}));
    }
    return values;
  }

  void open(Cell cell) {
    cell.excess = excess_of(cell);
    open_.push_back(std::move(cell));
    std::push_heap(open_.begin(), open_.end());
  }

  // Takes the cells that reach farthest first, so that the greatest values are seen early.
  void look_into(const MovingJoints& joints) {
    while (!open_.empty()) {
      std::pop_heap(open_.begin(), open_.end());
      Cell now = std::move(open_.back());
      open_.pop_back();
      // More has been seen since the cell was opened.
      if (const double excess = excess_of(now); !open_.empty() && excess < now.excess && excess < open_.front().excess) {
        open(std::move(now));
        continue;
      }
      const std::vector<ParameterBox> halves = halvings_left_ > 0 && is_worth_halving(now) ? halves_of(joints, now) : none_;
      for (const ParameterBox& half : halves) open(cell(joints, half, now.halvings, now.error));
      if (!halves.empty()) --halvings_left_;
      else if (now.chord < infinity) accept(now);
      else accept(cell(joints, now.box, now.halvings, now.error, Finite::must_be));
    }
  }

  void accept(const Cell& cell) {
    raise(bound_, above(cell));
    if (const auto& ranges = cell.box.ranges; ranges.size() == 1)
      intervals_.push_back({ranges[0].start, ranges[0].end, cell.chord});
  }

  // Halves a cell in the parameter that adds most to the slack, of those that can be halved.
  std::vector<ParameterBox> halves_of(const MovingJoints& joints, Cell& cell) const {
    std::vector<std::size_t> order(cell.chords.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cell.chords[a] > cell.chords[b]; });
    for (const std::size_t parameter : order) {
      if (cell.halvings[parameter] >= (cell.chord < infinity ? most_halvings : most_blind_halvings)) continue;
      std::vector<ParameterBox> halves = joints.halves(cell.box, parameter, cell.chords[parameter] < infinity);
      if (halves.empty()) continue;
      // Cells that hold several parts of a clip are known from part to part.
      const ParameterRange& range = cell.box.ranges[parameter];
      if (range.first_part == range.last_part) ++cell.halvings[parameter];
      return halves;
    }
    return {};
  }

  Values above(const Cell& cell) const {
    Values above = cell.at_corners;
    for (std::size_t i = 0; i < above.size(); ++i)
      above[i] = greatest_over_interval(above[i], functions_.scales()[i], cell.chord + cell.error);
    return above;
  }

  double excess_of(const Cell& cell) const {
    const Values reached = above(cell), tolerances = functions_.tolerances(seen_);
    double most = -infinity;
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (const double excess = (reached[i] - seen_[i]) / tolerances[i]; !(excess <= most)) most = excess;
    return most >= 0 ? most : most < 0 ? 0 : infinity;
  }

  // Returns whether some value is beyond its tolerance, and halving would lower it by more than rounding.
  bool is_worth_halving(const Cell& cell) const {
    const Values reached = above(cell), tolerances = functions_.tolerances(seen_);
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (reached[i] > std::max(bound_[i], seen_[i] + tolerances[i]) &&
          functions_.scales()[i] * cell.chord > std::max(tolerances[i] / 2, functions_.scales()[i] * cell.error))
        return true;
    return false;
  }

  std::span<const MovingJoints* const> joints_;
  std::size_t halvings_left_;
  const MovingVertices& vertices_;
  Functions& functions_;
  std::vector<Point3> points_;
  Values seen_, bound_;
  std::vector<ProvenInterval> intervals_;
  std::map<ParameterMoment, Values> known_;
  std::vector<Cell> open_;  // a heap
  const std::vector<ParameterBox> none_;
  int moments_ = 0;
};

// Returns the center of a ball around all points that is hardly larger than the smallest one. It is the center of the smallest
// ball around a few of them. The point that is farthest out is added to these until none is far out [Badoiu and Clarkson 2003,
// "Smaller core-sets for balls"].
Point3 near_center(std::span<const Point3> points) {
  constexpr double enough = 1.001;
  constexpr int most_steps = 64;
  std::vector<Point3> core = {points[0]};
  for (int step = 0;; ++step) {
    const SmallestBall<double, 3> ball = smallest_ball<double, 3>(core);
    const Point3* farthest = &points[0];
    for (const Point3& p : points)
      if (squared_distance(*farthest, ball.center) < squared_distance(p, ball.center)) farthest = &p;
    if (step == most_steps || squared_distance(*farthest, ball.center) <= enough * enough * ball.squared_radius)
      return ball.center;
    core.push_back(*farthest);
  }
}

void check_directions(std::span<const Point3> directions) {
  const bool are_in_range = std::all_of(directions.begin(), directions.end(),
                                        [](const Point3& n) { return n.stableNorm() >= 1e-100 && n.stableNorm() <= 1e100; });
  if (directions.empty() || !are_in_range)
    throw std::invalid_argument("bound_over_time: there is no direction, or one whose length is not from 1e-100 to 1e100");
}

}  // namespace

BoundOverTime bound_over_time(const MovingJoints& joints, const MovingVertices& vertices, const OverTimeOptions& options) {
  const MovingJoints* const one[] = {&joints};
  return bound_over_time(one, vertices, options);
}

BoundOverTime bound_over_time(std::span<const MovingJoints* const> joints, const MovingVertices& vertices,
                              const OverTimeOptions& options) {
  const DefaultFloatEnvironment environment;
  if (!(options.tolerance > 0)) throw std::invalid_argument("bound_over_time: the tolerance is not positive");
  check_directions(options.directions);
  BoundOverTime out;
  for (const MovingJoints* of : joints)
    for (const ParameterBox& box : of->boxes()) out.errors.merge(vertices.error_growth(of->cell(box)));
  DirectionFunctions directions(options.directions, options.tolerance);
  Search slabs(joints, vertices, directions, options.most_halvings);
  slabs.run();
  for (std::size_t d = 0; d < options.directions.size(); ++d)
    out.slabs.push_back({-slabs.bound()[2 * d + 1], slabs.bound()[2 * d]});
  out.slab_intervals = slabs.intervals(), out.moments = slabs.moments(), out.gap = slabs.gap();

  const Point3 center = near_center(directions.extremes);
  DistanceFunction distance(center, options.tolerance);
  Search radius(joints, vertices, distance, options.most_halvings);
  radius.run();
  out.ball = {center, radius.bound()[0]}, out.ball_intervals = radius.intervals();
  out.moments += radius.moments();
  return out;
}

Box<double> box_of(std::span<const Slab<double>> slabs) {
  return {{slabs[0].low, slabs[1].low, slabs[2].low}, {slabs[0].high, slabs[1].high, slabs[2].high}};
}

Box<float> rounded_outward(const Box<double>& box) {
  const DefaultFloatEnvironment environment;
  Box<float> out;
  for (int i = 0; i < 3; ++i) out.low[i] = float_below(box.low[i]), out.high[i] = float_above(box.high[i]);
  return out;
}

}  // namespace refitlab
