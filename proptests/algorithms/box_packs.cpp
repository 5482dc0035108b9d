// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/box_packs.hpp"

#include <random>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/cluster_tree.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "lemmas/exact/lift.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/opposite_joints.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_box_packs {
namespace {

using namespace refitlab;

std::vector<FlippedBox> bound(const Character& c, std::span<const int> nodes, Skinning skinning,
                              const SkinningPalette<double>& palette, const Quaternion<double>& rotation, Target target) {
  JointFloats joints(c.sets);
  joints.fill(palette, skinning);
  std::vector<FlippedBox> boxes(nodes.size());
  bound_boxes(make_box_pieces(c, nodes), skinning, joints, palette, rotation, boxes, target);
  return boxes;
}

// Returns how far the vertices of a node, skinned and turned, are outside of the box; infinity if the box is undefined.
double excess(const Character& c, int node, const std::vector<Point3>& turned, const FlippedBox& box) {
  double worst = -std::numeric_limits<double>::infinity();
  for (const int v : c.vertices[node])
    for (int i = 0; i < 3; ++i) {
      const double below = box.of[i] - turned[v][i], above = turned[v][i] + box.of[4 + i];
      if (std::isnan(below) || std::isnan(above)) return std::numeric_limits<double>::infinity();
      worst = std::max({worst, below, above});
    }
  return worst;
}

double width(const FlippedBox& b, int i) { return -double(b.of[4 + i]) - b.of[i]; }

bool is_everything(const FlippedBox& b) {
  for (const int i : {0, 1, 2, 4, 5, 6})
    if (b.of[i] != -std::numeric_limits<float>::infinity()) return false;
  return true;
}

// Returns what float may lose of a box of this size, both sides together, as box_kernel.cpp states.
double stated_slack(double size, int joints) { return size * (joints <= most_box_joints ? 0x1p-10 : 2e-5) + 1e-36; }

void boxes_hold_their_vertices(Suite& t) {
  t.holds("the boxes of all nodes hold their vertices, however joints are turned, in every skinning and for every target",
          {.number_type = "float", .cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            SkinnedMesh model = gen::make_mesh(plan);
            const Point3 offset = Point3(1, -2, 3) * *rc::gen::element(0, 0, 1000);
            for (Point3& v : model.vertices) v += offset;
            for (auto& joint : model.joints) joint.origin += offset;
            const auto c = bake(std::move(model));
            std::mt19937 random(plan.seed);
            const double spread = *rc::gen::element(0.0, 0.1, 0.5, 3.0);
            const Pose pose =
                gen::with_lengths(gen::random_pose(c.mesh, random, spread), gen::random_unit_length(random), random);
            const Quaternion<double> rotation =
                gen::with_length(gen::random_rotation(random, 1), gen::random_unit_length(random), random);
            std::vector<int> nodes;
            for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) nodes.push_back(n);
            const Skinning skinning = gen::drawn_skinning();
            const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
            auto turned = skin(c.mesh, c.sets, palette, skinning);
            for (auto& p : turned) p = rotate(rotation, p);
            for (const Target target : available_targets()) {
              const auto boxes = bound(c, nodes, skinning, palette, rotation, target);
              for (const int n : nodes) RC_ASSERT(excess(c, n, turned, boxes[n]) <= 0);
            }
            RC_TAG(name_of(best_target()));
          });
  t.holds("nor do they lose a vertex where joints are turned nearly opposite ways, so that blends of them nearly vanish",
          {.number_type = "float", .cases = 300, .tags_at_least = {{"beyond a right angle", 0.2}}}, [] {
            const gen::OppositeJoints soup = gen::opposite_joints(*rc::gen::arbitrary<unsigned>());
            const auto c = bake(soup.mesh);
            const Pose& pose = soup.pose;
            RC_TAG(gen::label_of(soup));
            std::vector<int> nodes;
            for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) nodes.push_back(n);
            const Skinning skinning = gen::drawn_skinning();
            const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
            const auto skinned = skin(c.mesh, c.sets, palette, skinning);
            for (const Target target : available_targets()) {
              const auto boxes = bound(c, nodes, skinning, palette, identity_quaternion<double>(), target);
              for (const int n : nodes) RC_ASSERT(excess(c, n, skinned, boxes[n]) <= 0);
            }
          });
}

// Makes a mesh of three joints, of which the first has next to no weight, and the others turn in nearly opposite directions from
// it. The blend is shorter than float's rounding of it, or not much longer.
SkinnedMesh mesh_of_short_blends(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  SkinnedMesh model;
  model.name = "short blends";
  for (int j = 0; j < 3; ++j)
    model.joints.push_back({"joint " + std::to_string(j), j - 1, Point3(u(random), u(random), u(random)) / 8});
  const Point3 at(u(random), u(random), u(random));
  const double of_first = std::exp2(-10 - static_cast<int>(random() % 10));
  for (int v = 0; v < 3; ++v) {
    model.vertices.push_back(at + Point3::Unit(v) * 0x1p-30);
    model.influences.emplace_back();
    for (const auto& [joint, w] : quantize_weights({{0, of_first}, {1, 0.5}, {2, 0.5}}))
      model.influences.back().push_back({joint, w});
  }
  model.triangles = {{0, 1, 2}};
  return model;
}

void boxes_of_blends_that_nearly_vanish(Suite& t) {
  t.holds(
      "nor do they where a blend is so short that floats lose which way it turns",
      {.number_type = "float", .cases = 1000, .tags_at_least = {{"shorter than 1/1000", 0.2}}}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        std::uniform_real_distribution<double> u(-1, 1), exponent(-6, 0);
        const auto c = bake(mesh_of_short_blends(random));
        Pose pose = reference_pose(c.mesh);
        const double off = std::pow(10, exponent(random));
        for (const int j : {1, 2}) {
          pose[j].rotation = {off * std::abs(u(random)), j == 1 ? 1. : -1., off * u(random), off * u(random)};
          pose[j].rotation.normalize();
        }
        const std::vector<int> root{0};
        for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
          const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
          const auto skinned = skin(c.mesh, c.sets, palette, skinning);
          for (const Target target : available_targets())
            RC_ASSERT(excess(c, 0, skinned, bound(c, root, skinning, palette, identity_quaternion<double>(), target)[0]) <= 0);
        }
        RC_TAG(off < 1e-3 ? "shorter than 1/1000" : "longer");
      });
}

void boxes_at_attained_bounds_and_far_away(Suite& t) {
  t.holds(
      "boxes hold vertices that are where the bound is attained, of 1 to 90 joints, at every scale, however long "
      "quaternions are; and are wider by no more than what rounding is allowed",
      {.number_type = "float", .cases = 3000}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const double unit =
            *rc::gen::element(1.0, 1.0, 1e-12, 1e-36, 1e-38, 1e-41, 1e-44, 1e-80, 1e-160, 1e-300, 1e12, 1e25, 1e30);
        const gen::Attained scene = gen::attained(random, {.unit = unit});
        const Skinning skinning = gen::random_skinning(random);
        const auto c = bake(scene.mesh, {.triangles_per_leaf = 8});
        const auto palette = make_skinning_palette(c.mesh, c.sets, scene.pose, skinning);
        auto turned = skin(c.mesh, c.sets, palette, skinning);
        for (auto& p : turned) p = rotate(scene.placement.rotation, p);
        const std::vector<int> root{0};
        const int joints = static_cast<int>(c.mesh.joints.size());
        for (const Target target : available_targets()) {
          const FlippedBox box = bound(c, root, skinning, palette, scene.placement.rotation, target)[0];
          RC_LOG() << scene.what;
          RC_ASSERT(excess(c, 0, turned, box) <= 0);
          RC_ASSERT(is_everything(box) == (skinning == Skinning::dual_quaternion && joints > most_box_joints));
          if (is_everything(box)) continue;
          for (int i = 0; i < 3; ++i) {
            const auto [low, high] =
                std::minmax_element(turned.begin(), turned.end(), [i](const Point3& p, const Point3& q) { return p[i] < q[i]; });
            const double exact = (*high)[i] - (*low)[i], diameter = 2 * c.tree.nodes[0].reference.radius;
            RC_ASSERT(width(box, i) <= std::max(exact, diameter) + stated_slack(3 * scene.size, joints));
          }
        }
        RC_TAG(std::to_string(joints) + " joints");
      });
  t.holds(
      "boxes hold vertices that are far away in the reference pose, near each other, and carried to the origin",
      {.number_type = "double", .cases = 3000}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        std::uniform_real_distribution<double> u(-1, 1);
        const int joints = *rc::gen::inRange(1, 9);
        const double near = *rc::gen::element(0.0, 1e-12, 1e-11, 1e-6);
        // The vertices are the farthest points of a ball along the axes, and nearly all of their weight is on one joint.
        const bool on_axes = *rc::gen::arbitrary<bool>();
        const Point3 away = Point3(u(random), u(random), u(random)).cast<float>().cast<double>() * 1024;
        SkinnedMesh model;
        model.name = "far away";
        for (int j = 0; j < joints; ++j) {
          const Point3 origin = *rc::gen::arbitrary<bool>() ? away : Point3(u(random), u(random), u(random));
          model.joints.push_back({"joint " + std::to_string(j), j - 1, origin});
        }
        for (int v = 0; v < 12; ++v) {
          model.vertices.push_back(
              away + (on_axes ? Point3(Point3::Unit(v % 3) * (v % 2 ? 1 : -1)) : Point3(u(random), u(random), u(random))) * near);
          std::vector<std::pair<int, double>> weights;
          for (int j = 0; j < joints; ++j) weights.emplace_back(j, on_axes && j == 0 ? 1e5 : 1.1 + u(random));
          model.influences.emplace_back();
          for (const auto& [joint, w] : quantize_weights(weights)) model.influences.back().push_back({joint, w});
          if (v % 3 == 2) model.triangles.push_back({v - 2, v - 1, v});
        }
        const auto c = bake(std::move(model));
        Pose pose = gen::random_pose(c.mesh, random, *rc::gen::element(1e-3, 0.1, 3.0));
        for (auto& joint : pose) joint.translation = -rotate(joint.rotation, away);
        const Skinning skinning = gen::random_skinning(random);
        const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
        const Quaternion<double> rotation = on_axes ? identity_quaternion<double>() : gen::random_rotation(random, 1);
        auto turned = skin(c.mesh, c.sets, palette, skinning);
        for (auto& p : turned) p = rotate(rotation, p);
        std::vector<int> nodes;
        for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) nodes.push_back(n);
        for (const Target target : available_targets()) {
          const auto boxes = bound(c, nodes, skinning, palette, rotation, target);
          for (const int n : nodes) RC_ASSERT(excess(c, n, turned, boxes[n]) <= 0);
        }
        RC_TAG(joints > most_box_joints ? "more joints than a pack takes" : "in packs");
      });
}

void joints_in_float(Suite& t) {
  t.holds("joints in float know the greatest of their coordinates, however small all are", {.number_type = "float", .cases = 100},
          [] {
            const auto plan = *gen::mesh_plan();
            const SkinnedMesh mesh = gen::make_mesh(plan);
            const JointSets sets(mesh);
            std::mt19937 random(plan.seed);
            Pose pose = gen::random_pose(mesh, random, 1);
            const double size = *rc::gen::element(1e-20, 1e-3, 1.0, 1e6);
            double greatest = 0;
            for (auto& joint : pose) {
              joint.translation *= size;
              greatest = std::max(greatest, joint.translation.cwiseAbs().maxCoeff());
            }
            JointFloats joints(sets);
            joints.fill(make_skinning_palette(mesh, sets, pose, Skinning::linear), Skinning::linear);
            RC_ASSERT(joints.largest <= static_cast<float>(greatest));
            for (const float x : joints.slots) RC_ASSERT(std::abs(x) <= std::max(joints.largest, 1.001f) && joints.largest >= 0);
            bool is_reached = greatest == 0;
            for (std::size_t i = 0; i < joints.slots.size(); ++i)
              is_reached = is_reached || (i % 8 > 3 && std::abs(joints.slots[i]) == joints.largest);
            RC_ASSERT(is_reached);
          });
  t.holds("what float does not hold has boxes without end, and none that leave a vertex out",
          {.number_type = "float", .cases = 3000}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            // The lengths are near the end of float's range, or anywhere from 1e34 to nearly 1e40.
            const bool nearly_holds = random() % 2;
            std::uniform_real_distribution<double> exponent(nearly_holds ? 37.5 : 34, nearly_holds ? 38.6 : 39.9), u(-1, 1);
            gen::Attained scene = gen::attained(random);
            enum { vertex, vertices, joint, center };
            const int what = *rc::gen::element<int>(vertex, vertices, joint, center);
            const auto any_joint = [&] { return static_cast<int>(random() % scene.pose.size()); };
            const double far = std::pow(10, exponent(random));
            const Point3 away = Point3(u(random), random() % 2 ? 0 : u(random), random() % 2 ? 0 : u(random)) * far;
            scene.placement.rotation = *rc::gen::element(scene.placement.rotation, identity_quaternion<double>());
            if (random() % 2) scene.pose[any_joint()].rotation = gen::random_rotation(random, 0.5);
            if (what == vertex) scene.mesh.vertices[random() % scene.mesh.vertices.size()] = away;
            if (what == vertices)
              for (Point3& v : scene.mesh.vertices) v += away;
            if (what == joint) scene.pose[any_joint()].translation = away;
            // The joints' origins are far away, and their images are where the vertices were.
            if (what == center)
              for (std::size_t j = 0; j < scene.pose.size(); ++j) {
                scene.mesh.joints[j].origin = away;
                scene.pose[j].translation = -rotate(scene.pose[j].rotation, away);
              }
            const auto c = bake(scene.mesh, {.triangles_per_leaf = 8});
            const Skinning skinning = gen::random_skinning(random);
            const auto palette = make_skinning_palette(c.mesh, c.sets, scene.pose, skinning);
            auto turned = skin(c.mesh, c.sets, palette, skinning);
            for (auto& p : turned) p = rotate(scene.placement.rotation, p);
            const std::vector<int> root{0};
            for (const Target target : available_targets())
              RC_ASSERT(excess(c, 0, turned, bound(c, root, skinning, palette, scene.placement.rotation, target)[0]) <= 0);
            RC_TAG(what == vertex     ? "a far vertex"
                   : what == vertices ? "far vertices"
                   : what == joint    ? "a joint that moves far"
                                      : "a far rotation center");
          });
}

}  // namespace

PROPTEST(box_packs) {
  boxes_hold_their_vertices(t);
  boxes_of_blends_that_nearly_vanish(t);
  boxes_at_attained_bounds_and_far_away(t);
  joints_in_float(t);
  t.example(
      "the ball of a node's piece, of float numbers, holds its vertices by the last bit, and is no more than a float's rounding "
      "larger",
      {}, [] {
        std::mt19937 random(2006);
        std::uniform_real_distribution<double> turn(0, 7);
        long beyond = 0;
        constexpr int tried = 500;
        for (int i = 0; i < tried; ++i) {
          const double angle = turn(random), unit = std::exp2(static_cast<int>(random() % 40) - 20);
          // The length is one unit, up to rounding.
          const Point3 v = Point3(std::cos(angle), std::sin(angle), 0) * unit;
          SkinnedMesh model;
          model.name = "across";
          model.vertices = {v, -v, v};
          model.triangles = {{0, 1, 2}};
          model.joints = {{"root", -1, {0, 0, 0}}};
          model.influences.assign(3, {{0, 1}});
          const auto c = bake(std::move(model));
          const Ball3<double> ball = pieces_of_nodes(c, std::vector<int>{0})[0].reference;
          for (const Point3& p : c.mesh.vertices)
            if (encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, convert<Rational>(p)) !=
                Verdict::holds)
              return Checked(false, i, "a vertex outside");
          if (ball.radius > unit * (1 + 0x1p-22) || ball.radius != static_cast<float>(ball.radius))
            return Checked(false, i, "no float, or too large");
          beyond += squared_norm(convert<Rational>(v)) > Rational(unit) * Rational(unit);
        }
        return Checked(beyond > tried / 5, tried, std::to_string(beyond) + " a little more than a float away");
      });
  t.example("a walking man's boxes are tight in every skinning, and the same for every target", {}, [] {
    const auto c = bake_animated(make_man());
    const auto pose = c.clips[0].sample(0.3 * c.clips[0].duration);
    const std::vector<int> nodes = [&] {
      std::vector<int> out;
      for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n)
        if (c.tree.nodes[n].level <= 8) out.push_back(n);
      return out;
    }();
    std::string text;
    long looked_at = 0;
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings) {
      const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
      const auto skinned = skin(c.mesh, c.sets, palette, skinning);
      double bounded = 0, exact = 0;
      const auto first = bound(c, nodes, skinning, palette, identity_quaternion<double>(), available_targets()[0]);
      for (const Target target : available_targets()) {
        const auto boxes = bound(c, nodes, skinning, palette, identity_quaternion<double>(), target);
        for (std::size_t n = 0; n < nodes.size(); ++n)
          for (int i = 0; i < 8; ++i) ok = ok && boxes[n].of[i] == first[n].of[i];
      }
      for (std::size_t n = 0; n < nodes.size(); ++n)
        for (int i = 0; i < 3; ++i) {
          double low = 1e300, high = -1e300;
          for (const int v : c.vertices[nodes[n]]) low = std::min(low, skinned[v][i]), high = std::max(high, skinned[v][i]);
          bounded += width(first[n], i), exact += high - low;
          ++looked_at;
        }
      ok = ok && bounded >= exact && bounded < 1.39 * exact;
      text += (text.empty() ? "sum of widths over that of the vertices' own boxes: " : ", ") + std::to_string(bounded / exact);
    }
    return Checked(ok, looked_at, text);
  });
}

}  // namespace proptests::suite_box_packs
