// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the joints of a model in an animation.
#include "algorithms/bake/over_time/animated_joints.hpp"

#include <random>

#include "proptests/gen/animated_model.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace proptests::suite_animated_joints {
namespace {

using namespace refitlab;
using M = MultiprecisionInterval;

Channel<Eigen::Vector3d> still(double x) { return {{{0, Eigen::Vector3d::Constant(x)}}}; }

// Makes one node that steps along x.
Model stepping(double duration, const std::vector<std::pair<double, double>>& steps) {
  Model model;
  model.name = model.skeleton.file = "stepping";
  model.skeleton.nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
  model.skeleton.joints = {{"joint", 0, -1, Eigen::Matrix4d::Identity()}};
  model.joints = {{"joint", -1, Point3::Zero()}};
  Channel<Eigen::Vector3d> positions{{}, Interpolation::step};
  for (const auto& [time, x] : steps) positions.keys.push_back({time, x * Eigen::Vector3d::UnitX()});
  const Animation animation{"clip", duration, {{0, positions, {{{0, Eigen::Quaterniond::Identity()}}}, still(1)}}};
  model.clips.push_back({"clip", duration, {}, animation});
  return model;
}

void defects_of_joints(Suite& t) {
  t.holds(
      "at every time skin matrices are no farther from their chains' rotations than the part's defect",
      {.number_type = "multiprecision interval",
       .cases = 200,
       .degenerate_at_least = 0.2,
       .degenerate_at_most = 0.9,
       .tags_at_least = {{"bounded", 0.8}, {"noise", 0.2}}},
      [] {
        const auto plan = gen::draw_animated_plan(true);
        RC_LOG() << plan;
        RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
        if (plan.noise > 0) RC_TAG("noise");
        const Model model = gen::animated_model(plan);
        const Animation& animation = model.clips[0].animation;
        std::optional<AnimatedJoints> joints;
        try {
          joints.emplace(model, animation, true);
        } catch (const ModelError&) {
          RC_TAG("refused");
          return;
        }
        RC_TAG("bounded");
        std::mt19937 random(plan.seed + 3);
        for (int i = 0; i < 4; ++i) {
          const int part = static_cast<int>(random() % static_cast<unsigned>(joints->part_count()));
          const double start = joints->times()[part], end = joints->times()[part + 1];
          const double at = i == 0 ? start : gen::time_within(start, end, random);
          const Side side = at == start ? Side::after : Side::before;
          std::vector<oracle::Placed<M>> scene;
          try {
            scene = oracle::scene_transforms(model.skeleton,
                                             oracle::local_transforms<M>(model.skeleton, animation, at, M(at), side, true));
          } catch (const oracle::Ambiguous&) {
            RC_TAG("undecided");
            continue;
          }
          for (const BoundJoint& joint : model.skeleton.joints) {
            const auto matrix = oracle::product(scene[joint.node].matrix, oracle::matrix_of<M>(joint.offset));
            const auto q = oracle::hamilton<M>(scene[joint.node].turn, oracle::rotation_in<M>(joint.offset));
            const auto turn = oracle::affine_of<M>(q, {M(0), M(0), M(0)});
            Eigen::Matrix3d difference;
            for (int r = 0; r < 3; ++r)
              for (int c = 0; c < 3; ++c) difference(r, c) = oracle::middle_of(M(matrix[r][c] - turn[r][c]));
            RC_ASSERT(difference.jacobiSvd().singularValues()[0] <= joints->cell(part, start, end).defect * (1 + 1e-9) + 1e-13);
          }
        }
      });
  t.holds("defects are no greater than the noise of scales allows",
          {.number_type = "double", .cases = 100, .degenerate_at_most = 0.9}, [] {
            auto plan = gen::draw_animated_plan(true);
            plan.near_zero = false, plan.cubic = false;
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const Model model = gen::animated_model(plan);
            const AnimatedJoints joints(model, model.clips[0].animation, true);
            // Splines overshoot their keys by tangents of up to 100 times the noise.
            for (int part = 0; part < joints.part_count(); ++part)
              RC_ASSERT(joints.cell(part, joints.times()[part], joints.times()[part + 1]).defect <=
                        300 * plan.nodes * plan.noise + 1e-12);
          });
}

void poses_at_jumps_and_elsewhere(Suite& t) {
  t.example("both sides of a jump are posed, and of other times one", {}, [] {
    const Model model = stepping(3, {{0, 1}, {1, 2}, {2.5, 3}});
    const AnimatedJoints joints(model, model.clips[0].animation, true);
    const auto x = [&](double time, Side side) { return joints.at(time, side)->matrices[0](0, 3); };
    return x(1, Side::before) == 1 && x(1, Side::after) == 2 && x(2.5, Side::before) == 2 && x(2.5, Side::after) == 3 &&
           joints.side_of(1, Side::before) == Side::before && joints.side_of(0, Side::before) == Side::after &&
           joints.side_of(3, Side::before) == Side::after && joints.at(3, Side::before) == joints.at(3, Side::after) &&
           joints.at(1, Side::after)->pose[0].translation[0] == 2 && joints.times() == std::vector<double>{0, 1, 2.5, 3};
  });
  t.example("a jump at the end, and an animation without a duration, have a part of one moment behind them", {}, [] {
    const Model late = stepping(1, {{0, 1}, {1, 2}}), moment = stepping(0, {{0, 1}, {1, 2}});
    const AnimatedJoints jumps(late, late.clips[0].animation, false), stays(moment, moment.clips[0].animation, false);
    return jumps.times() == std::vector<double>{0, 1, 1} && jumps.part_count() == 2 &&
           stays.times() == std::vector<double>{0, 0} && stays.part_count() == 1 && side_of_end(1, 1) == Side::after &&
           side_of_end(0, 1) == Side::before && jumps.motions(0).chains[0].offset.size == 1 &&
           jumps.motions(1).chains[0].offset.size == 2;
  });
  t.example("poses are made where they are asked for only", {}, [] {
    const Model model = stepping(1, {{0, 1}});
    return AnimatedJoints(model, model.clips[0].animation, false).at(0, Side::after)->pose.empty() &&
           AnimatedJoints(model, model.clips[0].animation, true).at(0, Side::after)->pose.size() == 1;
  });
}

PROPTEST(animated_joints) {
  defects_of_joints(t);
  t.example("a model without keys is refused by name", {}, [] {
    Model model = stepping(1, {{0, 1}});
    const Animation animation = model.clips[0].animation;
    model.skeleton.joints.clear();
    try {
      AnimatedJoints(model, animation, false);
    } catch (const ModelError& e) {
      return std::string(e.what()) == "stepping: clip 'clip': it has no keys, and nothing is known of it between poses";
    }
    return false;
  });
  poses_at_jumps_and_elsewhere(t);
}

}  // namespace
}  // namespace proptests::suite_animated_joints
