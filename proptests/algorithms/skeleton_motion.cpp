// SPDX-License-Identifier: GPL-3.0-or-later
// Tests skin matrices of a moving skeleton as rigid transforms.
#include "algorithms/model/skeleton_motion.hpp"

#include <cmath>
#include <tuple>

#include "proptests/gen/any_place.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_skeleton_motion {
namespace {

using namespace refitlab;

double real() { return *rc::gen::inRange(-1000, 1001) / 1000.0; }

// Poses a skeleton whose only skin matrix is this matrix.
PosedSkeleton palette_by(const Eigen::Matrix4d& matrix) {
  const BoundSkeleton skeleton{"test", {{"node", -1, matrix}}, {{"joint", 0, -1, Eigen::Matrix4d::Identity()}}};
  return pose(skeleton, Animation{}, 0);
}

void what_is_no_rotation_is_measured_or_refused(Suite& t) {
  t.example("of several joints the largest defect is reported, whichever joint has it, and the tolerance is for all", {}, [] {
    bool good = true;
    for (int stretched = 0; stretched < 3; ++stretched) {
      BoundSkeleton skeleton{"test", {}, {}};
      for (int j = 0; j < 3; ++j) {
        skeleton.nodes.push_back({"node", -1, Eigen::Matrix4d::Identity()});
        skeleton.joints.push_back({"joint", j, -1, Eigen::Matrix4d::Identity()});
      }
      const auto stretch = [&](double by) {
        skeleton.nodes[stretched].local.topLeftCorner<3, 3>() = (1 + by) * Eigen::Matrix3d::Identity();
      };
      const auto refused = [&] {
        try {
          pose(skeleton, Animation{}, 0);
        } catch (const ModelError&) {
          return true;
        }
        return false;
      };
      // The defect of a stretch by 1 + b is sqrt(3) (2 b + b^2).
      const double end = std::sqrt(1 + rigidity_tolerance / std::sqrt(3)) - 1;
      stretch(1e-4);
      good = good && std::abs(pose(skeleton, Animation{}, 0).rigidity_defect - std::sqrt(3) * (2e-4 + 1e-8)) < 1e-14;
      stretch(end * (1 - 1e-9));
      good = good && !refused();
      stretch(end * (1 + 1e-9));
      good = good && refused();
    }
    return Checked(good, 9);
  });
  t.example("a matrix that is no rotation is refused by what is wrong with it", {}, [] {
    const auto refusal = [](const Eigen::Vector3d& stretch) {
      Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
      matrix.topLeftCorner<3, 3>() = stretch.asDiagonal();
      try {
        palette_by(matrix);
      } catch (const ModelError& e) {
        return std::string(e.what());
      }
      return std::string();
    };
    const std::tuple<Eigen::Vector3d, const char*> refused[] = {{{2, 1, 1}, "shears or scales unevenly, by 1 to 2 "},
                                                                {{1, 1, 2}, "shears or scales unevenly, by 1 to 2 "},
                                                                {{2, 2, 1}, "shears or scales unevenly, by 1 to 2 "},
                                                                {{1, 3, 2}, "shears or scales unevenly, by 1 to 3 "},
                                                                {{1, -1, 1}, "the skin matrix mirrors "},
                                                                {{-2, -2, -2}, "the skin matrix mirrors "},
                                                                {{2, 2, 2}, "the skin matrix scales by 2 "},
                                                                {{1, 1, NAN}, "the skin matrix is not finite"},
                                                                {{0.5, 0.5, 0.5}, "the skin matrix scales by 0.5 "},
                                                                {{1, -1, 2}, "shears or scales unevenly, by 1 to 2 "}};
    std::string wrong;
    for (const auto& [stretch, words] : refused)
      if (const std::string message = refusal(stretch); message.find(words) == std::string::npos)
        wrong += "'" + message + "', not '" + words + "'; ";
    return Checked(wrong.empty() && refusal({1, 1, 1}).empty(), 11, wrong);
  });
}

void what_holds_at_keys(Suite& t) {
  t.example("at a time that two keys share the later one holds, and before it the way leads to the earlier one", {}, [] {
    const Eigen::Vector3d ones = Eigen::Vector3d::Ones(), zeros = Eigen::Vector3d::Zero();
    const Animation motion{"clip",
                           4,
                           {{0,
                             {{{0, zeros}, {2, 2 * ones}, {2, 8 * ones}, {4, 4 * ones}}},
                             {{{0, Eigen::Quaterniond::Identity()}}},
                             {{{0, ones}}}}}};
    const std::vector<SceneNode> nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
    bool good = true;
    for (const auto& [time, x] : {std::pair{1.0, 1.0}, {2.0, 8.0}, {3.0, 6.0}, {4.0, 4.0}})
      good = good && global_transforms(nodes, motion, time)[0](1, 3) == x;
    return Checked(good && key_times(motion, 9) == std::vector<double>{0, 2, 4}, 5);
  });
  t.example("key times are those of positions, rotations and scales of all tracks; a limit of all of them thins nothing", {}, [] {
    const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
    const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
    const Animation motion{
        "clip",
        9,
        {{0, {{{1, ones}}}, {{{2, still}}}, {{{3, ones}}}}, {1, {{{4, ones}}}, {{{5, still}, {9.5, still}}}, {{{6, ones}}}}}};
    const std::vector<double> all{0, 1, 2, 3, 4, 5, 6, 9};
    return key_times(motion, 8) == all && key_times(motion, 9) == all && key_times(motion, 7).size() == 7u &&
           key_times(motion, 2) == std::vector<double>{0, 9};
  });
  t.example("a joint's quaternion is on the side of its parent's, not of another joint's", {}, [] {
    BoundSkeleton skeleton{"test", {}, {}};
    for (int j = 0; j < 3; ++j) {
      Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
      local.topLeftCorner<3, 3>() = Eigen::AngleAxisd(1.7 * j, Eigen::Vector3d::UnitX()).toRotationMatrix();
      skeleton.nodes.push_back({"node", -1, local});
      skeleton.joints.push_back({"joint", j, j - 1, Eigen::Matrix4d::Identity()});
    }
    const Pose pose = refitlab::pose(skeleton, Animation{}, 0).pose;
    return pose[0].rotation[0] > 0 && dot(pose[1].rotation, pose[0].rotation) > 0 &&
           dot(pose[2].rotation, pose[1].rotation) > 0 && dot(pose[2].rotation, pose[0].rotation) < 0;
  });
}

void what_holds_between_keys_and_beyond_them(Suite& t) {
  t.example("before its first key and after its last a node stays", {}, [] {
    const Eigen::Vector3d ones = Eigen::Vector3d::Ones(), zeros = Eigen::Vector3d::Zero();
    const Animation motion{
        "clip", 4, {{0, {{{1, zeros}, {3, 2 * ones}}}, {{{0, Eigen::Quaterniond::Identity()}}}, {{{0, ones}}}}}};
    const std::vector<SceneNode> nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
    bool good = true;
    for (const auto& [time, x] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.5, 0.5}, {2.5, 1.5}, {3.0, 2.0}, {4.0, 2.0}})
      good = good && global_transforms(nodes, motion, time)[0](1, 3) == x;
    return Checked(good, 6);
  });
  t.example("a step stays until the next key, of whose time both sides are known, and so is a jump between two keys of one time",
            {}, [] {
              const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
              const Channel<Eigen::Vector3d> one{{{0, ones}}},
                  steps{{{0, 0 * ones}, {2, 2 * ones}, {3, 5 * ones}}, Interpolation::step},
                  jump{{{0, 0 * ones}, {2, 2 * ones}, {2, 8 * ones}, {4, 4 * ones}}};
              const std::vector<SceneNode> nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
              const auto at = [&](const Channel<Eigen::Vector3d>& positions, double time, Side side) {
                return global_transforms(nodes, {"clip", 4, {{0, positions, {{{0, Eigen::Quaterniond::Identity()}}}, one}}}, time,
                                         side)[0](1, 3);
              };
              bool good = at(jump, 2, Side::before) == 2 && at(jump, 2, Side::after) == 8;
              for (const auto& [time, before, after] :
                   {std::tuple{0.0, 0.0, 0.0}, {1.9, 0.0, 0.0}, {2.0, 0.0, 2.0}, {3.0, 2.0, 5.0}, {4.0, 5.0, 5.0}})
                good = good && at(steps, time, Side::before) == before && at(steps, time, Side::after) == after;
              return Checked(good, 12);
            });
  t.example("a cubic spline has glTF's Hermite polynomials, and a rotation is normalised behind it", {}, [] {
    const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
    const Channel<Eigen::Vector3d> one{{{0, ones}}};
    const Eigen::Quaterniond a(1, 0, 0, 0), b(0, 1, 0, 0), slow(0.1, 0.2, 0.3, 0.4);
    const Channel<Eigen::Vector3d> positions{
        {{1, 2 * ones}, {3, 5 * ones}}, Interpolation::cubic, {{9 * ones, 3 * ones}, {7 * ones, 9 * ones}}};
    const Channel<Eigen::Quaterniond> rotations{{{1, a}, {3, b}}, Interpolation::cubic, {{a, slow}, {slow, b}}};
    const Animation motion{"clip", 4, {{0, positions, rotations, one}}};
    bool good = true;
    for (const double s : {0.0, 0.25, 0.7, 1.0}) {
      const double h00 = 2 * s * s * s - 3 * s * s + 1, h10 = s * s * s - 2 * s * s + s, h01 = 3 * s * s - 2 * s * s * s,
                   h11 = s * s * s - s * s;
      const Eigen::Matrix4d m = global_transforms({{"node", -1, Eigen::Matrix4d::Identity()}}, motion, 1 + 2 * s)[0];
      const Eigen::Quaterniond q(h00 * a.coeffs() + 2 * h10 * slow.coeffs() + h01 * b.coeffs() + 2 * h11 * slow.coeffs());
      good = good && std::abs(m(0, 3) - (2 * h00 + 6 * h10 + 5 * h01 + 14 * h11)) < 1e-14 &&
             (m.topLeftCorner<3, 3>() - q.normalized().toRotationMatrix()).norm() < 1e-14;
    }
    return Checked(good, 8);
  });
}

// Draws one to four keys at times in quarters of a second from 0.5 s on, which may coincide. Those of a spline are of nearly unit
// length, with tangents so small that no value between two keys gets near to 0.
Channel<Eigen::Quaterniond> drawn_rotations() {
  Channel<Eigen::Quaterniond> out{{}, *rc::gen::element(Interpolation::step, Interpolation::linear, Interpolation::cubic), {}};
  const bool cubic = out.interpolation == Interpolation::cubic;
  const auto tangent = [] { return Eigen::Quaterniond(0.1 * real(), 0.1 * real(), 0.1 * real(), 0.1 * real()); };
  double time = 0.5;
  for (int k = *gen::between(1, 5); k > 0; --k) {
    const Eigen::Quaterniond unit = Eigen::Quaterniond(1, 0.5 * real(), 0.5 * real(), 0.5 * real()).normalized();
    out.keys.push_back({time, Eigen::Quaterniond((cubic ? 1 + 0.01 * real() : 1) * unit.coeffs())});
    if (cubic) out.tangents.push_back({tangent(), tangent()});
    time += 0.25 * *gen::between(0, 4);
  }
  return out;
}

void rotations_that_are_of_unit_length(Suite& t) {
  t.holds(
      "rotations are of unit length at all times, and those before the first key and after the last are theirs",
      {.number_type = "double",
       .degenerate_at_least = 0.1,
       .tags_at_least = {{"a spline before its first key", 0.02}, {"a spline at or after its last key", 0.05}}},
      [] {
        const Channel<Eigen::Quaterniond> rotations = drawn_rotations();
        const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
        const double first = rotations.keys.front().time, last = rotations.keys.back().time, time = 0.125 * *gen::between(0, 30);
        const Side side = *rc::gen::element(Side::before, Side::after);
        const bool cubic = rotations.interpolation == Interpolation::cubic;
        RC_CLASSIFY(rotations.keys.size() == 1 || first == last, "degenerate");
        RC_CLASSIFY(cubic && time < first, "a spline before its first key");
        RC_CLASSIFY(cubic && time >= last, "a spline at or after its last key");
        const Eigen::Quaterniond q = transform_at({0, {{{0, ones}}}, rotations, {{{0, ones}}}}, time, side).rotation;
        RC_ASSERT(std::abs(q.norm() - 1) < 1e-14);
        const auto is_that_of = [&](const auto& key) { return (q.coeffs() - key.value.coeffs().normalized()).norm() < 1e-14; };
        if (time < first) RC_ASSERT(is_that_of(rotations.keys.front()));
        if (time > last) RC_ASSERT(is_that_of(rotations.keys.back()));
      });
}

}  // namespace

PROPTEST(skeleton_motion) {
  t.holds("a matrix that is a rotation but for a small symmetric stretch is posed by that very rotation",
          {.number_type = "double", .degenerate_at_least = 0.05}, [] {
            const Eigen::Vector4d drawn(real(), real(), real(), real());
            RC_PRE(drawn.norm() > 0.01);
            const Eigen::Quaterniond turn(Eigen::Vector4d(drawn.normalized()));
            const double size = *rc::gen::element(0.0, 1e-6, 1e-4, 5e-4);
            RC_CLASSIFY(size == 0, "degenerate");
            Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
            for (int i = 0; i < 3; ++i)
              for (int k = i; k < 3; ++k) stretch(i, k) = stretch(k, i) = stretch(i, k) + size * real();
            Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
            matrix.topLeftCorner<3, 3>() = turn.toRotationMatrix() * stretch;
            matrix.topRightCorner<3, 1>() = Eigen::Vector3d(real(), real(), real());

            const PosedSkeleton posed = palette_by(matrix);
            const auto& q = posed.pose[0].rotation;
            const Eigen::Vector4d expected(turn.w(), turn.x(), turn.y(), turn.z());
            RC_ASSERT(std::min((q - expected).norm(), (q + expected).norm()) < 1e-13);
            RC_ASSERT(posed.pose[0].translation == Eigen::Vector3d(matrix.topRightCorner<3, 1>()));
            const double defect = (stretch * stretch - Eigen::Matrix3d::Identity()).norm();
            RC_ASSERT(std::abs(posed.rigidity_defect - defect) < 1e-14);
            RC_ASSERT((turn.toRotationMatrix() - matrix.topLeftCorner<3, 3>()).norm() <= posed.rigidity_defect + 1e-14);
          });
  t.example("key times begin at 0, end at the duration, hold every key between, and are thinned evenly", {}, [] {
    Animation motion{"clip", 10, {{0, {}, {}, {}}}};
    for (int k = -1; k <= 11; ++k) motion.tracks[0].scales.keys.push_back({k + 0.5, Eigen::Vector3d::Ones()});
    const std::vector<double> all = key_times(motion, 12), some = key_times(motion, 4);
    return Checked(all == std::vector<double>{0, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10} &&
                       some == std::vector<double>{0, 2.5, 6.5, 10} &&
                       key_times(Animation{"moment", 0, {}}, 1) == std::vector<double>{0},
                   3);
  });
  what_is_no_rotation_is_measured_or_refused(t);
  t.example("the common scale is the middle one of the joints', a mirror its sign, and one within 1e-5 of 1 is 1", {}, [] {
    const auto factor = [](const std::vector<double>& scales) {
      BoundSkeleton skeleton{"test", {}, {}};
      for (std::size_t j = 0; j < scales.size(); ++j) {
        Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
        local.topLeftCorner<3, 3>() = Eigen::Vector3d(scales[j], std::abs(scales[j]), std::abs(scales[j])).asDiagonal();
        skeleton.nodes.push_back({"node", -1, local});
        skeleton.joints.push_back({"joint", static_cast<int>(j), -1, Eigen::Matrix4d::Identity()});
      }
      return Eigen::Vector3d(common_factor(skeleton, Animation{}, 0).diagonal().head<3>());
    };
    const auto is = [](const Eigen::Vector3d& found, double x, double scale) {
      return (found - Eigen::Vector3d(x, scale, scale)).norm() < 1e-12;
    };
    return is(factor({3, 0.5, 2}), 2, 2) && is(factor({5, 1, 1, 0.2, 7}), 1, 1) && is(factor({-2}), -2, 2) &&
           is(factor({1 + 9e-6}), 1, 1) && is(factor({1 + 1.2e-5}), 1 + 1.2e-5, 1 + 1.2e-5) &&
           is(factor({1 - 1.2e-5}), 1 - 1.2e-5, 1 - 1.2e-5) && is(factor({NAN}), 1, 1);
  });
  what_holds_at_keys(t);
  what_holds_between_keys_and_beyond_them(t);
  rotations_that_are_of_unit_length(t);
}

}  // namespace proptests::suite_skeleton_motion
