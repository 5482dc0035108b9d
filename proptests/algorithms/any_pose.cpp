// SPDX-License-Identifier: GPL-3.0-or-later
// Tests bounds of any pose: whatever quaternions turn the joints, vertices stay within the radius.
#include "algorithms/bake/over_time/any_pose.hpp"

#include <algorithm>
#include <map>
#include <random>

#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/model_bounds.hpp"
#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/gen/model_of_nodes.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_any_pose {
namespace {

using namespace refitlab;

Eigen::Quaterniond drawn_rotation() {
  Eigen::Vector4d q;
  do
    for (double& x : q) x = *rc::gen::inRange(-10, 11);
  while (q.isZero());
  return Eigen::Quaterniond(Eigen::Vector4d(q.normalized()));
}

// Returns the clip with every animated node turned in a random way for all its time. Translations and scales stay as they are.
Animation turned_anyhow(const Animation& clip) {
  Animation out = clip;
  for (NodeTrack& track : out.tracks) track.rotations = {{{0, drawn_rotation()}}, Interpolation::linear, {}};
  return out;
}

Eigen::Matrix4d moved_by(const Point3& by) {
  Eigen::Matrix4d out = Eigen::Matrix4d::Identity();
  out.topRightCorner<3, 1>() = by;
  return out;
}

// Keeps two joints of each vertex, those with the greatest weights.
void leave_two_joints(Model& model) {
  for (std::vector<Influence>& influences : model.influences) {
    if (influences.size() <= 2) continue;
    std::sort(influences.begin(), influences.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    std::vector<std::pair<int, double>> kept;
    for (const std::size_t i : {0u, 1u}) kept.emplace_back(influences[i].joint, influences[i].weight);
    influences.clear();
    for (const auto& [joint, weight] : quantize_weights(kept)) influences.push_back({joint, weight});
  }
}

int root_above(const Model& model, int joint) {
  int node = model.skeleton.joints[static_cast<std::size_t>(joint)].node;
  while (model.skeleton.nodes[static_cast<std::size_t>(node)].parent >= 0)
    node = model.skeleton.nodes[static_cast<std::size_t>(node)].parent;
  return node;
}

// Says whether there is a ball for any pose of all vertices: the joints are of one tree, and vertices that are not blended
// linearly have at most two of them.
bool has_ball(const Model& model, Skinning skinning) {
  const int root = root_above(model, model.influences[0][0].joint);
  for (const std::vector<Influence>& influences : model.influences) {
    if (skinning != Skinning::linear && influences.size() > 2) return false;
    for (const Influence& influence : influences)
      if (root_above(model, influence.joint) != root) return false;
  }
  return true;
}

void check_turned_vertices(const Model& model, Skinning skinning, const AnyPoseBound& bound) {
  const JointSets sets(model);
  const std::vector<int> all = gen::all_of(model.vertices);
  const Animation turned = turned_anyhow(model.clips[0].animation);
  const AnimatedJoints joints(model, turned, skinning != Skinning::linear);
  const MovingVertices vertices(model, sets, skinning, all);
  std::vector<Point3> points;
  const double time = turned.duration * *rc::gen::inRange(0, 11) / 10;
  const auto globals = global_transforms(model.skeleton.nodes, turned, time);
  try {
    joints.at(time, Side::after);
  } catch (const ModelError&) {
    RC_TAG("turned, its scales are no noise");
    return;
  }
  RC_TAG(skinning == Skinning::linear ? "linear" : "blended rotations");
  vertices.place(*joints.at(time, Side::after), Followed::skinned, points);
  const Point3 center = globals[static_cast<std::size_t>(bound.node)].topRightCorner<3, 1>();
  const int part = std::clamp(
      static_cast<int>(std::upper_bound(joints.times().begin(), joints.times().end(), time) - joints.times().begin()) - 1, 0,
      joints.part_count() - 1);
  // Both are placed in double. The bound deals with skin matrices that are no rotations.
  JointCell cell = joints.cell(part, joints.times()[part], joints.times()[part + 1]);
  cell.defect = 0;
  const double error = 2 * vertices.placing_error(cell) + 1e-12 * (center.norm() + bound.radius);
  for (const Point3& p : points) RC_ASSERT((p - center).norm() <= bound.radius + error);
  if (skinning != Skinning::linear) return;
  // A renderer rounds both in the scene's frame, and loses no less than this of how far they are from the origin there.
  const double lost = *rc::gen::element(0x1p-19, 1e-3, 1.0);
  const double wider = bound_any_pose(model, sets, all, skinning, lost).value().radius - bound.radius;
  for (const Point3& p : points)
    RC_ASSERT(lost * (p.norm() + center.norm()) <= wider * (1 + 1e-9) + error + 1e-12 * bound.radius);
}

void vertices_stay_within_the_radius(Suite& t) {
  for (const bool rigid : {false, true})
    t.holds(rigid ? "rigid joints: vertices stay within the radius by linear blending, and by dual quaternions and spherically, "
                    "for which "
                    "there is one of two joints at most"
                  : "affine joints: vertices stay within the radius of the node, however joints are turned",
            {.number_type = "double",
             .cases = 300,
             .degenerate_at_most = 0.9,
             .tags_at_least = rigid ? std::map<std::string, double>{{"blended rotations", 0.3}, {"too many joints", 0.1}}
                                    : std::map<std::string, double>{{"linear", 0.3}}},
            [rigid] {
              const gen::AnimatedPlan plan = gen::draw_animated_plan(rigid);
              Model model = gen::animated_model(plan);
              RC_LOG() << plan;
              RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
              if (rigid && plan.seed % 2 == 0) leave_two_joints(model);
              for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}) {
                if (!rigid && skinning != Skinning::linear) continue;
                const std::optional<AnyPoseBound> bound =
                    bound_any_pose(model, JointSets(model), gen::all_of(model.vertices), skinning);
                RC_ASSERT(bound.has_value() == has_ball(model, skinning));
                if (bound) check_turned_vertices(model, skinning, *bound);
                else RC_TAG(has_ball(model, Skinning::linear) ? "too many joints" : "no node above all joints");
              }
            });
}

// Checks that a joint whose weight is rounded to 0 may carry a vertex just as far as another.
void check_lost_influences() {
  const gen::AnimatedPlan plan = gen::draw_animated_plan(true);
  Model whole = gen::animated_model(plan);
  RC_LOG() << plan;
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  if (plan.seed % 2 == 0) leave_two_joints(whole);
  Model model = whole;
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    std::vector<Influence>& influences = model.influences[v];
    if (influences.size() < 2) continue;
    model.lost_influences.push_back({static_cast<int>(v), influences.back().joint, 1e-9});
    influences.pop_back();
    std::vector<std::pair<int, double>> kept;
    for (const Influence& i : influences) kept.emplace_back(i.joint, i.weight);
    influences.clear();
    for (const auto& [joint, weight] : quantize_weights(kept)) influences.push_back({joint, weight});
    RC_TAG("lost");
  }
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion}) {
    const auto all = gen::all_of(model.vertices);
    const auto bound = bound_any_pose(model, JointSets(model), all, skinning),
               of_whole = bound_any_pose(whole, JointSets(whole), all, skinning);
    RC_ASSERT(bound.has_value() == of_whole.has_value());
    if (bound) RC_ASSERT(bound->node == of_whole->node && std::abs(bound->radius / of_whole->radius - 1) < 1e-12);
  }
}

// Checks three joints of which two come to lie on opposite sides.
Checked check_opposite_joints() {
  const Point3 places[] = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
  std::vector<SceneNode> nodes;
  for (int j = 0; j < 3; ++j) nodes.push_back({"node " + std::to_string(j), j == 0 ? -1 : 0, moved_by(places[j])});
  Model model = gen::model_of_nodes("fork", nodes);
  model.vertices = {{0, 0.5, 0}}, model.triangles = {{0, 0, 0}};
  const std::vector<Influence> three = {{0, 0.0625}, {1, 0.46875}, {2, 0.46875}}, two = {{1, 0.5}, {2, 0.5}};
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical})
    for (const bool has_three : {false, true}) {
      model.influences = {has_three ? three : two};
      const bool is_bounded = bound_any_pose(model, JointSets(model), std::vector<int>{0}, skinning).has_value();
      if (is_bounded != (skinning == Skinning::linear || !has_three))
        return Checked(false, 6, std::to_string(static_cast<int>(skinning)) + (has_three ? ": three" : ": two"));
    }
  return Checked(true, 6);
}

// Makes a node at a place, with a joint that has the vertices there in the reference pose.
Model thing_at(const Eigen::Matrix4d& local, const Eigen::Matrix4d& offset, std::vector<Point3> vertices) {
  Model model;
  model.name = model.skeleton.file = "thing";
  model.skeleton.nodes = {{"node", -1, local}};
  model.skeleton.joints = {{"joint", 0, -1, offset}};
  model.joints = {{"joint", -1, {0, 0, 0}}};
  model.triangles = {{0, 1, 2}};
  model.influences.assign(vertices.size(), {{0, 1.0}});
  model.vertices = std::move(vertices);
  validate(model);
  return model;
}

// Checks a vertex at its joint that morph targets move along one line, all in the same direction. Clips have other weights.
Checked check_rounding_of_displacements() {
  long tried = 0;
  for (const std::vector<double>& weights : {std::vector<double>{1}, {-1, 2}, {0.5, 0, -3}})
    for (const double far : {1.0, 1e6})
      for (const double in_clip : {0.0, 0.25, 4.0})
        for (const double lost : {0.0, 0x1p-19, 0.5}) {
          Model model = thing_at(Eigen::Matrix4d::Identity(), Eigen::Matrix4d::Identity(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
          MorphedMesh mesh{0, weights, {}};
          double away = 0;
          for (std::size_t t = 0; t < weights.size(); ++t) {
            const Point3 by(std::copysign(far, weights[t]), 0, 0);
            mesh.targets.push_back({{{0, by}, {1, by}}});
            away += std::max(in_clip, 1.0) * std::abs(weights[t]) * far;
          }
          model.morphs = {mesh};
          const Eigen::VectorXd moved =
              in_clip * Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
          Animation animation{"moves", 1, {}};
          animation.weight_tracks.push_back({0, {{{0, moved}}, Interpolation::linear, {}}});
          model.clips.push_back({"moves", 1, {}, animation});
          validate(model);
          const double radius =
              bound_any_pose(model, JointSets(model), std::vector<int>{0}, Skinning::linear, lost).value().radius;
          if (!((1 + lost) * away <= radius && radius <= (1 + lost) * away * (1 + 1e-8)))
            return Checked(false, tried, std::to_string(away) + " by " + std::to_string(lost) + ": " + std::to_string(radius));
          ++tried;
        }
  return Checked(true, tried);
}

// Checks links in a row, of any lengths and scales, and a vertex at the tip that the root's joint moves, too.
Checked check_stretched_arms() {
  std::mt19937 random(7);
  const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  const auto digits = [&] { return std::uniform_real_distribution<double>(1, 2)(random); };
  long tried = 0;
  for (; tried < 300; ++tried) {
    std::vector<SceneNode> nodes;
    const int links = pick(2, 6);
    const bool has_scales = pick(0, 1) == 1;
    for (int n = 0; n <= links; ++n) {
      const double length = std::ldexp(digits(), -pick(0, 60)), scale = has_scales ? digits() / 2 + pick(0, 1) : 1;
      Eigen::Matrix4d local = moved_by({length, 0, 0});
      local.topLeftCorner<3, 3>() *= scale;
      nodes.push_back({"node " + std::to_string(n), n - 1, local});
    }
    Model model = gen::model_of_nodes("arm", nodes);
    model.vertices = {{0, 0, 0}}, model.triangles = {{0, 0, 0}}, model.influences = {{{0, 0.5}, {links, 0.5}}};
    Rational reach(0);
    for (int n = links; n > 0; --n) reach = Rational(nodes[n].local(0, 0)) * reach + Rational(nodes[n].local(0, 3));
    reach *= Rational(nodes[0].local(0, 0));
    const AnyPoseBound bound = bound_any_pose(model, JointSets(model), std::vector<int>{0}, Skinning::linear).value();
    if (!(bound.node == 0 && reach <= Rational(bound.radius) && Rational(bound.radius) <= reach * Rational(1 + 0x1p-29)))
      return Checked(false, tried, std::to_string(bound.radius));
  }
  return Checked(true, tried);
}

void what_is_small_beside_its_place(Suite& t) {
  t.example("what morph targets move a vertex by is rounded with it, and widens the radius by as much as it may be lost", {},
            check_rounding_of_displacements);
  t.example("a joint that scales by 1.0009 is replaced by a rigid one, which carries what is far from the origin elsewhere", {},
            [] {
              const Point3 at(100, 0, 0);
              Model model = thing_at(moved_by(at), moved_by(-at), {{100, 0, 0}, {100.001, 0, 0}, {100, 0.001, 0}});
              const Animation grows{"grows",
                                    1,
                                    {{0,
                                      {{{0, at}}},
                                      {{{0, Eigen::Quaterniond::Identity()}}},
                                      {{{0, Eigen::Vector3d::Ones()}, {1, Eigen::Vector3d::Constant(1.0009)}}}}}};
              model.clips.push_back({"grows", 1, {}, grows});
              const JointSets sets(model);
              const std::vector<int> all{0, 1, 2};
              for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::spherical}) {
                const AnimatedJoints joints(model, grows, skinning != Skinning::linear);
                std::vector<Point3> points;
                MovingVertices(model, sets, skinning, all).place(*joints.at(1, Side::after), Followed::skinned, points);
                double farthest = 0;
                for (const Point3& p : points) farthest = std::max(farthest, (p - at).norm());
                const double radius = bound_any_pose(model, sets, all, skinning).value().radius;
                // The clip's defect is 9e-4, at 100 units.
                if (!(farthest <= radius + 1e-12 && radius <= (skinning == Skinning::linear ? 0.0011 : 0.1)))
                  return Checked(false, 3, std::to_string(farthest) + " beyond " + std::to_string(radius));
              }
              return Checked(true, 3);
            });
  t.example("a renderer in float puts no vertex of a thing far from the scene's origin beyond the radius", {}, [] {
    const Point3 at(1000.1, 2000.3, -3000.7);
    const std::vector<Point3> vertices = {at, at + Point3(0.001, 0, 0), at + Point3(0, 0.001, 0)};
    const Model model = thing_at(moved_by(at), moved_by(-at), vertices);
    const double radius = bound_model(model, {.any_pose = true}).any_pose.at(0).value().radius;
    std::mt19937 random(5);
    std::normal_distribution<double> number;
    double farthest = 0;
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Quaterniond turned(number(random), number(random), number(random), number(random));
      Eigen::Matrix4d local = model.skeleton.nodes[0].local;
      local.topLeftCorner<3, 3>() = turned.normalized().toRotationMatrix();
      const Eigen::Matrix4f matrix = (local * model.skeleton.joints[0].offset).cast<float>();
      const Eigen::Vector3f node = local.topRightCorner<3, 1>().cast<float>();
      for (const Point3& v : vertices) {
        const Eigen::Vector3f image = matrix.topLeftCorner<3, 3>() * v.cast<float>() + matrix.topRightCorner<3, 1>();
        farthest = std::max(farthest, (image - node).cast<double>().norm());
      }
    }
    return Checked(farthest > 0.00105 && farthest <= radius && radius < 0.1, 1000,
                   std::to_string(farthest) + " in " + std::to_string(radius));
  });
  t.example("a vertex that its offset carries to the joint but for rounding is as far away as that is", {}, [] {
    using Exact = long double;
    long tried = 0;
    std::mt19937 random(6);
    std::normal_distribution<double> number;
    for (int i = 0; i < 200; ++i) {
      const Point3 v = 1000 * Point3(number(random), number(random), number(random));
      const Eigen::Quaterniond turned(number(random), number(random), number(random), number(random));
      Eigen::Matrix4d offset = Eigen::Matrix4d::Identity();
      offset.topLeftCorner<3, 3>() = turned.normalized().toRotationMatrix();
      offset.topRightCorner<3, 1>() = -(offset.topLeftCorner<3, 3>() * v);
      const Model model = thing_at(Eigen::Matrix4d::Identity(), offset, {v, v, v});
      const double radius = bound_any_pose(model, JointSets(model), std::vector<int>{0}, Skinning::linear).value().radius;
      const Eigen::Matrix<Exact, 3, 1> image =
          offset.topLeftCorner<3, 3>().cast<Exact>() * v.cast<Exact>() + offset.topRightCorner<3, 1>().cast<Exact>();
      ++tried;
      if (!(image.norm() <= radius && radius < 1e-10))
        return Checked(false, tried, std::to_string(static_cast<double>(image.norm() * 1e12L)) + "e-12");
    }
    return Checked(true, tried);
  });
}

}  // namespace

PROPTEST(any_pose) {
  vertices_stay_within_the_radius(t);
  t.example("of three joints that may come to lie on opposite sides, a blend of rotations has no ball, and that of two has", {},
            check_opposite_joints);
  what_is_small_beside_its_place(t);
  t.holds("joints whose weights are rounded to 0 count like others",
          {.number_type = "double", .cases = 100, .degenerate_at_most = 0.9, .tags_at_least = {{"lost", 0.3}}},
          check_lost_influences);
  t.example("a stretched arm reaches the radius, exactly but for rounding, and does not reach beyond it",
            {.number_type = "rational"}, check_stretched_arms);
  t.example("a stretched arm reaches the radius, and joints of two trees have no node above them", {}, [] {
    // The arm has two links of lengths 2 and 3, scaled by 2 and 1, and a vertex 1 below the last: it is 2 (3 + 1 * 1) = 8 from
    // the first joint.
    Model model;
    const auto local = [](double x, double scale) {
      Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
      m.topLeftCorner<3, 3>() *= scale, m(0, 3) = x;
      return m;
    };
    model.name = "arm";
    model.skeleton = {"arm", {{"a", -1, local(2, 2)}, {"b", 0, local(3, 1)}}, {{"b", 1, -1, local(-8, 1)}}};
    model.joints = {{"b", -1, {0, 0, 0}}};
    model.vertices = {{9, 0, 0}, {8, 0, 0}, {8, 0.5, 0}};
    model.triangles = {{0, 1, 2}};
    model.influences.assign(3, {{0, 1.0}});
    const std::vector<int> vertices{0};
    const AnyPoseBound own = bound_any_pose(model, JointSets(model), vertices, Skinning::linear).value();
    bool good = own.node == 1 && std::abs(own.radius - 2) < 1e-8;
    model.skeleton.joints.push_back({"a", 0, -1, local(0, 1)}), model.joints.push_back({"a", -1, {0, 0, 0}});
    model.influences[0] = {{0, 0.5}, {1, 0.5}};
    model.vertices[0] = {9, 0, 0};
    const AnyPoseBound both = bound_any_pose(model, JointSets(model), vertices, Skinning::linear).value();
    // The joint a has the radius 2 * 9.
    good = good && both.node == 0 && std::abs(both.radius - 18) < 1e-7;
    model.skeleton.nodes[1].parent = -1;
    good = good && !bound_any_pose(model, JointSets(model), vertices, Skinning::linear);
    return Checked(good, 3);
  });
}

}  // namespace proptests::suite_any_pose
