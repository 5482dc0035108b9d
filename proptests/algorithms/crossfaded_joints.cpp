// SPDX-License-Identifier: GPL-3.0-or-later
// Tests joints and vertices in a crossfade of two animations.
#include "algorithms/bake/over_time/crossfaded_joints.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/bound_over_time.hpp"
#include "algorithms/bake/over_time/half_turns.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace proptests::suite_crossfaded_joints {
namespace {

using namespace refitlab;
using M = MultiprecisionInterval;

// Holds a model and two animations of it.
struct Fade {
  gen::AnimatedPlan plan;
  Skinning skinning;
  RotationBlend blend;
  Model model;
  Animation first, second;

  Fade(const gen::AnimatedPlan& p, Skinning s, RotationBlend b)
      : plan(p),
        skinning(s),
        blend(b),
        model(gen::animated_model(plan)),
        first(model.clips[0].animation),
        second(gen::second_animation(plan, model)) {}
  static Fade draw(bool smooth) {
    const Skinning skinning =
        *rc::gen::element(Skinning::linear, Skinning::linear, Skinning::dual_quaternion, Skinning::spherical);
    const bool is_rigid = skinning != Skinning::linear;
    const auto plan = smooth ? gen::draw_smooth_plan(is_rigid) : gen::draw_animated_plan(is_rigid);
    const auto blend = *rc::gen::element(RotationBlend::slerp, RotationBlend::nlerp);
    RC_LOG() << plan << " skinning " << static_cast<int>(skinning) << (blend == RotationBlend::slerp ? " slerp" : " nlerp");
    RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
    return {plan, skinning, blend};
  }
  CrossfadedJoints joints() const {
    return {model, first, second, gen::all_of(model.joints), blend, skinning != Skinning::linear};
  }
};

// Returns all vertices at a moment, or nothing where the moment is ambiguous.
std::optional<std::vector<Vec<M, 3>>> skinned(oracle::AnimatedSkin<M>& skin, const Fade& fade, const ParameterMoment& moment) {
  const auto& c = moment.coordinates;
  try {
    skin.pose(c[0].value, c[0].side, fade.second, c[1].value, c[1].side, c[2].value, fade.blend == RotationBlend::nlerp,
              moment.signs);
    std::vector<Vec<M, 3>> out;
    for (std::size_t v = 0; v < fade.model.vertices.size(); ++v) out.push_back(skin.vertex(static_cast<int>(v)));
    return out;
  } catch (const oracle::Ambiguous&) {
    return std::nullopt;
  }
}

bool is_farther(const Vec<M, 3>& a, const Vec<M, 3>& b, double distance) {
  return less_equal(squared_distance<M, 3>(a, b), M(sq(M(distance)))) == Verdict::fails;
}

// Returns a box among those that a search could reach: it is halved again and again, by signs where the slack is unknown.
ParameterBox some_box(const CrossfadedJoints& joints, const MovingVertices& moving, std::mt19937& random) {
  ParameterBox box = joints.boxes()[0];
  const int halvings = static_cast<int>(random() % 30);
  for (int i = 0; i < halvings; ++i) {
    const CellSlack slack = moving.slack(joints.cell(box), Finite::may_be);
    std::size_t parameter = random() % 3;
    if (random() % 2 == 0)
      parameter = static_cast<std::size_t>(std::max_element(slack.chords.begin(), slack.chords.end()) - slack.chords.begin());
    const auto halves = joints.halves(box, parameter, slack.chords[parameter] < std::numeric_limits<double>::infinity());
    if (!halves.empty()) box = halves[random() % halves.size()];
  }
  return box;
}

bool is_refusal(const std::string& message) {
  for (const char* reason : {"passes through zero", "their blend may vanish", "the skin matrix", "no rotation and scale"})
    if (message.find(reason) != std::string::npos) return true;
  return false;
}

Verdict is_inside(const BoundOverTime& bound, std::span<const Point3> directions, const Vec<M, 3>& x) {
  M squared(0);
  for (int i = 0; i < 3; ++i) squared += sq(M(x[i] - M(bound.ball.center[i])));
  Verdict v = less_equal(squared, sq(M(bound.ball.radius)));
  for (std::size_t d = 0; d < directions.size(); ++d) {
    M along(0);
    for (int i = 0; i < 3; ++i) along += M(directions[d][i]) * x[i];
    v &= less_equal(M(bound.slabs[d].low), along) & less_equal(along, M(bound.slabs[d].high));
  }
  return v;
}

// Makes a joint at the origin that both clips hold still, at these angles about z (degrees), and a vertex on the x axis at 1.
struct Hinge {
  Model model;
  Animation first, second;
  Hinge(double from, double to) {
    model.name = model.skeleton.file = "hinge";
    model.skeleton.nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
    model.skeleton.joints = {{"joint", 0, -1, Eigen::Matrix4d::Identity()}};
    model.joints = {{"joint", -1, Point3::Zero()}};
    model.vertices = {{1, 0, 0}}, model.triangles = {{0, 0, 0}}, model.influences = {{{0, 1}}};
    first = held(from, "first"), second = held(to, "second");
  }
  static Eigen::Quaterniond turned(double degrees) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * 3.141592653589793 / 180, Eigen::Vector3d::UnitZ()));
  }
  static Animation held(double degrees, const std::string& name) {
    return {name, 1, {{0, {{{0, Eigen::Vector3d::Zero()}}}, {{{0, turned(degrees)}}}, {{{0, Eigen::Vector3d::Ones()}}}}}};
  }
  CrossfadedJoints joints(RotationBlend blend, bool with_poses) const {
    return {model, first, second, gen::all_of(model.joints), blend, with_poses};
  }
  BoundOverTime bound(RotationBlend blend, double tolerance = 0.01) const {
    const JointSets sets(model);
    return bound_over_time(joints(blend, false), MovingVertices(model, sets, Skinning::linear, {0}), {.tolerance = tolerance});
  }
};

// Says how much wider slabs are than what is seen of a crossfade between a smooth clip and one that is off by about a radian.
struct Closeness {
  // Vertices move by less than 1 % of what some joint of theirs moves.
  bool hardly_moves;
  double excess;  // This is the most by which a slab is wider than it may be.
};
Closeness closeness(const gen::AnimatedPlan& plan, RotationBlend blend) {
  Fade fade(plan, Skinning::linear, blend);
  // Near a half turn both ways are bounded, but one is seen.
  fade.second = fade.first;
  for (NodeTrack& track : fade.second.tracks) {
    const Eigen::Quaterniond by(Eigen::AngleAxisd(1, Eigen::Vector3d(0.36, 0.48, 0.8)));
    for (auto& key : track.rotations.keys) key.value = by * key.value;
    for (auto& tangents : track.rotations.tangents) tangents = {by * tangents.into, by * tangents.out};
    for (auto& key : track.positions.keys) key.value += Eigen::Vector3d::Constant(plan.unit / 2);
  }
  const JointSets sets(fade.model);
  const CrossfadedJoints joints = fade.joints();
  const MovingVertices vertices(fade.model, sets, Skinning::linear, gen::all_of(fade.model.vertices));
  const BoundOverTime bound = bound_over_time(joints, vertices, {.tolerance = 0.1});
  std::mt19937 random(plan.seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Point3> points;
  Box<double> seen = Box<double>::empty();
  std::map<std::pair<int, int>, Box<double>> images;  // by vertex and joint
  const auto any = [&](double length) {
    return random() % 4 == 0 ? length * static_cast<double>(random() % 2) : length * share(random);
  };
  for (int i = 0; i < 2000; ++i) {
    const ParameterMoment moment{{{any(plan.duration), Side::after}, {any(plan.duration), Side::after}, {any(1), Side::after}}};
    const auto posed = joints.at(moment);
    vertices.place(*posed, Followed::skinned, points);
    for (int v = 0; v < plan.vertices; ++v) {
      seen.merge(points[v]);
      for (const auto& by : fade.model.influences[v])
        images.try_emplace({v, by.joint}, Box<double>::empty())
            .first->second.merge((posed->matrices[by.joint] * fade.model.vertices[v].homogeneous()).head<3>());
    }
  }
  // The joint that moves a vertex farthest by itself moves it so far.
  double farthest = 0;
  for (const auto& [of, box] : images) farthest = std::max(farthest, box.edges().maxCoeff());
  const double longest = seen.edges().maxCoeff();
  const bool hardly_moves = longest < 0.01 * farthest;
  double excess = -std::numeric_limits<double>::infinity();
  for (int d = 0; d < 3; ++d)
    excess = std::max(excess, bound.slabs[d].high - bound.slabs[d].low - 1.1 * seen.edges()[d] - 0.06 * longest -
                                  (hardly_moves ? 0.02 * farthest : 0) - 1e-9 * plan.unit);
  return {hardly_moves, excess};
}

void crossfades_are_bounded_and_hardly_more(Suite& t) {
  t.holds("no vertex of a crossfade is outside of slabs and ball, at any times and weight",
          {.number_type = "multiprecision interval",
           .cases = 150,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"bounded", 0.6}}},
          [] {
            const Fade fade = Fade::draw(*rc::gen::inRange(0, 3) > 0);
            const JointSets sets(fade.model);
            oracle::AnimatedSkin<M> skin(fade.model, fade.first, fade.skinning);
            std::mt19937 random(fade.plan.seed + 10);
            std::uniform_real_distribution<double> share(0, 1);
            const std::vector<Point3> directions = {Point3::UnitX(), Point3::UnitY(), Point3::UnitZ(),
                                                    Point3(share(random), 1e3 * share(random), -share(random))};
            BoundOverTime bound;
            std::optional<CrossfadedJoints> joints;
            try {
              joints.emplace(fade.model, fade.first, fade.second, gen::all_of(fade.model.joints), fade.blend,
                             fade.skinning != Skinning::linear);
              bound = bound_over_time(*joints, MovingVertices(fade.model, sets, fade.skinning, gen::all_of(fade.model.vertices)),
                                      {std::array{0.1, 1.0, 1e6}[random() % 3], directions, 1 << 10});
            } catch (const ModelError& e) {
              RC_ASSERT(is_refusal(e.what()));
              RC_TAG("refused");
              return;
            }
            RC_TAG("bounded");
            for (int i = 0; i < 25; ++i) {
              ParameterMoment moment;
              for (const double end : {fade.first.duration, fade.second.duration, 1.0}) {
                const double value = random() % 4 == 0 ? (random() % 2 == 0 ? 0 : end) : end * share(random);
                moment.coordinates.push_back({value, random() % 2 == 0 ? Side::before : Side::after});
                if (value == 0) moment.coordinates.back().side = Side::after;
              }
              if (const auto points = skinned(skin, fade, moment))
                for (const Vec<M, 3>& x : *points) RC_ASSERT(is_inside(bound, directions, x) != Verdict::fails);
            }
          });
  t.holds("of clips that do not turn nodes far apart, the bound is little larger than what is seen in a crossfade",
          {.number_type = "double", .cases = 30, .degenerate_at_most = 0.9}, [] {
            auto plan = gen::draw_smooth_plan(false);
            plan.root_scale = 1;  // The bound of a sum is that of its terms, even if they cancel.
            const auto blend = *rc::gen::element(RotationBlend::slerp, RotationBlend::nlerp);
            RC_LOG() << plan << (blend == RotationBlend::slerp ? " slerp" : " nlerp");
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const auto [hardly_moves, excess] = closeness(plan, blend);
            if (hardly_moves) RC_TAG("hardly moves");
            RC_ASSERT(excess <= 0);
          });
  t.example("what a joint of the least share moves is bounded by the way of that joint, as closely as 65536 cells can", {}, [] {
    // All of the vertex's weight stays where it is, but 2e-6 of it, which moves by 5 units.
    gen::AnimatedPlan plan;
    plan.nodes = plan.joints = 4, plan.vertices = 1, plan.smooth = plan.cubic = true, plan.seed = 674693182;
    const auto [hardly_moves, excess] = closeness(plan, RotationBlend::slerp);
    return Checked(hardly_moves && excess <= 0, 1, std::to_string(excess));
  });
}

void what_is_near_half_a_turn(Suite& t) {
  t.example("half a turn is bounded both ways, and no farther, however many equal keys hold the joint", {}, [] {
    long tried = 0;
    for (const RotationBlend blend : {RotationBlend::slerp, RotationBlend::nlerp})
      for (const int keys : {2, 3, 5, 17}) {
        Hinge hinge(-90, 90);
        for (Animation* clip : {&hinge.first, &hinge.second}) {
          auto& list = clip->tracks[0].rotations.keys;
          for (int k = 1; k < keys; ++k) list.push_back({k / (keys - 1.0), list[0].value});
        }
        const BoundOverTime bound = hinge.bound(blend);
        ++tried;
        for (int d = 0; d < 2; ++d)
          if (!(bound.slabs[d].low <= -1 + d && bound.slabs[d].high >= 1 && bound.slabs[d].low > -1.01 &&
                bound.slabs[d].high < 1.01))
            return Checked(false, tried,
                           std::to_string(keys) + " keys: " + std::to_string(bound.slabs[d].low) + " to " +
                               std::to_string(bound.slabs[d].high));
      }
    return Checked(true, tried);
  });
  t.example("where a renderer in float may see the other sign of the rotations' cosine, both ways are bounded", {}, [] {
    long tried = 0;
    for (const RotationBlend blend : {RotationBlend::slerp, RotationBlend::nlerp})
      // The angles are in degrees, and the cosine is 9e-7 at most.
      for (const double beside : {-1e-4, -1e-6, 1e-12, 1e-6, 1e-4}) {
        const BoundOverTime bound = Hinge(-90, 90 + beside).bound(blend);
        ++tried;
        if (!(bound.slabs[0].low <= -1 && bound.slabs[0].high >= 1))
          return Checked(false, tried, std::to_string(bound.slabs[0].low) + " to " + std::to_string(bound.slabs[0].high));
      }
    return Checked(true, tried);
  });
  t.example("of keys that are half a turn apart one is told, joint by joint, unless nothing is between them", {}, [] {
    const auto turned = Hinge::turned;
    long tried = 0;
    for (const auto& [degrees, is_told] : {std::pair(180., true), std::pair(180 - 1e-4, true), std::pair(-180., true),
                                           std::pair(180 + 1e-4, true), std::pair(179.9, false), std::pair(90., false)})
      for (const Interpolation how : {Interpolation::linear, Interpolation::step}) {
        Hinge hinge(0, 0);
        Animation clip = hinge.first;
        auto& rotations = clip.tracks[0].rotations;
        rotations = {{{0, turned(10)}, {0.5, turned(20)}, {1, turned(20 + degrees)}}, how, {}};
        hinge.model.clips = {{"turns", 1, {}, clip}};
        const std::vector<std::string> told = half_turns(hinge.model);
        ++tried;
        const bool is_right =
            is_told && how == Interpolation::linear
                ? told.size() == 1 && told[0].find("clip 'turns', joint 'node', keys 1 and 2: are half a turn apart") == 0
                : told.empty();
        if (!is_right) return Checked(false, tried, std::to_string(degrees));
        rotations.keys = {{0.5, turned(20)}, {0.5, turned(20 + degrees)}};  // The clip jumps.
        hinge.model.clips = {{"turns", 1, {}, clip}};
        if (!half_turns(hinge.model).empty()) return Checked(false, tried, "a jump");
      }
    return Checked(true, tried);
  });
}

// Checks that all parts of such a clip are looked at, one by one.
Checked check_many_jumps() {
  long tried = 0;
  for (const int keys : {2, 40, 2500})
    for (const bool is_second : {false, true}) {
      Hinge hinge(0, 0);
      auto& positions = (is_second ? hinge.second : hinge.first).tracks[0].positions;
      positions = {{}, Interpolation::step, {}};
      Box<double> seen = Box<double>::empty();
      seen.merge(Point3(1, 0, 0));  // The other clip has the vertex there.
      for (int k = 0; k < keys; ++k) {
        positions.keys.push_back({k / static_cast<double>(keys), {2 * std::cos(3 * k), std::sin(5 * k), 0}});
        seen.merge(Point3(Point3(1, 0, 0) + positions.keys.back().value));
      }
      const BoundOverTime bound = hinge.bound(RotationBlend::slerp);
      for (int d = 0; d < 2; ++d)
        if (!(bound.slabs[d].low <= seen.low[d] && bound.slabs[d].high >= seen.high[d] &&
              bound.slabs[d].high - bound.slabs[d].low <= 1.02 * seen.edges()[d] + 0.001))
          return Checked(false, tried,
                         std::to_string(keys) + " keys: " + std::to_string(bound.slabs[d].low) + " to " +
                             std::to_string(bound.slabs[d].high));
      ++tried;
    }
  return Checked(true, tried);
}

void clips_that_jump(Suite& t) {
  t.example("a crossfade of a clip of thousands of jumps is bounded as closely as that of one of a few", {}, check_many_jumps);
  t.example("a clip that jumps, one number after another jump, is blended from where it is in between", {}, [] {
    long tried = 0;
    const auto turned = Hinge::turned;
    for (const auto& [start, end] :
         {std::pair(1 - 0x1p-53, 1.0), std::pair(1 + 0x1p-52, 1 + 0x1p-51), std::pair(1.0, 1 + 0x1p-52)})
      for (const bool is_second : {false, true}) {
        Hinge hinge(89, 89);
        Animation& jumps = is_second ? hinge.second : hinge.first;
        jumps.duration = end;
        jumps.tracks[0].rotations.keys = {
            {0, turned(89)}, {start, turned(89)}, {start, turned(-89)}, {end, turned(-89)}, {end, turned(89)}};
        const JointSets sets(hinge.model);
        const CrossfadedJoints joints = hinge.joints(RotationBlend::slerp, false);
        const AnimatedJoints first(hinge.model, hinge.first, false), second(hinge.model, hinge.second, false);
        const MovingJoints* const all[] = {&first, &second, &joints};
        const BoundOverTime bound =
            bound_over_time(all, MovingVertices(hinge.model, sets, Skinning::linear, {0}), {.tolerance = 0.2});
        ++tried;
        // Half-way between 89 degrees and -89 the vertex is at x = 1.
        if (!(bound.slabs[0].high >= 1)) return Checked(false, tried, std::to_string(bound.slabs[0].high));
      }
    return Checked(true, tried);
  });
}

void hands_half_way_between_clips(Suite& t) {
  t.example("half-way between two clips a hand is where neither has it, and the bound knows",
            {.hypothesis = "bounds hold in between"}, [] {
              bool good = true;
              for (const RotationBlend blend : {RotationBlend::slerp, RotationBlend::nlerp}) {
                const BoundOverTime bound = Hinge(-74, 74).bound(blend);
                good = good && bound.slabs[0].high >= 1 && bound.slabs[0].high < 1.01 && bound.slabs[0].low > 0.27 &&
                       std::abs(bound.slabs[1].high - std::sin(74 * 3.141592653589793 / 180)) < 0.01 &&
                       bound.slabs[2].high < 1e-3;
              }
              return Checked(good, 2);
            });
  t.example("between clips that are half a turn apart, both ways are bounded; a little less, and it is the shorter one", {}, [] {
    bool good = true;
    std::string seen = "of moments: ";
    for (const RotationBlend blend : {RotationBlend::slerp, RotationBlend::nlerp}) {
      const BoundOverTime both = Hinge(-90, 90).bound(blend), shorter = Hinge(-89, 89).bound(blend),
                          longer = Hinge(-91, 91).bound(blend);
      good = good && both.slabs[0].low <= -1 && both.slabs[0].high >= 1 && both.slabs[0].high < 1.01 &&
             shorter.slabs[0].low > 0 && shorter.slabs[0].high >= 1 && longer.slabs[0].high < 0 && longer.slabs[0].low <= -1;
      Hinge moments(-90, 90);
      moments.first.duration = moments.second.duration = 0;
      const BoundOverTime of_moments = moments.bound(blend);
      seen += std::to_string(of_moments.slabs[0].low) + " to " + std::to_string(of_moments.slabs[0].high) + "; ";
      good = good && of_moments.slabs[0].low <= -1 && of_moments.slabs[0].high >= 1 && of_moments.slabs[0].high < 1.01;
    }
    return Checked(good, 8, seen);
  });
  t.example("with weight 0 joints are as in the first clip, with weight 1 as in the second, each in its own time", {}, [] {
    Hinge hinge(0, 90);
    hinge.first.tracks[0].positions = {{{0, Eigen::Vector3d::Zero()}, {1, Eigen::Vector3d(2, 0, 0)}}};
    const CrossfadedJoints joints = hinge.joints(RotationBlend::slerp, true);
    const auto at = [&](double a, double b, double w) {
      return joints.at({{{a, Side::after}, {b, Side::after}, {w, Side::after}}});
    };
    const AnimatedJoints first(hinge.model, hinge.first, true), second(hinge.model, hinge.second, true);
    return at(0.5, 0.3, 0)->matrices[0].isApprox(first.at(0.5, Side::after)->matrices[0], 1e-14) &&
           at(0.5, 0.3, 1)->matrices[0].isApprox(second.at(0.3, Side::after)->matrices[0], 1e-14) &&
           std::abs(at(0.5, 0.3, 0.25)->matrices[0](0, 3) - 0.75) < 1e-14 && at(0.5, 0.3, 0.25)->pose.size() == 1;
  });
  t.example("a slerp by weight turns by that share of the angle", {}, [] {
    const Hinge hinge(0, 100);
    const CrossfadedJoints joints = hinge.joints(RotationBlend::slerp, true);
    for (const double weight : {0.1, 0.25, 0.5, 0.8}) {
      const auto matrix = joints.at({{{0, Side::after}, {0, Side::after}, {weight, Side::after}}})->matrices[0];
      const double angle = weight * 100 * 3.141592653589793 / 180;
      if (std::abs(matrix.topLeftCorner<3, 3>().trace() - (1 + 2 * std::cos(angle))) > 1e-12) return false;
    }
    return true;
  });
}

// Checks matrices that shear, are flat, or mirror along an axis that may be any of three, unless the file says which.
Checked check_matrices_without_parts() {
  const Eigen::Quaterniond turn = Hinge::turned(40);
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = 0.5;
  std::vector<std::pair<Eigen::Matrix3d, std::optional<NodeTransform>>> list{{shear, std::nullopt}};
  const Eigen::Matrix3d flat = Eigen::Vector3d(1, 0, 1).asDiagonal();
  list.emplace_back(flat, std::nullopt);
  for (const Eigen::Vector3d& scale : {Eigen::Vector3d(-1, 1, 1), Eigen::Vector3d(1, -1, 1), Eigen::Vector3d(1, 1, -1),
                                       Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(2, 3, -0.5)})
    for (const Eigen::Quaterniond& rotation : {Eigen::Quaterniond::Identity(), turn})
      list.emplace_back(Eigen::Matrix3d(rotation.toRotationMatrix() * scale.asDiagonal()),
                        NodeTransform{{0, 0, 0}, scale, rotation});
  long tried = 0;
  for (const auto& [linear, parts] : list)
    for (const bool is_second : {false, true}) {
      Hinge hinge(60, 0);
      (is_second ? hinge.second : hinge.first).tracks.clear();
      SceneNode& node = hinge.model.skeleton.nodes[0];
      node.local.topLeftCorner<3, 3>() = linear;
      std::string told = "accepted";
      try {
        hinge.joints(RotationBlend::slerp, false);
      } catch (const ModelError& e) {
        told = e.what();
      }
      const std::string clip = is_second ? "second" : "first";
      if (told != "hinge: clip '" + clip +
                      "', joint 'node': does not move in this clip, and its matrix is no rotation and scale to be blended")
        return Checked(false, tried, told);
      ++tried;
      if (!parts) continue;
      node.rest = parts;
      hinge.joints(RotationBlend::slerp, false);
    }
  return Checked(true, tried);
}

// Checks scales of which one vanishes or changes its sign. Between these the joint is flat, however little each of them differs
// from a rigid one.
Checked check_scales_that_change_their_signs() {
  const auto scale_of = [](int digits) { return Eigen::Vector3d(digits % 3 - 1, digits / 3 % 3 - 1, digits / 9 - 1); };
  for (int from = 0; from < 27; ++from)
    for (int to = 0; to < 27; ++to) {
      Hinge hinge(20, 60);
      hinge.first.tracks[0].scales.keys[0].value = scale_of(from);
      hinge.second.tracks[0].scales.keys[0].value = scale_of(to);
      const CrossfadedJoints joints = hinge.joints(RotationBlend::slerp, true);
      const double defect = joints.cell(joints.boxes()[0]).defect;
      const bool is_rigid = (scale_of(from).array() * scale_of(to).array() > 0).all();
      if (is_rigid ? !(defect < 1e-9) : !std::isinf(defect))
        return Checked(false, 27 * from + to, std::to_string(from) + " to " + std::to_string(to) + ": " + std::to_string(defect));
    }
  return Checked(true, 27 * 27);
}

void what_each_clip_moves(Suite& t) {
  t.example(
      "where a scale vanishes or changes its sign from one clip to the other, the joint may be far from rigid, and else is not",
      {}, check_scales_that_change_their_signs);
  t.example(
      "at its end a crossfade does not move with the first clip, at its start not with the second, and by weight from one to the "
      "other",
      {}, [] {
        long tried = 0;
        for (const RotationBlend blend : {RotationBlend::slerp, RotationBlend::nlerp})
          for (const bool is_end : {true, false}) {
            Hinge hinge(0, 60);
            auto& moving = (is_end ? hinge.first : hinge.second).tracks[0];
            const Eigen::Vector3d there(1, 0, 0), ones = Eigen::Vector3d::Ones();
            moving.positions = {{{0, there}, {1, Eigen::Vector3d(1, 5, 0)}}};
            moving.rotations = {
                {{0, Eigen::Quaterniond(Eigen::AngleAxisd(0.1, there))}, {1, Eigen::Quaterniond(Eigen::AngleAxisd(0.5, there))}}};
            moving.scales = {{{0, ones}, {1, 2 * ones}}};
            (is_end ? hinge.second : hinge.first).tracks[0].positions = {{{0, Eigen::Vector3d(-1, 0, 0)}}};
            const CrossfadedJoints joints = hinge.joints(blend, false);
            ParameterBox box = joints.boxes()[0];
            const double weight = is_end ? 1 : 0;
            box.ranges[2] = {0, 0, weight, weight};
            const auto cell = joints.cell(box);
            const ChainMotion<double> link = cell.motions[is_end ? 0 : 1]->links[0], by_weight = cell.motions[2]->links[0];
            ++tried;
            if (link.offset.speed != 0 || link.linear.speed != 0 || link.rotation.speed != 0 || by_weight.offset.speed < 2)
              return Checked(false, tried,
                             "speeds " + std::to_string(link.offset.speed) + " " + std::to_string(link.linear.speed) + " " +
                                 std::to_string(link.rotation.speed) + " " + std::to_string(by_weight.offset.speed));
          }
        return Checked(true, tried);
      });
  t.example("a node that one clip does not move is where it rests, by the parts that the file has", {}, [] {
    Hinge hinge(60, 0);
    hinge.second.tracks.clear();
    hinge.model.skeleton.nodes[0].local(0, 3) = 3;  // at rest
    const BoundOverTime bound = hinge.bound(RotationBlend::slerp);
    bool good = bound.slabs[0].high >= 4 && bound.slabs[0].low <= 0.5 && bound.slabs[0].high < 4.1;
    // Other parts would make the same matrix.
    hinge.model.skeleton.nodes[0].rest = NodeTransform{{0, 0, 0}, {-1, -1, 1}, Eigen::Quaterniond(0, 0, 0, 1)};
    hinge.model.skeleton.nodes[0].local = Eigen::Matrix4d::Identity();
    const BoundOverTime by_parts = hinge.bound(RotationBlend::slerp);
    return Checked(good && by_parts.slabs[0].low < 0.1, 2);
  });
  t.example("a node that one clip does not move is refused by name if its matrix does not say by which parts it is to be blended",
            {}, check_matrices_without_parts);
  t.example("a model without keys is refused by name", {}, [] {
    Hinge hinge(0, 0);
    hinge.model.skeleton.joints.clear();
    try {
      hinge.joints(RotationBlend::slerp, false);
    } catch (const ModelError& e) {
      return std::string(e.what()) == "hinge: clip 'first': it has no keys, and nothing is known of it between poses";
    }
    return false;
  });
}

// Checks that, while one clip fades to the other, each morph weight moves at most as fast as the cell says.
void check_speeds_of_weights() {
  const Fade fade = Fade::draw(*rc::gen::inRange(0, 3) == 0);
  const JointSets sets(fade.model);
  std::mt19937 random(fade.plan.seed + 9);
  long opposite = 0;
  try {
    const CrossfadedJoints joints = fade.joints();
    const MovingVertices moving(fade.model, sets, fade.skinning, gen::all_of(fade.model.vertices));
    for (int i = 0; i < 4; ++i) {
      const ParameterBox box = some_box(joints, moving, random);
      const JointCell cell = joints.cell(box);
      for (const double share : {0.25, 0.5, 0.75}) {
        ParameterMoment ends[2];
        for (int end = 0; end < 2; ++end) {
          ends[end].signs = box.signs;
          for (int k = 0; k < 2; ++k)
            ends[end].coordinates.push_back(
                {box.ranges[k].start + share * (box.ranges[k].end - box.ranges[k].start), Side::after});
          ends[end].coordinates.push_back({static_cast<double>(end), Side::after});
        }
        const auto from = joints.at(ends[0]), to = joints.at(ends[1]);
        for (std::size_t m = 0; m < from->weights.size(); ++m)
          for (Eigen::Index k = 0; k < from->weights[m].size(); ++k) {
            const double apart = std::abs(to->weights[m][k] - from->weights[m][k]);
            opposite += to->weights[m][k] * from->weights[m][k] < 0 ? 1 : 0;
            RC_ASSERT(apart <= cell.motions[2]->weights[m][static_cast<std::size_t>(k)].speed * (1 + 1e-12) + 1e-12);
          }
      }
    }
  } catch (const ModelError& e) {
    RC_ASSERT(is_refusal(e.what()));
    RC_TAG("refused");
  }
  RC_CLASSIFY(opposite > 0, "weights of opposite signs");
}

void weights_that_fade_and_ranges_without_halves(Suite& t) {
  t.holds(
      "while one clip fades to the other, morph weights move no faster than is known",
      {.number_type = "double", .cases = 200, .degenerate_at_most = 0.9, .tags_at_least = {{"weights of opposite signs", 0.05}}},
      check_speeds_of_weights);
  t.example("a range between neighbouring numbers has no halves, whichever parameter it is of", {}, [] {
    const Hinge hinge(0, 60);
    const CrossfadedJoints joints = hinge.joints(RotationBlend::slerp, false);
    long wrong = 0;
    for (const std::size_t parameter : {0, 1, 2})
      for (const double start : {0.5, 0.5 + 0x1p-53}) {  // The last digit is even, then odd.
        ParameterBox box = joints.boxes()[0];
        box.ranges[parameter].start = start, box.ranges[parameter].end = start + 0x1p-53;
        wrong += !joints.halves(box, parameter, true).empty();
        box.ranges[parameter].end = start + 0x1p-52;
        wrong += joints.halves(box, parameter, true).size() != 2;
      }
    return Checked(wrong == 0, 12);
  });
}

std::vector<ParameterRange> single_parts(const FadingClip& clip) {
  std::vector<ParameterRange> parts, todo{clip.whole()};
  while (!todo.empty()) {
    const ParameterRange range = todo.back();
    todo.pop_back();
    if (range.first_part == range.last_part) {
      parts.push_back(range);
      continue;
    }
    const auto halves = clip.halves(range);
    todo.push_back(halves[1]), todo.push_back(halves[0]);
  }
  return parts;
}

// Says whether one motion's bounds cover another's. What does not move bends nowhere.
bool covers(const Motion<double>& several, const Motion<double>& one) {
  return several.size >= one.size && several.speed >= one.speed &&
         (several.acceleration >= one.acceleration || several.speed == 0);
}

bool covers(const FadingClip::Motions& several, const FadingClip::Motions& one) {
  bool good = several.rounding >= one.rounding;
  for (std::size_t i = 0; i < one.tracks.size(); ++i)
    good = good && covers(several.tracks[i].translation, one.tracks[i].translation) &&
           covers(several.tracks[i].rotation, one.tracks[i].rotation) && covers(several.tracks[i].scale, one.tracks[i].scale);
  for (std::size_t m = 0; m < one.weights.size(); ++m)
    for (std::size_t k = 0; k < one.weights[m].size(); ++k) good = good && covers(several.weights[m][k], one.weights[m][k]);
  for (std::size_t n = 0; n < one.stretches.size(); ++n)
    good = good && several.stretches[n].least <= one.stretches[n].least && several.stretches[n].most >= one.stretches[n].most;
  return good;
}

// Says whether nothing moves farther from one moment of a clip to another than its speed allows, but for rounding.
bool goes_as_far(const FadingClip& clip, const FadingClip::Motions& motions, const ParameterRange& from,
                 const ParameterRange& to) {
  const double length = to.end - from.start;
  const Side side = side_of_end(to.start, to.end);
  if (!(length > 0)) return true;
  const auto allows = [&](const Motion<double>& motion, double distance) {
    return distance <= motion.speed * length * (1 + 1e-9) + 1e-6 * motion.size;
  };
  bool good = true;
  for (std::size_t i = 0; i < clip.tracks().size(); ++i) {
    const NodeTransform p = transform_at(clip.tracks()[i], from.start, Side::after),
                        q = transform_at(clip.tracks()[i], to.end, side);
    const double turned =
        std::min((p.rotation.coeffs() - q.rotation.coeffs()).norm(), (p.rotation.coeffs() + q.rotation.coeffs()).norm());
    good = good && allows(motions.tracks[i].translation, (p.translation - q.translation).norm()) &&
           allows(motions.tracks[i].rotation, turned) &&
           allows(motions.tracks[i].scale, (p.scale - q.scale).cwiseAbs().maxCoeff());
  }
  for (std::size_t m = 0; m < motions.weights.size(); ++m) {
    const Eigen::VectorXd w = clip.weights(m, from.start, Side::after) - clip.weights(m, to.end, side);
    for (std::size_t k = 0; k < motions.weights[m].size(); ++k)
      good = good && allows(motions.weights[m][k], std::abs(w[static_cast<Eigen::Index>(k)]));
  }
  return good;
}

void check_motions_of_several_parts() {
  const Fade fade = Fade::draw(*rc::gen::inRange(0, 4) == 0);
  std::mt19937 random(fade.plan.seed + 11);
  bool has_several = false, is_rounded_more = false;
  try {
    const FadingClip clip(fade.model, fade.first, fade.second, gen::all_of(fade.model.joints), fade.skinning != Skinning::linear);
    const std::vector<ParameterRange> parts = single_parts(clip);
    for (int i = 0; i < 6; ++i) {
      std::size_t first = random() % parts.size(), last = random() % parts.size();
      if (first > last) std::swap(first, last);
      const auto all = clip.motions(static_cast<int>(first), static_cast<int>(last));
      const double at_first = clip.motions(static_cast<int>(first), static_cast<int>(first))->rounding;
      has_several = has_several || first < last;
      for (int part = static_cast<int>(first); part <= static_cast<int>(last); ++part) {
        RC_ASSERT(covers(*all, *clip.motions(part, part)));
        is_rounded_more = is_rounded_more || clip.motions(part, part)->rounding > at_first;
      }
      RC_ASSERT(goes_as_far(clip, *all, parts[first], parts[last]));
    }
  } catch (const ModelError& e) {
    RC_ASSERT(is_refusal(e.what()));
    RC_TAG("refused");
  }
  if (has_several) RC_TAG("several parts");
  if (is_rounded_more) RC_TAG("a later part is rounded more");
}

// Returns the corners of a cell at which the parameter has this value.
std::set<ParameterMoment> corners_at(const JointCell& cell, std::size_t parameter, double value) {
  std::set<ParameterMoment> out;
  for (const ParameterMoment& corner : cell.corners)
    if (corner.coordinates[parameter].value == value) out.insert(corner);
  return out;
}

void check_cells_of_exchanged_clips_and_of_halves() {
  const Fade fade = Fade::draw(*rc::gen::inRange(0, 4) == 0);
  const JointSets sets(fade.model);
  std::mt19937 random(fade.plan.seed + 12);
  bool is_halved = false;
  try {
    const CrossfadedJoints joints = fade.joints();
    const CrossfadedJoints exchanged(fade.model, fade.second, fade.first, gen::all_of(fade.model.joints), fade.blend,
                                     fade.skinning != Skinning::linear);
    const MovingVertices moving(fade.model, sets, fade.skinning, gen::all_of(fade.model.vertices));
    for (int i = 0; i < 4; ++i) {
      const ParameterBox box = some_box(joints, moving, random);
      const JointCell cell = joints.cell(box);
      const auto& [a, b, w] = std::tie(box.ranges[0], box.ranges[1], box.ranges[2]);
      const JointCell other = exchanged.cell({{b, a, {0, 0, 1 - w.end, 1 - w.start}}});
      RC_ASSERT(cell.rounding == other.rounding && cell.defect == other.defect);
      for (std::size_t k = 0; k < 3; ++k) {
        // At a key, or where signs are chosen, the same time is a different moment from each side.
        if (k < 2 && (!box.signs.empty() || box.ranges[k].first_part < box.ranges[k].last_part)) continue;
        const auto halves = joints.halves(box, k, true);
        if (halves.empty()) continue;
        is_halved = true;
        const double middle = halves[1].ranges[k].start;
        RC_ASSERT(corners_at(joints.cell(halves[0]), k, middle) == corners_at(joints.cell(halves[1]), k, middle));
      }
    }
  } catch (const ModelError& e) {
    RC_ASSERT(is_refusal(e.what()));
    RC_TAG("refused");
  }
  if (is_halved) RC_TAG("halved");
}

void what_is_known_of_several_parts_and_of_neighbours(Suite& t) {
  t.holds(
      "of several parts of a clip no less is known than of each, and nothing goes farther from one to another, even if it jumps",
      {.number_type = "double",
       .cases = 300,
       .degenerate_at_most = 0.9,
       .tags_at_least = {{"several parts", 0.5}, {"a later part is rounded more", 0.05}}},
      check_motions_of_several_parts);
  t.holds(
      "a cell is as little rounded and as rigid if both clips are exchanged, and a half of it has its corners in common with the "
      "other",
      {.number_type = "double", .cases = 200, .degenerate_at_most = 0.9, .tags_at_least = {{"halved", 0.5}}},
      check_cells_of_exchanged_clips_and_of_halves);
}

PROPTEST(crossfaded_joints) {
  crossfades_are_bounded_and_hardly_more(t);
  weights_that_fade_and_ranges_without_halves(t);
  what_is_known_of_several_parts_and_of_neighbours(t);
  hands_half_way_between_clips(t);
  what_is_near_half_a_turn(t);
  clips_that_jump(t);
  what_each_clip_moves(t);
  t.holds("a vertex is as near to what is between the eight corners as the slack says, or to its linear blend, which is",
          {.number_type = "multiprecision interval",
           .cases = 400,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"bounded", 0.7}, {"of several parts", 0.05}, {"by a sign", 0.02}, {"by its linear blend", 0.05}}},
          [] {
            const Fade fade = Fade::draw(*rc::gen::inRange(0, 3) == 0);
            const JointSets sets(fade.model);
            oracle::AnimatedSkin<M> skin(fade.model, fade.first, fade.skinning), linear(fade.model, fade.first, Skinning::linear);
            std::mt19937 random(fade.plan.seed + 9);
            std::uniform_real_distribution<double> share(0, 1);
            try {
              const CrossfadedJoints joints = fade.joints();
              const MovingVertices moving(fade.model, sets, fade.skinning, gen::all_of(fade.model.vertices));
              for (int i = 0; i < 4; ++i) {
                const ParameterBox box = some_box(joints, moving, random);
                const JointCell cell = joints.cell(box);
                CellSlack slack = moving.slack(cell, Finite::may_be);
                if (!std::isfinite(slack.chord)) {
                  RC_TAG("not known");
                  continue;
                }
                RC_TAG("bounded");
                if (box.ranges[0].first_part < box.ranges[0].last_part || box.ranges[1].first_part < box.ranges[1].last_part)
                  RC_TAG("of several parts");
                if (!box.signs.empty()) RC_TAG("by a sign");
                const double error = moving.placing_error(cell);
                const bool itself = slack.followed == Followed::skinned;
                if (!itself) RC_TAG("by its linear blend");
                auto& followed = itself ? skin : linear;
                std::vector<std::vector<Vec<M, 3>>> corners;
                for (const ParameterMoment& corner : cell.corners)
                  if (const auto at = skinned(followed, fade, corner)) corners.push_back(*at);
                ParameterMoment inside{{}, box.signs};
                M shares[3];
                for (int k = 0; k < 3; ++k) {
                  const ParameterRange& range = box.ranges[k];
                  double value = random() % 3 == 0 ? range.start + (range.end - range.start) / 2
                                                   : range.start + (range.end - range.start) * share(random);
                  if (!(range.start < value && value < range.end)) value = range.start;
                  inside.coordinates.push_back({value, Side::after});
                  shares[k] = range.start < range.end ? M((M(value) - M(range.start)) / (M(range.end) - M(range.start))) : M(0);
                }
                // Between jumps of several parts both sides of a time are the same, but for the range's own ends.
                const auto point = skinned(followed, fade, inside), vertex = skinned(skin, fade, inside);
                if (corners.size() < 8 || !point || !vertex) {
                  RC_TAG("undecided");
                  continue;
                }
                for (std::size_t v = 0; v < point->size(); ++v) {
                  Vec<M, 3> between(M(0), M(0), M(0));
                  for (std::size_t c = 0; c < 8; ++c) {
                    M weight(1);
                    for (std::size_t k = 0; k < 3; ++k) weight *= (c >> k & 1) != 0 ? shares[k] : M(M(1) - shares[k]);
                    between = between + corners[c][v] * weight;
                  }
                  RC_ASSERT(!is_farther((*point)[v], between, slack.chord + error));
                  if (!itself) RC_ASSERT(!is_farther((*point)[v], (*vertex)[v], slack.beyond[v] + error));
                }
              }
            } catch (const ModelError& e) {
              RC_ASSERT(is_refusal(e.what()));
              RC_TAG("refused");
            }
          });
}

}  // namespace
}  // namespace proptests::suite_crossfaded_joints
