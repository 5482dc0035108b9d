// SPDX-License-Identifier: GPL-3.0-or-later
// Tests bounds of animated models that hold at every time.
#include "algorithms/bake/over_time/bound_over_time.hpp"

#include <random>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/any_pose.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace proptests::suite_bound_over_time {
namespace {

using namespace refitlab;
using M = MultiprecisionInterval;

// Says where a bound is attained: how far a vertex is along a direction, or from a point, at a moment.
struct Extreme {
  double value = -std::numeric_limits<double>::infinity(), time = 0;
  int vertex = 0;
};

class Scene {
 public:
  Scene(const Model& model, Skinning skinning, std::vector<Point3> directions, std::size_t clip = 0)
      : animation_(model.clips[clip].animation),
        sets_(model),
        joints_(model, animation_, skinning != Skinning::linear),
        vertices_(model, sets_, skinning, gen::all_of(model.vertices)),
        directions_(std::move(directions)),
        quick_(model, animation_, skinning),
        sure_(model, animation_, skinning) {}

  const AnimatedJoints& joints() const { return joints_; }
  const MovingVertices& vertices() const { return vertices_; }
  BoundOverTime bound(double tolerance, std::size_t most_halvings = 1 << 12) const {
    return bound_over_time(joints_, vertices_, {tolerance, directions_, most_halvings});
  }

  // Says whether all vertices are in slabs and ball at a moment, by intervals; undecided where the moment is ambiguous.
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

  // Returns the greatest values of (n, x) and (-n, x) for each direction, and of the distance from a point, among this many
  // moments, each then followed uphill.
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
      // The search stays within the part of the animation, which is smooth.
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
  if (!animation.weight_tracks.empty()) RC_TAG("morph targets");
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
    if (v == Verdict::fails) RC_LOG() << ", time " << time << (side == Side::after ? " after" : " before");
    RC_ASSERT(v != Verdict::fails);
    undecided += v == Verdict::undecided;
  }
  RC_CLASSIFY(undecided > 0, "some moment undecided");
  RC_CLASSIFY(2 * undecided > static_cast<int>(moments.size()), "most moments undecided");
}

// Makes one vertex at this distance from its joint, which turns from 45 degrees below the x axis to 45 degrees above.
Model swinging(double unit = 1, double duration = 1) {
  Model model;
  model.name = model.skeleton.file = "swinging";
  model.skeleton.nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
  model.skeleton.joints = {{"joint", 0, -1, Eigen::Matrix4d::Identity()}};
  model.joints = {{"joint", -1, Point3::Zero()}};
  model.vertices = {{unit, 0, 0}}, model.triangles = {{0, 0, 0}}, model.influences = {{{0, 1}}};
  const auto turned = [](double angle) { return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())); };
  const double eighth = 0.7853981633974483;
  const Animation animation{"clip",
                            duration,
                            {{0,
                              {{{0, Eigen::Vector3d::Zero()}}},
                              {{{0, turned(-eighth)}, {duration, turned(eighth)}}},
                              {{{0, Eigen::Vector3d::Ones()}}}}}};
  model.clips.push_back({"clip", duration, {}, animation});
  return model;
}

void bounds_hold_and_converge(Suite& t) {
  t.holds("no vertex that is skinned linearly is ever outside of slabs and ball",
          {.number_type = "double", .cases = 250, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(false);
            RC_LOG() << plan;
            never_missed(plan, Skinning::linear);
          });
  t.holds("no vertex that is skinned by dual quaternions is ever outside of slabs and ball",
          {.number_type = "double", .cases = 250, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(true);
            RC_LOG() << plan;
            never_missed(plan, Skinning::dual_quaternion);
          });
  t.holds("no vertex that is skinned spherically is ever outside of slabs and ball",
          {.number_type = "double", .cases = 150, .degenerate_at_least = 0.2, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(true);
            RC_LOG() << plan;
            never_missed(plan, Skinning::spherical);
          });
  t.holds(
      "the bounds converge: they are hardly more than what vertices reach, by linear and by dual quaternion skinning",
      {.number_type = "double", .cases = 60, .degenerate_at_most = 0.9, .tags_at_least = {{"compared", 0.4}}}, [] {
        const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::dual_quaternion);
        const auto plan = gen::draw_smooth_plan(skinning != Skinning::linear);
        RC_LOG() << plan << " skinning " << static_cast<int>(skinning);
        RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
        const Model model = gen::animated_model(plan);
        const double tolerance = 0.01;
        const std::vector<Point3> axes = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()};
        Scene scene(model, skinning, axes);
        const auto& times = scene.joints().times();
        // Where a sign may change, or a blend be short, only looser bounds are known.
        for (int part = 0; part < scene.joints().part_count(); ++part)
          for (int i = 0; i < 64; ++i) {
            const double step = (times[part + 1] - times[part]) / 64, start = times[part] + i * step;
            if (!std::isfinite(scene.vertices().slack(scene.joints().cell(part, start, start + step), Finite::may_be).chord))
              return;
          }
        RC_TAG("compared");
        // There are as many halvings as by default: a vertex may hardly move where its joints do, far from their origins.
        const BoundOverTime bound = scene.bound(tolerance, OverTimeOptions().most_halvings);
        const auto reached = scene.extremes(bound.ball.center, 400);
        double longest = 0, error = 0;
        for (int d = 0; d < 3; ++d) longest = std::max(longest, reached[2 * d].value + reached[2 * d + 1].value);
        for (int part = 0; part < scene.joints().part_count(); ++part)
          error = std::max(error, scene.vertices().placing_error(scene.joints().cell(part, times[part], times[part + 1])));
        // The sample is followed uphill from 400 moments. In smooth clips it misses the extremes by little.
        const double missed = 1e-3 * longest + 4 * error;
        double squared_diagonal = 0;
        for (int d = 0; d < 3; ++d) {
          const double side = reached[2 * d].value + reached[2 * d + 1].value;
          squared_diagonal += side * side;
          RC_ASSERT(bound.slabs[d].high - bound.slabs[d].low <= side + tolerance / 3 * std::max(side, 0.02 * longest) + missed);
        }
        RC_ASSERT(bound.ball.radius <= reached[6].value * (1 + tolerance / 3) + missed);
        // The ball is about the center of the smallest one, to which all points are as near as half of the box's diagonal.
        RC_ASSERT(bound.ball.radius <= 0.5 * std::sqrt(squared_diagonal) * (1 + tolerance) + missed);
        RC_ASSERT(bound.gap <= tolerance / 6 * longest * 1.01 + missed);
      });
}

// Checks both clips of a model, one after the other, in one bound.
void check_two_clips_together() {
  const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::dual_quaternion);
  const bool is_rigid = skinning != Skinning::linear;
  const auto plan = *rc::gen::arbitrary<bool>() ? gen::draw_smooth_plan(is_rigid) : gen::draw_animated_plan(is_rigid);
  RC_LOG() << plan << " skinning " << static_cast<int>(skinning);
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  Model model = gen::animated_model(plan);
  Animation second = gen::second_animation(plan, model);
  model.clips.push_back({"second", second.duration, {}, second});
  if (*rc::gen::arbitrary<bool>()) std::swap(model.clips[0], model.clips[1]);
  std::mt19937 random(plan.seed + 3);
  const std::vector<Point3> directions = some_directions(random);
  std::optional<Scene> scenes[2];
  BoundOverTime bound, own;
  try {
    for (const std::size_t clip : {0, 1}) scenes[clip].emplace(model, skinning, directions, clip);
    const MovingJoints* const joints[] = {&scenes[0]->joints(), &scenes[1]->joints()};
    bound = bound_over_time(joints, scenes[0]->vertices(), {0.1, directions, 1 << 10});
    own = scenes[0]->bound(0.1);
  } catch (const ModelError& e) {
    RC_ASSERT(is_refusal(e.what()));
    RC_TAG("refused");
    return;
  }
  bool goes_farther = false;
  std::uniform_real_distribution<double> share(0, 1);
  for (const std::size_t clip : {0, 1}) {
    const double duration = model.clips[clip].animation.duration;
    std::vector<double> times = {0, duration, duration * share(random), duration * share(random)};
    const auto& ends = scenes[clip]->joints().times();
    for (int i = 0; i < 4; ++i) times.push_back(ends[random() % ends.size()]);
    for (const double time : times) {
      RC_ASSERT(scenes[clip]->holds(bound, time, Side::after) != Verdict::fails);
      goes_farther = goes_farther || scenes[clip]->holds(own, time, Side::after) == Verdict::fails;
    }
  }
  RC_CLASSIFY(goes_farther, "the second clip goes farther");
}

void what_is_reached_between_keys_and_at_jumps(Suite& t) {
  t.example("keys alone miss what a slerp reaches between them, and so does a sample at a rate that jumps over it",
            {.hypothesis = "bounds are blown up by the slack"}, [] {
              const Model model = swinging();
              Scene scene(model, Skinning::linear, {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()});
              const BoundOverTime bound = scene.bound(1e6);
              std::vector<Point3> at_keys, points;
              for (const double time : {0.0, 1.0})
                for (const Point3& p :
                     (scene.vertices().place(*scene.joints().at(time, Side::after), Followed::skinned, points), points))
                  at_keys.push_back(p);
              double highest = -1;
              for (const Point3& p : at_keys) highest = std::max(highest, p[0]);
              // The vertex turns from 45 degrees below the x axis to 45 degrees above: half of the way there x is 1.
              scene.vertices().place(*scene.joints().at(0.5, Side::after), Followed::skinned, points);
              return std::abs(highest - std::sqrt(0.5)) < 1e-15 && std::abs(points[0][0] - 1) < 1e-15 &&
                     bound.slabs[0].high >= 1 && bound.moments < 20 && scene.holds(bound, 0.5, Side::after) == Verdict::holds;
            });
  t.example("what a step shows at the very end of a clip is bounded, and so is the one pose of a clip without duration", {}, [] {
    Model model = swinging();
    auto& animation = model.clips[0].animation;
    animation.tracks[0].positions = {{{0, Eigen::Vector3d::Zero()}, {1, Eigen::Vector3d(0, 0, 7)}}, Interpolation::step};
    Scene scene(model, Skinning::linear, {Point3::UnitZ()});
    const BoundOverTime bound = scene.bound(0.01);
    animation.duration = 0;
    Scene moment(model, Skinning::linear, {Point3::UnitX(), Point3::UnitZ()});
    const BoundOverTime now = moment.bound(0.01);
    return bound.slabs[0].high >= 7 && bound.slabs[0].high < 7.1 && bound.slabs[0].low > -0.1 &&
           scene.holds(bound, 1, Side::after) == Verdict::holds && now.slabs[1].high < 1e-9 &&
           std::abs(now.slabs[0].high - std::sqrt(0.5)) < 1e-9 && moment.holds(now, 0, Side::after) == Verdict::holds &&
           now.ball.radius < 1e-9;
  });
  t.example("keys as near to each other as double has times are bounded, and so are lengths of years", {}, [] {
    bool good = true;
    int count = 0;
    for (const double duration : {5e-324, 1e-300, 1e-200, 1e-160, 1e-9, 1e9, 1e150}) {
      Model model = swinging();
      auto& animation = model.clips[0].animation;
      animation.duration = animation.tracks[0].rotations.keys[1].time = duration;
      for (const Interpolation how : {Interpolation::linear, Interpolation::cubic}) {
        animation.tracks[0].positions = {{{0, Eigen::Vector3d::Zero()}, {duration, Eigen::Vector3d(1, 0, 0)}}, how, {}};
        const Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
        animation.tracks[0].positions.tangents = {{tangent, tangent}, {tangent, tangent}};
        Scene scene(model, Skinning::linear, {Point3::UnitX(), Point3::UnitY()});
        const BoundOverTime bound = scene.bound(0.01);
        good = good && bound.slabs[0].high >= std::sqrt(0.5) + 1 && bound.slabs[1].low <= -std::sqrt(0.5);
        for (const double share : {0.0, 0.25, 0.5, 0.7, 1.0})
          good = good && scene.holds(bound, share * duration, Side::after) == Verdict::holds, ++count;
      }
    }
    return Checked(good, count);
  });
}

// Makes a vertex at its joint, which moves from the origin along a cubic spline to this x and back.
Model there_and_back(double x, double duration) {
  Model model = swinging(0, duration);
  NodeTrack& track = model.clips[0].animation.tracks[0];
  const Eigen::Vector3d none = Eigen::Vector3d::Zero(), out = x * 4 / duration * Eigen::Vector3d::UnitX();
  track.positions = {{{0, none}, {duration, none}}, Interpolation::cubic, {{none, out}, {Eigen::Vector3d(-out), none}}};
  track.rotations = {{{0, Eigen::Quaterniond::Identity()}}};
  return model;
}

// Draws a power of ten whose exponent is between these.
double drawn_power(double low, double high) {
  const double share = *gen::between(0, 1000001) / 1e6;
  return std::pow(10.0, low + share * (high - low));
}

// Checks a clip in whose middle a vertex is farther along x than it is at the keys. Lengths and durations are such that squares
// of lengths, speeds or accelerations underflow or overflow.
void check_extremes_between_keys() {
  const bool turns = *rc::gen::arbitrary<bool>(), is_tiny = *rc::gen::arbitrary<bool>();
  const double unit = is_tiny ? drawn_power(-310, -140) : drawn_power(-140, 30);
  const double duration = *rc::gen::arbitrary<bool>() ? drawn_power(-4, 6) : drawn_power(-300, 150);
  // Tangents beyond the range of double are no input.
  if (!turns && !std::isfinite(unit * 4 / duration)) return;
  RC_TAG("bounded");
  RC_LOG() << (turns ? "turns" : "moves") << ", length " << unit << ", duration " << duration;
  RC_CLASSIFY(is_tiny, "degenerate");
  RC_CLASSIFY(turns, "turns");
  RC_CLASSIFY(std::abs(std::log10(unit / duration)) > 160, "the speed's square is out of range");
  const Model model = turns ? swinging(unit, duration) : there_and_back(unit, duration);
  const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::dual_quaternion, Skinning::spherical);
  const double along = *rc::gen::element(1.0, 1.0, 2e-100, 5e99);
  Scene scene(model, skinning, {along * Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()});
  const BoundOverTime bound = scene.bound(*rc::gen::element(0.01, 0.3, 1e6));
  // A number that underflows is off by the least one.
  RC_ASSERT(bound.slabs[0].high >= along * (unit * (1 - 1e-9)) - 0x1p-1074);
  // Where the speed overflows, a vertex may be anywhere about its joint.
  const double anywhere = 3 * unit * (1 + 1e-9) + 4 * underflow_of_distance<double>();
  RC_ASSERT(bound.slabs[0].high <= along * anywhere + 0x1p-1070);
  RC_ASSERT(bound.ball.radius <= anywhere);
  for (const double share : {0.0, 0.25, 0.5, 0.7, 1.0})
    RC_ASSERT(scene.holds(bound, share * duration, Side::after) != Verdict::fails);
  RC_ASSERT(scene.holds(bound, 0.5 * duration, Side::after) == Verdict::holds);
}

void lengths_and_durations_out_of_the_range_of_squares(Suite& t) {
  t.holds("what is reached strictly between the keys is bounded, whatever the lengths from 1e-310 and the durations to 1e150",
          {.number_type = "double",
           .cases = 400,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.8,
           .tags_at_least = {{"bounded", 0.4}, {"turns", 0.3}, {"the speed's square is out of range", 0.1}}},
          check_extremes_between_keys);
  t.example("the ball for any pose holds vertices whose squared distances underflow, and is hardly larger than they need", {},
            [] {
              long tried = 0;
              for (int exponent = -1074; exponent <= 100; exponent += 7)
                for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}) {
                  const double unit = std::ldexp(1.0, exponent);
                  Model model = swinging(unit);
                  model.vertices.insert(model.vertices.end(), {{0, unit, 0}, {0, 0, -unit}});
                  model.influences.assign(3, {{0, 1}}), model.triangles = {{0, 1, 2}};
                  const JointSets sets(model);
                  const int vertices[] = {0, 1, 2};
                  const auto bound = bound_any_pose(model, sets, vertices, skinning);
                  if (!bound || !(bound->radius >= unit) || bound->radius > 1.01 * unit + 4 * underflow_of_distance<double>())
                    return Checked(false, tried, "2^" + std::to_string(exponent));
                  ++tried;
                }
              return Checked(true, tried);
            });
}

// Returns the message with which bound_over_time refuses, or nothing if it bounds.
std::string refusal_of(double tolerance, const std::vector<Point3>& directions) {
  const Model model = swinging();
  try {
    Scene(model, Skinning::linear, directions).bound(tolerance);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

void what_is_refused(Suite& t) {
  t.example("a tolerance that is not positive is refused", {}, [] {
    bool good = true;
    for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
      good = good && refusal_of(tolerance, {Point3::UnitX()}) == "bound_over_time: the tolerance is not positive";
    return Checked(good && refusal_of(5e-324, {Point3::UnitX()}).empty(), 4);
  });
  t.example(
      "no direction is refused, and so is each that is shorter than 1e-100 or longer than 1e100, wherever it is in the list", {},
      [] {
        const std::string words = "bound_over_time: there is no direction, or one whose length is not from 1e-100 to 1e100";
        std::string wrong = refusal_of(0.1, {}) == words ? "" : "no direction; ";
        long tried = 1;
        const double infinity = std::numeric_limits<double>::infinity();
        for (const double length : {0.0, 5e-324, 1e-300, 1e-170, 0.999e-100, 1.001e100, 1e170, 1e300, infinity, std::nan("")})
          for (const std::size_t at : {0, 1, 2}) {
            std::vector<Point3> directions = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ()};
            directions[at] = Point3::Zero(), directions[at][2 - at] = length;
            if (refusal_of(0.1, directions) != words) wrong += std::to_string(length) + "; ";
            ++tried;
          }
        for (const double length : {1.001e-100, 1e-50, 1.0, 1e50, 0.999e100}) {
          if (!refusal_of(0.1, {{0, 0.6 * length, -0.8 * length}}).empty()) wrong += std::to_string(length) + " is refused; ";
          ++tried;
        }
        return Checked(wrong.empty(), tried, wrong);
      });
}

void rounding_outward_and_axes_of_slabs(Suite& t) {
  t.holds("what is rounded outward encloses what was rounded, and hardly more",
          {.number_type = "double", .degenerate_at_least = 0.1, .degenerate_at_most = 0.95}, [] {
            const auto any = [] {
              const double x = *gen::between(-1000000, 1000001) / 1e6;
              return std::ldexp(x, *rc::gen::element(0, 0, 0, 20, -20, 126, 129, -140, -160, -600, 900));
            };
            Box<double> box;
            for (int i = 0; i < 3; ++i) {
              box.low[i] = any(), box.high[i] = any();
              if (box.low[i] > box.high[i]) std::swap(box.low[i], box.high[i]);
            }
            const Box<float> rounded = rounded_outward(box);
            bool inexact = false, is_extreme = false;
            for (int i = 0; i < 3; ++i) {
              RC_ASSERT(static_cast<double>(rounded.low[i]) <= box.low[i] && box.high[i] <= static_cast<double>(rounded.high[i]));
              RC_ASSERT(static_cast<double>(std::nextafter(rounded.low[i], INFINITY)) > box.low[i]);
              RC_ASSERT(static_cast<double>(std::nextafter(rounded.high[i], -INFINITY)) < box.high[i]);
              inexact = inexact || rounded.low[i] != box.low[i];
              is_extreme = is_extreme || std::abs(box.high[i]) > 1e38 || (box.high[i] != 0 && std::abs(box.high[i]) < 1e-38);
            }
            RC_CLASSIFY(is_extreme, "degenerate");
          });
  t.example("a box of slabs has them along its axes", {}, [] {
    const std::vector<Slab<double>> slabs = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
    const Box<double> box = box_of(slabs);
    return box.low == Point3(1, 3, 5) && box.high == Point3(2, 4, 6);
  });
}

PROPTEST(bound_over_time) {
  bounds_hold_and_converge(t);
  t.holds("a bound of several clips together holds for each of them",
          {.number_type = "double",
           .cases = 120,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"the second clip goes farther", 0.3}}},
          check_two_clips_together);
  what_is_reached_between_keys_and_at_jumps(t);
  lengths_and_durations_out_of_the_range_of_squares(t);
  what_is_refused(t);
  rounding_outward_and_axes_of_slabs(t);
}

}  // namespace
}  // namespace proptests::suite_bound_over_time
