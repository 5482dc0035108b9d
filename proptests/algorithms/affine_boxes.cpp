// SPDX-License-Identifier: GPL-3.0-or-later
// Tests linear skinning by affine joints in everything that is fast (vertices in packs, balls in batches, boxes from the joints,
// and clusters), and cluster queries of deformed characters in every skinning.
#include "algorithms/runtime/collide/affine_boxes.hpp"

#include <memory>
#include <random>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/refit/deformed_reference.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_character.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/placed_vertices.hpp"

namespace proptests::suite_affine_boxes {
namespace {

using namespace refitlab;
using gen::JointKind;

JointKind drawn_kind() {
  return *rc::gen::element(JointKind::rigid, JointKind::uniform, JointKind::axes, JointKind::shear, JointKind::mirrored,
                           JointKind::flat, JointKind::extreme, JointKind::mixed);
}

RigidTransform<double> stretched_placement(std::mt19937& random, double far) {
  RigidTransform<double> out = gen::random_placement(random, far);
  // check_placement accepts a quaternion of this length.
  if (random() % 3 == 0) out.rotation *= 1 + 4.9e-7;
  return out;
}

// Holds a wide mesh with affine joints, skinned in double.
struct Affine {
  gen::WidePlan plan;
  SkinnedMesh mesh;
  JointSets sets;
  std::mt19937 random;
  AffinePose pose;
  SkinningPalette<double> palette;
  std::vector<Point3> skinned;
  Affine(int least, int greatest)
      : plan(drawn(least, greatest)),
        mesh(gen::wide_model(plan)),
        sets(mesh),
        random(plan.seed),
        pose(gen::random_affine_pose(mesh, drawn_kind(), random)),
        palette(make_skinning_palette(mesh, sets, pose)),
        skinned(skin(mesh, sets, palette, Skinning::linear)) {
    RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  }
  static gen::WidePlan drawn(int least, int greatest) {
    auto plan = *gen::wide_plan(least, greatest);
    plan.joints = std::min(plan.joints, 17), plan.influences = std::min(plan.influences, plan.joints);
    return plan;
  }
};

void check_packs() {
  const Affine a(-1074, 130);
  const PackedVertices packed(a.mesh, a.sets);
  std::vector<Point3> out(a.mesh.vertices.size());
  for (const Target target : available_targets()) {
    packed.skin_all(a.palette, Skinning::linear, out, target);
    RC_ASSERT(out == a.skinned);
  }
}

void check_batch() {
  const Affine a(-60, 40);
  const Character c = bake(a.mesh, {.triangles_per_leaf = *rc::gen::element(1, 3)}, {});
  BatchRefit batch(c.tree, c.sets);
  ExactSkin exact(c.mesh, c.sets, a.palette, Skinning::linear);
  for (const Target target : available_targets()) {
    const PackedBalls& balls = batch.linear(a.palette, target);
    for (int n = 0; n < static_cast<int>(c.tree.nodes.size()); ++n) {
      const Ball3<float> ball = balls[n];
      const Ball3<double> same{ball.center.cast<double>(), ball.radius};
      for (const int v : c.vertices[n]) RC_ASSERT(exact.is_in(same, v));
    }
  }
  // The ball is no looser than for joints that all stretch as the one that stretches most, about the same centers.
  double stretch = 0;
  for (const AffineMap<double>& map : a.pose) stretch = std::max(stretch, stretch_of(map));
  const TreeNode& root = c.tree.nodes[0];
  const Ball3<double> points = refit_variant("linear").refit(
      {{root.reference.center, 0}, c.tree.refit_node(0, a.palette).pieces, c.tree.weight_vertices.data(), a.palette});
  const double size = points.radius + stretch * root.reference.radius, all = size + norm(points.center);
  RC_CLASSIFY(size > 1e-2 * all, "of some size");
  RC_ASSERT(double(batch.linear(a.palette)[0].radius) <= 1.001 * size + 1e-3 * all + 1e-17);
}

// Checks a node about the origin, of one joint or of two, whose radius is beyond the range of float, or nearly.
void check_wide_batch() {
  const double far = std::ldexp(*rc::gen::element(1., 1.5, 1.99), *rc::gen::inRange(125, 300));
  const bool has_two_sets = *rc::gen::arbitrary<bool>();
  SkinnedMesh mesh;
  mesh.name = "wide";
  mesh.joints = {{"a", -1, Point3::Zero()}, {"b", 0, Point3::Zero()}};
  mesh.vertices = {{far, 0, 0}, {-far, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.influences.assign(3, {{0, 1.0}});
  if (has_two_sets) mesh.influences[2] = {{1, 1.0}};
  AffinePose pose(2, identity_map<double>());
  for (AffineMap<double>& map : pose)
    for (Point3& column : map.columns) column *= *rc::gen::element(0., 0x1p-30, 0.5, 1., 2.);
  const Character c = bake(mesh, {}, {});
  const SkinningPalette<double> palette = make_skinning_palette(mesh, c.sets, pose);
  const std::vector<Point3> skinned = skin(mesh, c.sets, palette, Skinning::linear);
  BatchRefit batch(c.tree, c.sets);
  bool is_infinite = false;
  for (const Target target : available_targets()) {
    const Ball3<float> ball = batch.linear(palette, target)[0];
    is_infinite = ball.radius == std::numeric_limits<float>::infinity();
    for (const Point3& v : skinned)
      RC_ASSERT((is_infinite || norm<double, 3>(v - ball.center.cast<double>()) <= double(ball.radius)));
  }
  RC_CLASSIFY(is_infinite, "all of space");
  RC_CLASSIFY(has_two_sets, "two joint-sets");
}

void check_motion_bound() {
  const Affine a(-1074, 130);
  std::mt19937 random(a.plan.seed + 7);
  const RigidTransform<double> at = stretched_placement(random, std::ldexp(1, a.plan.exponent));
  const MotionBound bound(a.mesh, a.sets, Skinning::linear);
  const Box<double> box = bound.box(a.pose, at);
  for (const Point3& v : a.skinned) RC_ASSERT(oracle::holds(box, apply(at, v)));
}

// Checks that a box is no larger than those around the images of the ball and of the box, by more than rounding.
void check_image() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 4, 4, 1, static_cast<unsigned>(random())});
  const AffineMap<double> map = gen::random_affine_pose(mesh, drawn_kind(), random)[0];
  auto box = Box<double>::empty();
  for (const Point3& v : mesh.vertices) box.merge(v);
  const Ball3<double> ball{box.center(), box.edges().norm() * *rc::gen::element(0.3, 0.4, 0.5)};
  const Box<double> image = box_of_image(map, ball, box, sizes_of(map, 1));
  bool ball_alone = false, box_alone = false;
  for (int i = 0; i < 3; ++i) {
    double row = 0, along = 0;
    for (int j = 0; j < 3; ++j) {
      const double entry = map.columns[static_cast<std::size_t>(j)][i];
      row += entry * entry, along += std::abs(entry) * box.edges()[j] / 2;
    }
    const double of_ball = std::sqrt(row) * ball.radius, expected = std::min(of_ball, along);
    (of_ball < along ? ball_alone : box_alone) = true;
    const double size = 1e-9 * (1 + std::sqrt(row)) * (10 + map.offset.norm());
    RC_ASSERT(std::abs((image.high[i] - image.low[i]) / 2 - expected) <= size);
    // Corners of the box that are in the ball, and the ball's poles that are in the box, are in the image.
  }
  // A map that is 2^40 times smaller makes a box that is.
  AffineMap<double> smaller = map;
  for (Point3& column : smaller.columns) column *= 0x1p-40;
  smaller.offset *= 0x1p-40;
  const Box<double> small = box_of_image(smaller, ball, box, sizes_of(smaller, 1));
  double reach = map.offset.norm();
  for (const Point3& column : map.columns) reach += column.norm() * (10 + ball.center.norm() + ball.radius);
  RC_ASSERT((small.low * 0x1p40 - image.low).norm() <= 1e-12 * reach + 1e-80);
  RC_ASSERT((small.high * 0x1p40 - image.high).norm() <= 1e-12 * reach + 1e-80);
  RC_CLASSIFY(ball_alone, "by the ball");
  RC_CLASSIFY(box_alone, "by the box");
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 20; ++k) {
    Point3 p;
    for (int i = 0; i < 3; ++i) p[i] = box.low[i] + (k % 2 ? unit(random) : std::round(unit(random))) * box.edges()[i];
    if ((p - ball.center).norm() <= ball.radius) RC_ASSERT(oracle::holds(image, apply(map, p)));
  }
}

bool has(const Box<float>& box, const Point3& p) {
  for (int i = 0; i < 3; ++i)
    if (!(double(box.low[i]) <= p[i] && p[i] <= double(box.high[i]))) return false;
  return true;
}

// Asserts that the body's boxes hold all vertices of its triangles, which are given in the world. So does the motion bound, which
// also holds those of no triangle if the mesh is not deformed in the frame.
void assert_held(ClusterBody& body, const std::vector<Point3>& skinned, bool is_of_mesh) {
  const ClusterTree& tree = body.tree();
  if (is_of_mesh)
    for (const Point3& v : skinned) RC_ASSERT(oracle::holds(body.motion_bound(), v));
  for (int f = 0; f < static_cast<int>(tree.wide_nodes().size()); ++f) {
    const Box<float>& box = body.wide_node_box(f);
    for (int k = 0; k < tree.wide_nodes()[static_cast<std::size_t>(f)].child_count; ++k) {
      const WideNodeChild& child = tree.child(f, k);
      if (child.cluster < 0) continue;
      const Cluster& cluster = tree.clusters()[static_cast<std::size_t>(child.cluster)];
      for (int t = 0; t < cluster.triangle_count; ++t)
        for (const int v : tree.character().mesh.triangles[static_cast<std::size_t>(tree.triangles(child.cluster)[t])])
          RC_ASSERT(has(box, skinned[static_cast<std::size_t>(v)] - body.clusters().origin()) &&
                    oracle::holds(body.motion_bound(), skinned[static_cast<std::size_t>(v)]));
    }
  }
}

// Checks joints that make a character too small for the digits of float. They neither turn nor shear, so that boxes are as tight
// as can be.
void check_tiny_boxes() {
  auto plan = *gen::mesh_plan();
  const SkinnedMesh mesh = gen::make_mesh(plan);
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  const Character c = bake(mesh, {.triangles_per_leaf = 1}, {Pieces::mixed});
  const ClusterTree tree(c, {.most_triangles = 1, .most_children = 3});
  ClusterBody body(tree, Skinning::linear);
  for (const double unit : {1e-34, 1e-38, 1e-40, 1e-42, 1e-44, 1e-50}) {
    AffineMap<double> map = identity_map<double>();
    for (Point3& column : map.columns) column *= unit;
    const AffinePose pose(mesh.joints.size(), map);
    body.begin(pose, {});
    assert_held(body, skin(mesh, c.sets, make_skinning_palette(mesh, c.sets, pose), Skinning::linear, {}), true);
  }
}

// Checks that the boxes of two bodies of one mesh hold the vertices, and that their pairs are those of all pairs. Linear skinning
// has affine joints; other skinning has scales. These and morph targets belong to the frame, or to characters made anew.
void check_clusters() {
  const auto plan = *gen::mesh_plan();
  std::mt19937 random(plan.seed);
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  const Skinning skinning = gen::drawn_skinning();
  const JointKind kind = *rc::gen::element(JointKind::uniform, JointKind::axes, JointKind::shear, JointKind::mirrored);
  const Character c = bake(mesh, {.triangles_per_leaf = *rc::gen::element(1, 3)}, {Pieces::mixed});
  const ClusterOptions options{.most_triangles = *rc::gen::element(1, 4, 16), .most_children = 3};
  const bool is_made_anew = *rc::gen::arbitrary<bool>();
  RC_CLASSIFY(!is_made_anew, "deformed in the frame");
  std::vector<Character> characters;
  std::vector<ClusterTree> trees;
  std::vector<std::unique_ptr<ClusterBody>> bodies;
  std::vector<Point3> skinned[2];
  characters.reserve(2), trees.reserve(2);
  for (int i = 0; i < 2; ++i) {
    const AffinePose pose = gen::random_affine_pose(mesh, kind, random);
    const auto [rigid, scales] = split(mesh, pose);
    const RigidTransform<double> at = stretched_placement(random, 0.3);
    const std::vector<double> weights = gen::random_weights(mesh, random);
    const Deformation deformation{weights, skinning == Skinning::linear ? AffinePose() : scales};
    if (is_made_anew) characters.push_back(deformed_character(c, deformation));
    trees.emplace_back(is_made_anew ? characters.back() : c, options);
    bodies.push_back(std::make_unique<ClusterBody>(trees.back(), skinning));
    ClusterBody& body = *bodies.back();
    // The body is in a frame of rigid joints before.
    if (random() % 2) body.begin(reference_pose(mesh), {});
    // It is also in a frame of another deformation, whose balls are made.
    if (!is_made_anew && random() % 2) {
      body.begin(gen::random_affine_pose(mesh, kind, random), {}, gen::random_weights(mesh, random));
      body.wide_node_box(0);
    }
    const auto palette = skinning == Skinning::linear ? make_skinning_palette(mesh, c.sets, pose)
                                                      : make_skinning_palette(mesh, c.sets, rigid, skinning);
    skinned[i] = skin(mesh, c.sets, palette, skinning, deformation);
    for (Point3& v : skinned[i]) v = apply(at, v);
    if (is_made_anew && skinning != Skinning::linear) body.begin(rigid, at);
    else if (skinning != Skinning::linear && random() % 2) body.begin(rigid, at, deformation);
    else body.begin(pose, at, is_made_anew ? std::vector<double>() : weights);
    if (random() % 2) assert_held(body, skinned[i], is_made_anew);
  }
  const auto expected = oracle::all_pairs(mesh.triangles, skinned[0], mesh.triangles, skinned[1]);
  RC_CLASSIFY(!expected.empty(), "touching");
  QueryCounts counts;
  PairMemory memory;
  for (int i = 0; i < 2; ++i) {
    RC_ASSERT(oracle::sorted(collide(*bodies[0], *bodies[1], Query::full, counts, &memory)) == expected);
    RC_ASSERT(collide(*bodies[0], *bodies[1], Query::yes_no, counts, &memory).empty() == expected.empty());
  }
  CrowdCounts crowd_counts;
  ClusterBody* const crowd[] = {bodies[0].get(), bodies[1].get()};
  const auto contacts = collide_all(crowd, Query::full, crowd_counts);
  RC_ASSERT(contacts.empty() == expected.empty());
  if (!contacts.empty()) RC_ASSERT(oracle::sorted(contacts[0].pairs) == expected);
  for (int i = 0; i < 2; ++i) {
    const Character& own = trees[static_cast<std::size_t>(i)].character();
    bodies[i]->begin(reference_pose(mesh), {});
    skinned[i] = skin(own.mesh, own.sets, make_skinning_palette(own.mesh, own.sets, reference_pose(mesh), skinning), skinning);
    for (Point3& v : skinned[i]) v = apply(RigidTransform<double>{}, v);
    assert_held(*bodies[i], skinned[i], true);
  }
  RC_ASSERT(oracle::sorted(collide(*bodies[0], *bodies[1], Query::full, counts, &memory)) ==
            oracle::all_pairs(mesh.triangles, skinned[0], mesh.triangles, skinned[1]));
}

// Checks vertices where the ball of a deformed body is attained, in placements that stretch it along an axis, or shrink it.
void check_attained() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const gen::AttainedOptions options{.unit = *rc::gen::element(1.0, 1.0, 1e-12, 1e-30, 1e9, 1e30),
                                     .far = *rc::gen::element(0.0, 1.0, 1e6),
                                     .joints = *rc::gen::element(1, 2, 5, 17)};
  gen::Attained scene = gen::attained(random, options);
  const Skinning skinning = gen::random_skinning(random);
  SkinnedMesh& mesh = scene.mesh;
  // All vertices go the same way, or stay.
  const Point3 way = random() % 2 ? Point3(0, 0, 0) : Point3(0.25, -0.5, 1) * options.unit;
  mesh.targets = {1, std::vector(mesh.vertices.size(), std::vector<Displacement<double>>{{0, way}})};
  const Deformation deformation{{*rc::gen::element(0.0, 1.0, -0.5)}, {}};
  const Character c = bake(mesh, {.triangles_per_leaf = *rc::gen::element(1, 8)}, {Pieces::mixed});
  const ClusterTree tree(c);
  ClusterBody body(tree, skinning);
  body.begin(scene.pose, scene.placement, deformation);
  auto skinned = skin(mesh, c.sets, make_skinning_palette(mesh, c.sets, scene.pose, skinning), skinning, deformation);
  for (Point3& v : skinned) v = apply(scene.placement, v);
  RC_LOG() << scene.what;
  RC_CLASSIFY(squared_norm(scene.placement.rotation) > 1 + 1e-7, "stretched");
  assert_held(body, skinned, false);
}

// Makes one triangle whose vertices are all of the same joints, with equal weights.
SkinnedMesh even_triangle(int joints, const Point3& a, const Point3& b, const Point3& c) {
  SkinnedMesh mesh;
  mesh.name = "even";
  for (int j = 0; j < joints; ++j) mesh.joints.push_back({"joint " + std::to_string(j), j - 1, Point3::Zero()});
  mesh.vertices = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  mesh.influences.resize(3);
  for (auto& own : mesh.influences)
    for (int j = 0; j < joints; ++j) own.push_back({j, 1. / joints});
  return mesh;
}

// Checks joints that cancel each other, so that the blend is much smaller than the terms that skinning adds up.
void check_joints_that_cancel() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::uniform_real_distribution<double> u(-1, 1);
  const auto point = [&] { return Point3(u(random), u(random), u(random)); };
  const double far = std::pow(10, *rc::gen::inRange(0, 18)), stretch = std::pow(10, *rc::gen::inRange(0, 4));
  const bool is_turned = *rc::gen::arbitrary<bool>();
  const Character c = bake(even_triangle(2, point(), point(), point()), {}, {});
  AffinePose pose(2, identity_map<double>());
  pose[0].offset = far * point(), pose[1].offset = point() - pose[0].offset;
  for (int i = 0; i < 3; ++i) {
    const Point3 away = stretch * point();
    pose[0].columns[static_cast<std::size_t>(i)] += away, pose[1].columns[static_cast<std::size_t>(i)] -= away;
  }
  RigidTransform<double> at;
  if (is_turned) at = stretched_placement(random, 1);
  const ClusterTree tree(c);
  ClusterBody body(tree, Skinning::linear);
  body.begin(pose, at);
  auto skinned = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose), Skinning::linear);
  for (Point3& v : skinned) v = apply(at, v);
  assert_held(body, skinned, true);
  RC_CLASSIFY(far > 1e6, "far");
}

// Checks that the motion bound's boxes of single joints hold vertices of many joints, which are off by as many roundings.
void check_many_joints() {
  const int joints = 1 << *rc::gen::element(0, 6, 10, 11, 12);
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const SkinnedMesh mesh = even_triangle(joints, Point3::Zero(), Point3::Zero(), Point3::UnitX() * 0x1p-40);
  const JointSets sets(mesh);
  // The offset is just below a power of two, so that each of the last sums rounds by nearly half a unit, all in the same
  // direction.
  AffineMap<double> map = identity_map<double>();
  map.offset = Point3::Constant(2 - (joints / 2 + 1 + static_cast<double>(random() % 4)) * 0x1p-52);
  const AffinePose pose(static_cast<std::size_t>(joints), map);
  const Box<double> box = MotionBound(mesh, sets, Skinning::linear).box(pose, {});
  for (const Point3& v : skin(mesh, sets, make_skinning_palette(mesh, sets, pose), Skinning::linear))
    RC_ASSERT(oracle::holds(box, v));
}

// Checks coordinates near the end of float's range and beyond it.
void check_far_boxes() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::uniform_real_distribution<double> exponent(34, 40), u(-1, 1);
  const auto far = [&] { return std::copysign(std::pow(10, exponent(random)), u(random)); };
  SkinnedMesh mesh = even_triangle(2, Point3::Zero(), Point3::UnitX(), Point3::UnitY());
  if (random() % 2) mesh.vertices[0] = Point3(far(), far(), random() % 2 ? far() : 0);
  if (random() % 2) mesh.influences[0] = {{0, 1}}, mesh.influences[1] = {{1, 1}};
  const bool is_morphed = random() % 2;
  if (is_morphed) gen::add_targets(mesh, random);
  const Character c = bake(mesh, {}, {Pieces::mixed});
  AffinePose pose(2, identity_map<double>());
  if (random() % 2) pose[0].columns[random() % 3] = Point3::Zero();
  RigidTransform<double> at;
  if (random() % 2) {
    const double away = far();
    for (auto& map : pose) map.offset[0] = away;
    at.translation[0] = -away * 0.99;
  }
  const std::vector<double> weights = is_morphed ? gen::random_weights(mesh, random) : std::vector<double>();
  const ClusterTree tree(c);
  ClusterBody body(tree, Skinning::linear);
  try {
    body.begin(pose, at, weights);
  } catch (const std::exception&) {
    RC_TAG("refused");
    return;
  }
  auto skinned = skin(c.mesh, c.sets, make_skinning_palette(c.mesh, c.sets, pose), Skinning::linear, Deformation{weights, {}});
  for (Point3& v : skinned) v = apply(at, v);
  assert_held(body, skinned, !is_morphed);
  RC_TAG("held");
}

// Checks that a frame that is refused leaves the one before as it was.
void check_refused_frames() {
  const auto plan = *gen::mesh_plan();
  std::mt19937 random(plan.seed);
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  const Skinning skinning = *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::dual_quaternion);
  const Character c = bake(mesh, {}, {Pieces::mixed});
  const ClusterTree tree(c, {.most_triangles = 4, .most_children = 3});
  ClusterBody body(tree, skinning);
  const Pose pose = gen::random_pose(mesh, random, 0.5);
  Pose stretched = pose, few = pose;
  stretched[0].rotation *= 2, few.pop_back();
  const bool is_deformed = random() % 2;
  const Deformation deformation{is_deformed ? gen::random_weights(mesh, random) : std::vector<double>(), {}};
  body.expect(std::array{ClusterBody::Need::bound, ClusterBody::Need::nodes, ClusterBody::Need::skin}[random() % 3]);
  body.begin(pose, {}, deformation);
  const auto refused = [&](const auto& begin) { RC_ASSERT(gen::refuses<ModelError>(begin)); };
  const std::vector<double> one_too_many(static_cast<std::size_t>(mesh.targets.count) + 1, 0.5);
  const AffinePose infinite(mesh.joints.size(), AffineMap<double>{{}, Point3::Constant(1e300)});
  switch (random() % 6) {
    case 0: refused([&] { body.begin(few, {}); }); break;
    case 1: refused([&] { body.begin(stretched, {}); }); break;
    case 2: refused([&] { body.begin(few, {}, {gen::random_weights(mesh, random), {}}); }); break;
    case 3: refused([&] { body.begin(pose, {}, {one_too_many, {}}); }); break;
    case 4: refused([&] { body.begin(infinite, {}); }); break;
    default: refused([&] { body.begin(infinite, {}, gen::random_weights(mesh, random)); });
  }
  auto skinned = skin(mesh, c.sets, make_skinning_palette(mesh, c.sets, pose, skinning), skinning, deformation);
  for (Point3& v : skinned) v = apply(RigidTransform<double>{}, v);
  assert_held(body, skinned, !is_deformed);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TrianglePoints points = body.triangle(static_cast<int>(t));
    for (int i = 0; i < 3; ++i) RC_ASSERT(points[i] == skinned[static_cast<std::size_t>(mesh.triangles[t][i])]);
  }
  RC_CLASSIFY(is_deformed, "deformed");
}

}  // namespace

PROPTEST(affine_boxes) {
  t.holds("boxes hold what joints that nearly cancel each other make, with all that skinning rounds",
          {.number_type = "double", .cases = 1000, .tags_at_least = {{"far", 0.2}}}, check_joints_that_cancel);
  t.holds("the motion bound holds vertices of thousands of affine joints", {.number_type = "double", .cases = 60},
          check_many_joints);
  t.holds("boxes beyond the range of float hold everything rather than nothing",
          {.number_type = "double", .cases = 1000, .tags_at_least = {{"held", 0.6}}}, check_far_boxes);
  t.holds("boxes of deformed bodies hold vertices where their balls are attained, however long a placement's quaternion is",
          {.number_type = "double", .cases = 600, .tags_at_least = {{"stretched", 0.15}}}, check_attained);
  t.holds("a frame that is refused leaves the one before as it was",
          {.number_type = "double", .cases = 300, .tags_at_least = {{"deformed", 0.3}}}, check_refused_frames);
  t.example("clusters refuse affine joints in a skinning of rotations, and have no palettes of them in float", {}, [] {
    const Character c = bake(even_triangle(1, Point3::Zero(), Point3::UnitX(), Point3::UnitY()), {}, {});
    const ClusterTree tree(c);
    const AffinePose pose(1, identity_map<double>());
    SkinnedClusters linear(tree, Skinning::linear), spherical(tree, Skinning::spherical);
    linear.begin(pose, {}, Point3::Zero());
    linear.make_all_palettes();
    const bool is_refused = gen::refuses<std::invalid_argument>([&] { spherical.begin(pose, {}, Point3::Zero()); });
    return Checked(is_refused && linear.triangle(0)[1] == Point3::UnitX(), 2);
  });

  t.holds("packs skin by affine joints to the last bit as skin() does",
          {.number_type = "double", .cases = 200, .degenerate_at_most = 0.5}, check_packs);
  t.holds("the balls of a batch enclose what affine joints make of their vertices",
          {.number_type = "float against rational",
           .cases = 200,
           .degenerate_at_most = 0.5,
           .tags_at_least = {{"of some size", 0.3}}},
          check_batch);
  t.holds("the batch's ball of a node that is beyond the range of float is all of space, also where joints shrink",
          {.number_type = "float", .cases = 200, .tags_at_least = {{"all of space", 0.5}, {"two joint-sets", 0.3}}},
          check_wide_batch);
  t.holds("boxes in float hold characters that joints make smaller than float has digits for",
          {.number_type = "double", .cases = 40}, check_tiny_boxes);
  t.holds("the motion bound of affine joints has all vertices",
          {.number_type = "double", .cases = 400, .degenerate_at_most = 0.5}, check_motion_bound);
  t.holds("the box of an image is as large as the smaller of those of the ball and of the box",
          {.number_type = "double", .cases = 400, .tags_at_least = {{"by the ball", 0.2}, {"by the box", 0.2}}}, check_image);
  t.holds("clusters of affine joints, and of deformed characters, touch where all pairs of skinned triangles say so",
          {.number_type = "double", .cases = 200, .tags_at_least = {{"touching", 0.3}, {"deformed in the frame", 0.4}}},
          check_clusters);
  t.example("a deformation in the frame is refused without the default variant's pieces, and with a weight too many", {}, [] {
    SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
    std::mt19937 random(1);
    const auto pose = gen::random_affine_pose(mesh, JointKind::axes, random);
    const Character bare = bake(mesh, {}, {}), whole = bake(mesh, {}, {Pieces::mixed});
    const ClusterTree bare_tree(bare), whole_tree(whole);
    ClusterBody without(bare_tree, Skinning::spherical), with(whole_tree, Skinning::spherical);
    const bool is_bare_refused = gen::refuses<std::invalid_argument>([&] { without.begin(pose, {}); }),
               is_weight_refused = gen::refuses<ModelError>([&] { with.begin(pose, {}, {0.5}); });
    with.begin(pose, {});
    return Checked(is_bare_refused && is_weight_refused, 2);
  });
}

}  // namespace proptests::suite_affine_boxes
