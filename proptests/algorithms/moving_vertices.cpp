// SPDX-License-Identifier: GPL-3.0-or-later
// Tests skinned vertices between two moments of an animation.
#include "algorithms/bake/over_time/moving_vertices.hpp"

#include <cmath>
#include <random>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/half_turns.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/animated_skin.hpp"
#include "proptests/oracles/reweighted_vertex.hpp"

namespace proptests::suite_moving_vertices {
namespace {

using namespace refitlab;
using M = MultiprecisionInterval;

// Returns all vertices at a moment, or nothing where the moment is ambiguous.
std::optional<std::vector<Vec<M, 3>>> skinned(oracle::AnimatedSkin<M>& skin, const Model& model, double time, Side side) {
  try {
    skin.pose(time, side);
    std::vector<Vec<M, 3>> out;
    for (std::size_t v = 0; v < model.vertices.size(); ++v) out.push_back(skin.vertex(static_cast<int>(v)));
    return out;
  } catch (const oracle::Ambiguous&) {
    return std::nullopt;
  }
}

bool is_farther(const Vec<M, 3>& a, const Vec<M, 3>& b, double distance) {
  return less_equal(squared_distance<M, 3>(a, b), M(sq(M(distance)))) == Verdict::fails;
}

Vec<M, 3> exactly(const Point3& x) { return {M(x[0]), M(x[1]), M(x[2])}; }

Skinning skinning_of(int i) { return std::array{Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}[i]; }

// Makes two joints below one node, the second of which turns about z from 0 to this angle (degrees) in a second.
Model turning(double angle, int turned_joints = 1) {
  Model model;
  model.name = model.skeleton.file = "turning";
  model.skeleton.nodes = {{"base", -1, Eigen::Matrix4d::Identity()}};
  model.skeleton.joints = {{"still", 0, -1, Eigen::Matrix4d::Identity()}};
  model.joints = {{"still", -1, Point3::Zero()}};
  const Channel<Eigen::Vector3d> zero{{{0, Eigen::Vector3d::Zero()}}}, one{{{0, Eigen::Vector3d::Ones()}}};
  Animation animation{"clip", 1, {}};
  for (int j = 1; j <= turned_joints; ++j) {
    model.skeleton.nodes.push_back({"turned", 0, Eigen::Matrix4d::Identity()});
    model.skeleton.joints.push_back({"turned", j, 0, Eigen::Matrix4d::Identity()});
    model.joints.push_back({"turned", 0, Point3::Zero()});
    Channel<Eigen::Quaterniond> turns;
    for (int k = 0; k <= 4; ++k)
      turns.keys.push_back(
          {k / 4.0, Eigen::Quaterniond(Eigen::AngleAxisd((j == 1 ? 1 : -1) * angle * k / 4 * 3.141592653589793 / 180,
                                                         Eigen::Vector3d::UnitZ()))});
    animation.tracks.push_back({j, zero, turns, one});
  }
  model.vertices = {{1, 0, 0}};
  model.triangles = {{0, 0, 0}};
  model.influences = {{}};
  for (int j = 0; j <= turned_joints; ++j) model.influences[0].push_back({j, 0.5});
  if (turned_joints == 2) model.influences[0] = {{0, 0.0625}, {1, 0.46875}, {2, 0.46875}};
  model.clips.push_back({"clip", 1, {}, animation});
  return model;
}

int depth_of(const Model& model, int joint) {
  int depth = 0;
  for (int n = model.skeleton.joints[joint].node; n >= 0; n = model.skeleton.nodes[n].parent) ++depth;
  return depth;
}

// Checks a vertex of several joints against the same vertex with one of these alone.
void check_errors_by_joints() {
  const auto plan = gen::draw_animated_plan(false);
  RC_LOG() << plan;
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  const Model model = gen::animated_model(plan);
  const Animation& animation = model.clips[0].animation;
  // The last joint is not the deepest one.
  bool ends_above = false;
  try {
    const AnimatedJoints joints(model, animation, false);
    const JointSets sets(model);
    const JointCell cell = joints.cell(joints.boxes()[plan.seed % joints.boxes().size()]);
    for (const int v : gen::all_of(model.vertices)) {
      const double error = MovingVertices(model, sets, Skinning::linear, {v}).placing_error(cell);
      const auto& influences = model.influences[static_cast<std::size_t>(v)];
      for (const Influence& influence : influences) {
        Model alone = model;
        alone.influences[static_cast<std::size_t>(v)] = {{influence.joint, 1}};
        const JointSets own(alone);
        RC_ASSERT(MovingVertices(alone, own, Skinning::linear, {v}).placing_error(cell) <= error);
        ends_above = ends_above || depth_of(model, influence.joint) > depth_of(model, influences.back().joint);
      }
    }
  } catch (const ModelError&) {
    RC_TAG("refused");
  }
  if (ends_above) RC_TAG("the last joint is not the deepest");
}

void errors_of_rounding(Suite& t) {
  t.holds("the error of a vertex is no less than what each of its joints alone makes of it",
          {.number_type = "double",
           .cases = 200,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"the last joint is not the deepest", 0.2}}},
          check_errors_by_joints);
  t.holds(
      "placed vertices are off by no more than the error, even if most of what they are summed up from cancels",
      {.number_type = "multiprecision interval",
       .cases = 300,
       .degenerate_at_least = 0.2,
       .degenerate_at_most = 0.9,
       .tags_at_least = {{"bounded", 0.8}, {"cancels", 0.1}}},
      [] {
        const Skinning skinning = skinning_of(*rc::gen::inRange(0, 3));
        const auto plan = gen::draw_animated_plan(skinning != Skinning::linear);
        RC_LOG() << plan << " skinning " << static_cast<int>(skinning);
        RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
        if (plan.far > 0 || plan.away > 0) RC_TAG("cancels");
        const Model model = gen::animated_model(plan);
        const Animation& animation = model.clips[0].animation;
        const JointSets sets(model);
        oracle::AnimatedSkin<M> skin(model, animation, skinning);
        std::mt19937 random(plan.seed + 5);
        try {
          const AnimatedJoints joints(model, animation, skinning != Skinning::linear);
          const MovingVertices moving(model, sets, skinning, gen::all_of(model.vertices));
          std::vector<Point3> points;
          for (int i = 0; i < 4; ++i) {
            const int part = static_cast<int>(random() % static_cast<unsigned>(joints.part_count()));
            const double start = joints.times()[part], end = joints.times()[part + 1];
            const double time = i == 0 ? start : i == 1 ? end : gen::time_within(start, end, random);
            const Side side = time == start ? Side::after : Side::before;
            // The placing of vertices that are not followed may be wrong, since their blends may vanish.
            if (!(moving.slack(joints.cell(part, time, time), Finite::may_be).chord < std::numeric_limits<double>::infinity()) &&
                skinning == Skinning::dual_quaternion)
              continue;
            moving.place(*joints.at(time, side), Followed::skinned, points);
            const auto exact = skinned(skin, model, time, side);
            if (!exact) {
              RC_TAG("undecided");
              continue;
            }
            for (std::size_t v = 0; v < points.size(); ++v)
              RC_ASSERT(!is_farther(exactly(points[v]), (*exact)[v],
                                    moving.placing_error(joints.cell(part, joints.times()[part], joints.times()[part + 1]))));
          }
          RC_TAG("bounded");
        } catch (const ModelError&) {
          RC_TAG("refused");
        }
      });
  t.example("an error is not much more than rounding: parts in 10^11 of the size by linear skinning, in 10^9 by dual quaternions",
            {}, [] {
              const Model model = turning(60);
              const JointSets sets(model);
              const AnimatedJoints joints(model, model.clips[0].animation, true);
              const MovingVertices linear(model, sets, Skinning::linear, {0}), dual(model, sets, Skinning::dual_quaternion, {0});
              const JointCell cell = joints.cell(0, 0, 0.25);
              return linear.placing_error(cell) > 0 && linear.placing_error(cell) < 1e-11 && dual.placing_error(cell) < 1e-9;
            });
  t.example(
      "an error grows with what blends do to it: by dual quaternions tenfold at least, since blends of a tenth of a unit are "
      "followed, "
      "and about least-squares centers 10^4 times, which is how much farther away than the joints these may be",
      {}, [] {
        const Model model = turning(60);
        const JointSets sets(model);
        const AnimatedJoints joints(model, model.clips[0].animation, true);
        const JointCell cell = joints.cell(0, 0, 0.25);
        const auto error = [&](Skinning skinning) { return MovingVertices(model, sets, skinning, {0}).placing_error(cell); };
        const double linear = error(Skinning::linear);
        return error(Skinning::dual_quaternion) >= 10 * linear && error(Skinning::spherical) >= 1e4 * linear;
      });
}

// Makes joints below one node, turned by up to this angle from one of them and moved by up to this distance, that all have a
// share of a vertex.
Model joints_that_rest(int joints, double angle, double distance, std::mt19937& random) {
  std::uniform_real_distribution<double> side(-1, 1);
  const auto vector = [&] { return Point3(side(random), side(random), side(random)); };
  Model model;
  model.name = model.skeleton.file = "rest";
  model.skeleton.nodes = {{"base", -1, Eigen::Matrix4d::Identity()}};
  for (int j = 0; j < joints; ++j) {
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
    if (j > 0) local.topLeftCorner<3, 3>() = Eigen::AngleAxisd(angle * side(random), vector().normalized()).toRotationMatrix();
    local.topRightCorner<3, 1>() = distance * vector();
    model.skeleton.nodes.push_back({"joint", 0, local});
    model.skeleton.joints.push_back({"joint", j + 1, -1, Eigen::Matrix4d::Identity()});
    model.joints.push_back({"joint", -1, vector()});
  }
  model.vertices = {vector()}, model.triangles = {{0, 0, 0}}, model.influences = {{}};
  int left = 1 << 10;
  for (int j = 0; j < joints; ++j) {
    const int units = j + 1 == joints ? left : std::uniform_int_distribution<int>(1, 2 * left / (joints - j) - 1)(random);
    model.influences[0].push_back({j, units / 1024.0}), left -= units;
  }
  return model;
}

void check_errors_of_weights() {
  const int joints = *gen::between(2, 7);
  const double angle = *rc::gen::element(1e-6, 1e-3, 0.1, 1.0, 2.0, 3.0), distance = *rc::gen::element(0.0, 0.01, 1.0, 100.0);
  const Skinning skinning = skinning_of(*rc::gen::element(0, 1, 2));
  const auto seed = *gen::between<unsigned>(0, 1u << 30);
  RC_LOG() << joints << " joints, " << angle << " rad, " << distance << " away, skinning " << static_cast<int>(skinning)
           << ", seed " << seed;
  RC_CLASSIFY(joints == 2 || angle <= 1e-3 || distance == 0, "degenerate");
  std::mt19937 random(seed);
  const Model model = joints_that_rest(joints, angle, distance, random);
  const JointSets sets(model);
  const Animation rest{"rest", 1, {}};
  const AnimatedJoints moving(model, rest, true);
  const JointCell cell = moving.cell(moving.boxes()[0]);
  if (MovingVertices(model, sets, skinning, {0}).slack(cell, Finite::may_be).chord > 1) {
    RC_TAG("a blend that is too short to be followed");
    return;
  }
  const auto posed = moving.at(0, Side::after);
  std::vector<double> weights;
  for (const Influence& influence : model.influences[0]) weights.push_back(influence.weight);
  const Point3 x = oracle::reweighted_vertex(model, skinning, posed->pose, weights);
  const double most = MovingVertices(model, sets, skinning, {0}).error_growth(cell).per_weight;
  bool is_near = false;
  for (int change = 0; change < 8; ++change) {
    std::vector<double> changed = weights;
    double sum = 0, last = 0;
    for (int j = 0; j + 1 < joints; ++j) {
      const double e = 1e-6 * std::uniform_real_distribution<double>(-1, 1)(random);
      changed[static_cast<std::size_t>(j)] += e, sum += std::abs(e), last -= e;
    }
    changed.back() += last, sum += std::abs(last);
    const double moved = (oracle::reweighted_vertex(model, skinning, posed->pose, changed) - x).norm();
    // The tolerances are for rounding in double, and for the blend that is shorter with the changed weights.
    RC_ASSERT(moved <= most * sum * (1 + 1e-4) + 1e-14 * most);
    is_near = is_near || moved > most * sum / 3;
  }
  RC_TAG(skinning == Skinning::linear ? "linear" : skinning == Skinning::spherical ? "spherical" : "dual");
  if (is_near) RC_TAG(skinning == Skinning::linear ? "a third of the bound, linear" : "a third of the bound, not linear");
}

void what_renderers_and_weights_are_off_by(Suite& t) {
  t.holds("other weights move a vertex no farther than its growth of errors says, whatever the skinning",
          {.number_type = "double",
           .cases = 3000,
           .degenerate_at_most = 0.8,
           .tags_at_least = {{"spherical", 0.2},
                             {"dual", 0.2},
                             {"a third of the bound, linear", 0.1},
                             {"a third of the bound, not linear", 0.005}}},
          check_errors_of_weights);
  t.example("dual quaternions are not followed where a renderer in float may see the other sign of their dot product", {}, [] {
    long tried = 0;
    for (const double cosine : {1e-12, 1e-9, 1e-7, 1e-6, 3e-6, 5e-6, 1e-5, 1e-3}) {
      const Model model = turning(2 * std::acos(cosine) * 180 / 3.141592653589793);
      const JointSets sets(model);
      const AnimatedJoints joints(model, model.clips[0].animation, true);
      const MovingVertices dual(model, sets, Skinning::dual_quaternion, {0});
      // The cell is so short that the dot product does not change by 10^-8.
      const JointCell cell = joints.cell(3, 1 - 1e-9, 1);
      const bool is_followed = dual.slack(cell, Finite::may_be).chord < std::numeric_limits<double>::infinity();
      const CellSlack must = dual.slack(cell, Finite::must_be);
      if (is_followed != (cosine > rounding_of_cosine_in_float) || (must.followed == Followed::skinned) != is_followed ||
          !(is_followed || must.beyond[0] >= 1))
        return Checked(false, tried, "a dot product of " + std::to_string(cosine * 1e6) + "e-6");
      ++tried;
    }
    return Checked(true, tried);
  });
  t.example(
      "errors of weights grow with the inverse square of the length of a blend, to a hundredfold; not for one joint", {}, [] {
        const auto growth = [](double angle, int turned_joints, Skinning skinning) {
          const Model model = turning(angle, turned_joints);
          const JointSets sets(model);
          const AnimatedJoints joints(model, model.clips[0].animation, true);
          const MovingVertices moving(model, sets, skinning, {0});
          const JointCell cell = joints.cell(3, 1 - 1e-9, 1);
          const ErrorGrowth errors = moving.error_growth(cell);
          return std::pair{errors.per_weight, errors.per_rounding};
        };
        // Two joints at halves are a right angle apart: the blend's squared length is (1 + cos 45 degrees) / 2.
        const double squared = (1 + std::sqrt(0.5)) / 2, right = 1 / std::sqrt(squared) + 1 / squared;
        const auto at_right = growth(90, 1, Skinning::dual_quaternion), linear = growth(90, 1, Skinning::linear),
                   still = growth(0, 1, Skinning::dual_quaternion), short_one = growth(176, 2, Skinning::dual_quaternion);
        const bool good = std::abs(at_right.first / right - 1) < 1e-6 && std::abs(at_right.second / (right / 2) - 1) < 1e-6 &&
                          std::abs(linear.first - 1) < 1e-6 && std::abs(linear.second - 1) < 1e-6 &&
                          std::abs(still.first - 2) < 1e-6 && std::abs(still.second - 1) < 1e-6 && short_one.first > 100 &&
                          short_one.first < 111;
        return Checked(
            good, 4, std::to_string(at_right.first) + " " + std::to_string(still.first) + " " + std::to_string(short_one.first));
      });
}

void a_center_that_stays(Suite& t) {
  t.example("where a rotation center stays, since rotations hardly differ, it need not be where the images of a far vertex meet",
            {}, [] {
              // The second joint turns by less than the angle at which a center is moved. Its translation puts the vertex back to
              // where it was, so that both images are one.
              const double angle = 0.9e-4, far = 1000;
              const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
              Model model = turning(0);
              model.vertices = {{far, 0, 0}};
              NodeTrack& track = model.clips[0].animation.tracks[0];
              track.rotations.keys = {{0, turn}};
              track.positions.keys = {{0, model.vertices[0] - turn * model.vertices[0]}};
              const JointSets sets(model);
              const AnimatedJoints joints(model, model.clips[0].animation, true);
              const MovingVertices spherical(model, sets, Skinning::spherical, {0});
              const CellSlack slack = spherical.slack(joints.cell(0, 0, joints.times()[1]), Finite::must_be);
              // The vertex turns half as far about the origin. Its linear blend would be on the chord of that arc.
              const double off = far * (1 - std::cos(angle / 2));
              return Checked(
                  slack.followed == Followed::linear_blend && off > 1e-7 && slack.beyond[0] > off && slack.beyond[0] < 10 * off,
                  1, std::to_string(slack.beyond[0] / off) + " times as much is allowed for");
            });
  t.example(
      "joints whose images are one at both ends of a time may come apart in between, and so may the vertex and its linear blend",
      {}, [] {
        // The second joint swings out and back, as a spline from no turn to no turn. Half-way it is turned by twice the angle of
        // tangent 1/2.
        Model model = turning(0);
        NodeTrack& track = model.clips[0].animation.tracks[0];
        const Eigen::Quaterniond none = Eigen::Quaterniond::Identity(), rest(0, 0, 0, 0), there(0, 0, 0, 2), back(0, 0, 0, -2);
        track.rotations.keys = {{0, none}, {1, none}};
        track.rotations.interpolation = Interpolation::cubic;
        track.rotations.tangents = {{rest, there}, {back, rest}};
        const AnimatedJoints joints(model, model.clips[0].animation, true);
        const JointSets sets(model);
        const MovingVertices spherical(model, sets, Skinning::spherical, {0});
        const CellSlack slack = spherical.slack(joints.cell(0, 0, joints.times()[1]), Finite::must_be);
        const double off = 1 - 2 / std::sqrt(5.0);  // the vertex turns by half of it, and its linear blend is half of both images
        return Checked(joints.times()[1] == 1 && slack.beyond[0] > off && slack.beyond[0] < 30 * off, 1,
                       std::to_string(slack.beyond[0] / off) + " times as much is allowed for");
      });
}

void what_is_not_followed_or_costs_nothing(Suite& t) {
  t.example("there are no bounds of Hejl's centers", {}, [] {
    const Model model = turning(60);
    try {
      MovingVertices(model, JointSets(model), Skinning::hejl, {0});
    } catch (const std::invalid_argument& e) {
      return std::string(e.what()) == "MovingVertices: there are no bounds over time of Hejl's centers";
    }
    return false;
  });
  t.example("dual quaternions whose signs may change are not followed, but their linear blend is if it must", {}, [] {
    // It is beyond half a turn at 9/11 of the second.
    const Model model = turning(220);
    const JointSets sets(model);
    const AnimatedJoints joints(model, model.clips[0].animation, true);
    const MovingVertices dual(model, sets, Skinning::dual_quaternion, {0});
    const double unknown = std::numeric_limits<double>::infinity();
    const CellSlack before = dual.slack(joints.cell(0, 0, 0.25), Finite::may_be),
                    there = dual.slack(joints.cell(3, 0.75, 1), Finite::may_be),
                    must = dual.slack(joints.cell(3, 0.75, 1), Finite::must_be);
    // Afterwards, the other sign holds, and short intervals show it.
    const CellSlack after = dual.slack(joints.cell(3, 0.99, 1), Finite::may_be);
    return before.followed == Followed::skinned && before.chord < 0.8 && there.chord == unknown &&
           must.followed == Followed::linear_blend && must.chord < 0.3 && must.beyond[0] > 0.5 && must.beyond[0] < unknown &&
           after.chord < 0.01;
  });
  t.example("the shorter a blend is, the more it bends, and one that is too short is not followed", {}, [] {
    const double unknown = std::numeric_limits<double>::infinity();
    const Model two = turning(170), three = turning(190, 2);
    const JointSets sets_of_two(two), sets_of_three(three);
    const AnimatedJoints turning_two(two, two.clips[0].animation, true), turning_three(three, three.clips[0].animation, true);
    const MovingVertices of_two(two, sets_of_two, Skinning::dual_quaternion, {0}),
        of_three(three, sets_of_three, Skinning::dual_quaternion, {0});
    // The joints are 176 degrees apart, where signs stay.
    const double shorter = of_two.slack(turning_two.cell(3, 0.95, 0.951), Finite::may_be).chord,
                 longer = of_two.slack(turning_two.cell(0, 0.05, 0.051), Finite::may_be).chord,
                 too_short = of_three.slack(turning_three.cell(3, 0.9263, 0.92631), Finite::may_be).chord,
                 long_enough = of_three.slack(turning_three.cell(3, 0.8, 0.80001), Finite::may_be).chord;
    return Checked(shorter > 1.3 * longer && shorter < 1e-3 && too_short == unknown && long_enough < 1e-3, 4,
                   std::to_string(shorter) + " " + std::to_string(longer) + " " + std::to_string(too_short) + " " +
                       std::to_string(long_enough));
  });
  t.example("a blend of three joints that may vanish is refused by name", {}, [] {
    const Model model = turning(235, 2);
    const JointSets sets(model);
    const AnimatedJoints joints(model, model.clips[0].animation, true);
    const MovingVertices dual(model, sets, Skinning::dual_quaternion, {0});
    try {
      dual.slack(joints.cell(3, 0.75, 1), Finite::must_be);
    } catch (const ModelError& e) {
      return std::string(e.what()) ==
             "turning: vertex 0 or one like it: the rotations of its joints come so far apart that their blend may vanish: there "
             "is no bound over time";
    }
    return false;
  });
  t.example("what all joints do alike costs nothing: the slack of a blend is that of its base and of what turns below", {}, [] {
    Model model = turning(60);
    auto& animation = model.clips[0].animation;
    const Channel<Eigen::Vector3d> one{{{0, Eigen::Vector3d::Ones()}}};
    // The base moves far and straight, which bends nothing.
    animation.tracks.push_back(
        {0, {{{0, Eigen::Vector3d::Zero()}, {1, Eigen::Vector3d(1e6, 0, 0)}}}, {{{0, Eigen::Quaterniond::Identity()}}}, one});
    const JointSets sets(model);
    const AnimatedJoints joints(model, animation, true);
    const double moved =
        MovingVertices(model, sets, Skinning::dual_quaternion, {0}).slack(joints.cell(0, 0, 0.25), Finite::may_be).chord;
    const Model still = turning(60);
    const AnimatedJoints resting(still, still.clips[0].animation, true);
    const double alone =
        MovingVertices(still, sets, Skinning::dual_quaternion, {0}).slack(resting.cell(0, 0, 0.25), Finite::may_be).chord;
    return moved == alone && alone < 0.05;
  });
}

PROPTEST(moving_vertices) {
  t.holds("a vertex is as near to its chord as the slack says, or to its linear blend, which is",
          {.number_type = "multiprecision interval",
           .cases = 500,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"bounded", 0.8}, {"followed itself", 0.3}, {"followed by its linear blend", 0.1}}},
          [] {
            const Skinning skinning = skinning_of(*rc::gen::inRange(0, 3));
            auto plan = gen::draw_animated_plan(skinning != Skinning::linear);
            if (plan.duration == 0) plan.duration = 1;
            RC_LOG() << plan << " skinning " << static_cast<int>(skinning);
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const Model model = gen::animated_model(plan);
            const Animation& animation = model.clips[0].animation;
            const JointSets sets(model);
            oracle::AnimatedSkin<M> skin(model, animation, skinning), linear(model, animation, Skinning::linear);
            std::mt19937 random(plan.seed + 4);
            std::uniform_real_distribution<double> share(0, 1);
            try {
              const AnimatedJoints joints(model, animation, skinning != Skinning::linear);
              const MovingVertices moving(model, sets, skinning, gen::all_of(model.vertices));
              for (int i = 0; i < 4; ++i) {
                const int part = static_cast<int>(random() % static_cast<unsigned>(joints.part_count()));
                const double first = joints.times()[part], last = joints.times()[part + 1];
                const double length = std::array{1.0, 0.5, 0.1, 0.01}[random() % 4];
                const double from = share(random) * (1 - length);
                const double start = first + (last - first) * from,
                             end = length == 1 ? last : std::min(last, start + length * (last - first));
                if (!(start < end)) continue;
                const Side side = start == first ? Side::after : Side::before;
                CellSlack slack = moving.slack(joints.cell(part, start, end), Finite::may_be);
                if (!(slack.chord < std::numeric_limits<double>::infinity()))
                  slack = moving.slack(joints.cell(part, start, end), Finite::must_be);
                const double error = moving.placing_error(joints.cell(part, joints.times()[part], joints.times()[part + 1]));
                const bool itself = slack.followed == Followed::skinned;
                RC_TAG(itself ? "followed itself" : "followed by its linear blend");
                auto& followed = itself ? skin : linear;
                const auto at_start = skinned(followed, model, start, side), at_end = skinned(followed, model, end, Side::before);
                for (const double at : {0.5, share(random)}) {
                  const double time = start + at * (end - start);
                  if (!(start < time && time < end)) continue;
                  const auto point = skinned(followed, model, time, Side::after),
                             vertex = skinned(skin, model, time, Side::after);
                  if (!at_start || !at_end || !point || !vertex) {
                    RC_TAG("undecided");
                    continue;
                  }
                  const M passed = (M(time) - M(start)) / (M(end) - M(start));
                  for (std::size_t v = 0; v < point->size(); ++v) {
                    const Vec<M, 3> chord = (*at_start)[v] * M(M(1) - passed) + (*at_end)[v] * passed;
                    RC_ASSERT(!is_farther((*point)[v], chord, slack.chord + error));
                    if (!itself) RC_ASSERT(!is_farther((*point)[v], (*vertex)[v], slack.beyond[v] + error));
                  }
                }
              }
              RC_TAG("bounded");
            } catch (const ModelError&) {
              RC_TAG("refused");
            }
          });
  errors_of_rounding(t);
  what_renderers_and_weights_are_off_by(t);
  a_center_that_stays(t);
  what_is_not_followed_or_costs_nothing(t);
}

}  // namespace
}  // namespace proptests::suite_moving_vertices
