// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of animated models that hold at every time.
#include "algorithms/bake/over_time/bound_over_time.hpp"

#include <random>

#include "proptests/gen/animated_model.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace proptests::suite_bound_over_time {
namespace {

using namespace refitlab;
using M = MultiprecisionInterval;

// Where a vertex is at a moment, and how far that is along a direction or from a point: what a bound bounds.
struct Extreme {
  double value = -std::numeric_limits<double>::infinity(), time = 0;
  int vertex = 0;
};

class Scene {
 public:
  Scene(const Model& model, Skinning skinning, std::vector<Point3> directions)
      : animation_(model.clips[0].animation),
        sets_(model),
        joints_(model, animation_, skinning != Skinning::linear),
        vertices_(joints_, sets_, skinning, all_vertices(model)),
        directions_(std::move(directions)),
        quick_(model, animation_, skinning),
        sure_(model, animation_, skinning) {}

  static std::vector<int> all_vertices(const Model& model) {
    std::vector<int> all(model.vertices.size());
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
    return all;
  }

  const AnimatedJoints& joints() const { return joints_; }
  const MovingVertices& vertices() const { return vertices_; }
  BoundOverTime bound(double tolerance) const { return bound_over_time(joints_, vertices_, {tolerance, directions_, true}); }

  // Whether all vertices are in slabs and ball at a moment, as intervals say; undecided where the moment is ambiguous.
  Verdict holds(const BoundOverTime& bound, double time, Side side) {
    Verdict v = Verdict::holds;
    try {
      sure_.pose(time, side);
      for (const int i : vertices_.vertices()) v &= holds(bound, sure_.vertex(i));
    } catch (const oracle::Ambiguous&) {
      return Verdict::undecided;
    }
    return v;
  }

  // The greatest values of (n, x) and (-n, x) for each direction, and of the distance from a point: among this many moments, each
  // then followed uphill.
  std::vector<Extreme> extremes(const Point3& center, int moments) {
    std::vector<Extreme> found(2 * directions_.size() + 1);
    const auto& times = joints_.times();
    const double duration = animation_.duration;
    for (int i = 0; i <= moments; ++i) {
      const double time = std::min(duration, duration * i / moments);
      if (!pose(time)) continue;
      for (const int v : vertices_.vertices())
        if (const auto x = place(v))
          for (std::size_t f = 0; f < found.size(); ++f)
            if (const double value = value_of(f, *x, center); value > found[f].value) found[f] = {value, time, v};
    }
    for (std::size_t f = 0; f < found.size(); ++f) {
      // Within the part of the animation, which is smooth.
      const auto after = std::upper_bound(times.begin(), times.end(), found[f].time);
      const double step = duration / moments, end = after == times.end() ? duration : std::nextafter(*after, 0.0),
                   start = after == times.begin() ? 0 : *(after - 1);
      double low = std::max(start, found[f].time - step), high = std::min(end, found[f].time + step);
      for (int i = 0; i < 24 && low < high; ++i) {
        const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
        const double at_a = value_at(f, a, found[f].vertex, center), at_b = value_at(f, b, found[f].vertex, center);
        if (at_a > found[f].value) found[f].value = at_a, found[f].time = a;
        if (at_b > found[f].value) found[f].value = at_b, found[f].time = b;
        if (at_a > at_b) high = b;
        else low = a;
      }
    }
    return found;
  }

 private:
  bool pose(double time) {
    try {
      quick_.pose(time, Side::after);
      return true;
    } catch (const oracle::Ambiguous&) {
      return false;
    }
  }
  std::optional<Point3> place(int v) {
    try {
      return quick_.vertex(v);
    } catch (const oracle::Ambiguous&) {
      return std::nullopt;
    }
  }
  double value_of(std::size_t f, const Point3& x, const Point3& center) const {
    if (f == 2 * directions_.size()) return (x - center).norm();
    return directions_[f / 2].dot(x) * (f % 2 == 0 ? 1 : -1);
  }
  double value_at(std::size_t f, double time, int v, const Point3& center) {
    if (!pose(time)) return -std::numeric_limits<double>::infinity();
    const auto x = place(v);
    return x ? value_of(f, *x, center) : -std::numeric_limits<double>::infinity();
  }

  Verdict holds(const BoundOverTime& bound, const Vec<M, 3>& x) const {
    Verdict v = Verdict::holds;
    M squared(0);
    for (int i = 0; i < 3; ++i) squared += sq(M(x[i] - M(bound.ball.center[i])));
    v &= less_equal(squared, sq(M(bound.ball.radius)));
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      M along(0);
      for (int i = 0; i < 3; ++i) along += M(directions_[d][i]) * x[i];
      v &= less_equal(M(bound.slabs[d].low), along) & less_equal(along, M(bound.slabs[d].high));
    }
    return v;
  }

  const Animation& animation_;
  JointSets sets_;
  AnimatedJoints joints_;
  MovingVertices vertices_;
  std::vector<Point3> directions_;
  oracle::AnimatedSkin<double> quick_;
  oracle::AnimatedSkin<M> sure_;
};

std::vector<Point3> some_directions(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Point3> out = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()};
  for (const double length : {1.0, 1e-3, 1e4}) out.push_back(length * Point3(normal(random), normal(random), normal(random)));
  return out;
}

bool is_refusal(const std::string& message) {
  for (const char* reason : {"passes through zero", "their blend may vanish", "the skin matrix"})
    if (message.find(reason) != std::string::npos) return true;
  return false;
}

void tag_channels(const Animation& animation) {
  std::map<std::string, bool> seen;
  for (const NodeTrack& track : animation.tracks) {
    const auto look = [&](const auto& channel, const std::string& name) {
      if (channel.keys.size() > 1)
        seen[std::array{"steps", "lines", "splines"}[static_cast<int>(channel.interpolation)] + (" of " + name)] = true;
    };
    look(track.positions, "positions"), look(track.rotations, "rotations"), look(track.scales, "scales");
  }
  for (const auto& [tag, is_seen] : seen) RC_TAG(tag);
}

void never_missed(const gen::AnimatedPlan& plan, Skinning skinning) {
  const Model model = gen::animated_model(plan);
  const Animation& animation = model.clips[0].animation;
  std::mt19937 random(plan.seed + 1);
  const double tolerance = std::array{0.01, 0.01, 0.3, 1e6}[random() % 4];
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  std::optional<Scene> scene;
  BoundOverTime bound;
  try {
    scene.emplace(model, skinning, some_directions(random));
    bound = scene->bound(tolerance);
  } catch (const ModelError& e) {
    RC_ASSERT(is_refusal(e.what()));
    RC_TAG("refused");
    return;
  }
  RC_TAG("bounded");
  tag_channels(animation);
  for (const Slab<double>& slab : bound.slabs) RC_ASSERT(std::isfinite(slab.low) && std::isfinite(slab.high));
  RC_ASSERT(std::isfinite(bound.ball.radius));
  std::vector<std::pair<double, Side>> moments = {{0, Side::after}, {animation.duration, Side::after}};
  const auto& times = scene->joints().times();
  const std::size_t step = 1 + times.size() / 12;
  bool jumps = false;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_jump = jumps_at(animation, times[i]);
    jumps = jumps || is_jump;
    if (i % step != 0 && !is_jump) continue;
    moments.emplace_back(times[i], Side::after);
    if (times[i] > 0) moments.emplace_back(times[i], Side::before);
    if (i > 0) moments.emplace_back(std::nextafter(times[i], 0.0), Side::after);
  }
  RC_CLASSIFY(jumps, "jumps");
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 4; ++i) moments.emplace_back(animation.duration * share(random), Side::after);
  if (animation.duration > 0)
    for (const Extreme& extreme : scene->extremes(bound.ball.center, 40)) moments.emplace_back(extreme.time, Side::after);
  int undecided = 0;
  for (const auto& [time, side] : moments) {
    const Verdict v = scene->holds(bound, time, side);
    if (v == Verdict::fails) RC_LOG() << "time " << time << (side == Side::after ? " after" : " before") << '\n';
    RC_ASSERT(v != Verdict::fails);
    undecided += v == Verdict::undecided;
  }
  RC_CLASSIFY(undecided > 0, "some moment undecided");
  RC_CLASSIFY(2 * undecided > static_cast<int>(moments.size()), "most moments undecided");
}

PROPTEST(bound_over_time) {
  t.holds("no vertex that is skinned linearly is ever outside of slabs and ball",
          {.form = "beyond", .number_type = "double", .cases = 250, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(false);
            RC_LOG() << [&] {
              std::ostringstream s;
              gen::showValue(plan, s);
              return s.str();
            }() << '\n';
            never_missed(plan, Skinning::linear);
          });
  t.holds("no vertex that is skinned by dual quaternions is ever outside of slabs and ball",
          {.form = "beyond", .number_type = "double", .cases = 250, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(true);
            RC_LOG() << [&] {
              std::ostringstream s;
              gen::showValue(plan, s);
              return s.str();
            }() << '\n';
            never_missed(plan, Skinning::dual_quaternion);
          });
  t.holds("no vertex that is skinned spherically is ever outside of slabs and ball",
          {.form = "beyond", .number_type = "double", .cases = 150, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(true);
            RC_LOG() << [&] {
              std::ostringstream s;
              gen::showValue(plan, s);
              return s.str();
            }() << '\n';
            never_missed(plan, Skinning::spherical);
          });
}

}  // namespace
}  // namespace proptests::suite_bound_over_time
