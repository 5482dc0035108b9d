// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/collide.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/farthest_placement.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests::suite_collide {
namespace {

using namespace refitlab;
using gen::random_pose;
using gen::random_rotation;
using oracle::sorted;

const RefitVariant& drawn_variant() {
  std::vector<const RefitVariant*> sound;
  for (const RefitVariant& v : compared_variants())
    if (v.sound) sound.push_back(&v);
  return *sound[*rc::gen::inRange<std::size_t>(0, sound.size())];
}

// This refit is wrong on purpose.
Ball3<double> undefined(const RefitNode<double>&) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {{nan, nan, nan}, nan};
}
// Makes a triangle whose smallest ball has the edge from (0, 0, 0) to (2, 0, 0) as a diameter.
SkinnedMesh lone_triangle() {
  SkinnedMesh m;
  m.name = "triangle";
  m.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}};
  m.triangles = {{0, 1, 2}};
  m.joints = {{"root", -1, {0, 0, 0}}};
  m.influences.assign(3, {{0, 1.0}});
  return m;
}

// Counts the balls that were refitted in this frame.
long balls_of(const Body& body) {
  long balls = 0;
  for (const long level : body.refits().refitted_by_level()) balls += level;
  return balls;
}

// Holds what collide says of two men, and what it looked at.
struct Men {
  std::size_t pairs;
  long ball_tests, vertices, balls;
};
Men two_men(const char* variant, double distance, Query query) {
  static const auto man = bake_animated(make_man());
  const RefitVariant& v = compared_variant(variant);
  Body a(man, v), b(man, v);
  const Clip& walk = man.clips[0];
  a.begin(walk.sample(0.2 * walk.duration));
  b.begin(walk.sample(0.7 * walk.duration));
  QueryCounts counts;
  const auto pairs = collide({a}, {b, {identity_quaternion<double>(), {distance, 0, 0}}}, query, counts);
  return {pairs.size(), counts.ball_tests, a.vertices_skinned() + b.vertices_skinned(), balls_of(a) + balls_of(b)};
}

void pairs_are_those_of_testing_all(Suite& t) {
  t.holds("every sound variant, with and without the frame's short cuts, finds the pairs that testing all pairs finds",
          {.number_type = "double", .cases = 150, .degenerate_at_least = 0.3}, [] {
            const auto plan_a = *gen::mesh_plan(), plan_b = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan_a) || gen::is_degenerate(plan_b), "degenerate");
            const Character a = bake(gen::make_mesh(plan_a), {.triangles_per_leaf = *rc::gen::element(1, 3)}),
                            b = bake(gen::make_mesh(plan_b), {.triangles_per_leaf = *rc::gen::element(1, 3)});
            const RefitVariant& variant = drawn_variant();
            const FrameOptions options{.most_joint_sets = *rc::gen::element(0, 2), .children_first = *rc::gen::arbitrary<bool>()};
            Body first(a, variant, options), second(b, variant, options);
            std::mt19937 random(plan_a.seed);
            std::normal_distribution<double> normal;
            for (int frame = 0; frame < 3; ++frame) {
              const Pose pose_a = random_pose(a.mesh, random), pose_b = random_pose(b.mesh, random);
              const double apart = frame == 2 ? 3 : 0.5;
              const RigidTransform<double> at_a{random_rotation(random, 1), {normal(random), 0, 0}},
                  at_b{random_rotation(random, 1), at_a.translation + Point3(normal(random), normal(random), 0) * apart};
              first.begin(pose_a), second.begin(pose_b);
              const auto expected = oracle::all_pairs({a, pose_a, at_a}, {b, pose_b, at_b}, variant.skinning);
              QueryCounts counts;
              const auto found = collide({first, at_a}, {second, at_b}, Query::full, counts);
              RC_ASSERT(sorted(found) == expected);
              const auto one = collide({first, at_a}, {second, at_b}, Query::yes_no, counts);
              RC_ASSERT(one.size() == (expected.empty() ? 0u : 1u));
              if (!one.empty()) RC_ASSERT(std::find(expected.begin(), expected.end(), one[0]) != expected.end());
              RC_TAG(expected.empty() ? "apart" : "in contact");
            }
          });
  t.holds("one body in two placements", {.number_type = "double", .cases = 50, .degenerate_at_least = 0.3}, [] {
    const auto plan = gen::classified_plan();
    const auto c = bake(gen::make_mesh(plan));
    const RefitVariant& variant = drawn_variant();
    Body body(c, variant);
    std::mt19937 random(plan.seed);
    const Pose pose = random_pose(c.mesh, random);
    const RigidTransform<double> at{random_rotation(random, 1), {0.3, 0, 0.1}};
    body.begin(pose);
    QueryCounts counts;
    RC_ASSERT(sorted(collide({body}, {body, at}, Query::full, counts)) ==
              oracle::all_pairs({c, pose, {}}, {c, pose, at}, variant.skinning));
    RC_ASSERT(body.vertices_skinned() <= static_cast<long>(c.mesh.vertices.size()));
  });
}

void triangles_that_touch_where_balls_do(Suite& t) {
  t.holds("triangles that touch in a point where their balls do are found, wherever rounding has put them",
          {.number_type = "double", .cases = 2000}, [] {
            static const auto c = bake(lone_triangle());
            std::mt19937 random(*rc::gen::inRange(0u, ~0u));
            Body body(c, compared_variant("control_mixed"));
            body.begin(reference_pose(c.mesh));
            const double most = *rc::gen::element(1.0, 1000.0, 1e15, 1e30, 1e150, 1e300);
            const RigidTransform<double> first = gen::accepted_placement(random, most);
            RigidTransform<double> second = first;
            if (*rc::gen::arbitrary<bool>()) second.rotation.normalize();
            // Its vertex at the origin is then the first triangle's other vertex of the edge.
            second.translation = apply(first, Point3(2, 0, 0));
            QueryCounts counts;
            RC_ASSERT(collide({body, first}, {body, second}, Query::full, counts).size() == 1);
            RC_ASSERT(collide({body, second}, {body, first}, Query::full, counts).size() == 1);
          });
  t.holds("so are they at every scale at which vertices are numbers", {.number_type = "double", .cases = 500}, [] {
    const double unit = std::ldexp(1.0, *rc::gen::inRange(-1070, 132));
    SkinnedMesh model = lone_triangle();
    for (Point3& v : model.vertices) v *= unit;
    const auto c = bake(std::move(model));
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    for (const char* variant : {"control_mixed", "spherical_repaired", "linear"}) {
      Body body(c, compared_variant(variant));
      body.begin(reference_pose(c.mesh));
      const RigidTransform<double> first = gen::accepted_placement(random, unit);
      RigidTransform<double> second = first;
      second.translation = apply(first, Point3(2 * unit, 0, 0));
      QueryCounts counts;
      RC_ASSERT(collide({body, first}, {body, second}, Query::full, counts).size() == 1);
    }
  });
}

void balls_that_are_apart_cost_one_test(Suite& t) {
  t.example("two walking men far apart cost one test and no vertex; close by they are refitted in part only", {}, [] {
    const Men far = two_men("spherical_repaired", 5, Query::full), near = two_men("spherical_repaired", 0.6, Query::full),
              deep = two_men("spherical_repaired", 0.1, Query::full), first = two_men("spherical_repaired", 0.1, Query::yes_no);
    return Checked(far.pairs == 0 && far.ball_tests == 1 && far.vertices == 0 && far.balls == 2 && deep.pairs > 100 &&
                       deep.vertices < 5000 && near.balls < deep.balls && first.pairs == 1 && first.balls < deep.balls,
                   4,
                   std::to_string(near.balls) + " balls refitted near by, " + std::to_string(deep.balls) + " for " +
                       std::to_string(deep.pairs) + " pairs, " + std::to_string(first.balls) + " for the first one");
  });
  t.example(
      "the larger of two nodes is opened: of a man of two centimetres in front of another, only the root's ball is refitted", {},
      [] {
        const auto man = bake_animated(make_man());
        SkinnedMesh small = make_man();
        for (Point3& v : small.vertices) v *= 0.01;
        for (Joint& joint : small.joints) joint.origin *= 0.01;
        const auto figure = bake(std::move(small));
        const RefitVariant& variant = compared_variant("spherical_repaired");
        Body large(man, variant), in_front(figure, variant);
        bool ok = true;
        std::string text;
        for (const bool large_first : {true, false}) {
          large.begin(reference_pose(man.mesh)), in_front.begin(reference_pose(figure.mesh));
          const PlacedBody there{large}, here{in_front, {identity_quaternion<double>(), {0, 1, 0.5}}};
          QueryCounts counts;
          const bool is_apart =
              (large_first ? collide(there, here, Query::full, counts) : collide(here, there, Query::full, counts)).empty();
          ok = ok && is_apart && balls_of(in_front) == 1 && balls_of(large) > 1 && counts.triangle_tests == 0;
          text += std::to_string(balls_of(large)) + " balls of the large one; ";
        }
        return Checked(ok, 2, text);
      });
  t.example(
      "balls that are apart by 1e-12 of their size are found apart by one test, at every scale at which balls are larger than "
      "what underflows",
      {}, [] {
        long tried = 0;
        for (int exponent = -430; exponent <= 120; exponent += 10) {
          const double unit = std::ldexp(1.0, exponent);
          SkinnedMesh model = lone_triangle();
          for (Point3& v : model.vertices) v *= unit;
          const auto c = bake(std::move(model));
          Body body(c, compared_variant("control_mixed"));
          body.begin(reference_pose(c.mesh));
          for (const double way : {2 * (1 + 1e-12), 2.1}) {
            QueryCounts counts;
            if (!collide({body}, {body, {identity_quaternion<double>(), {way * unit, 0, 0}}}, Query::full, counts).empty() ||
                counts.ball_tests != 1 || counts.triangle_tests != 0)
              return Checked(false, tried, "2^" + std::to_string(exponent));
            ++tried;
          }
        }
        return Checked(true, tried);
      });
}

// Draws a plan of a mesh of few triangles, where all pairs of them are hard to decide.
gen::MeshPlan small_plan() {
  gen::MeshPlan plan = *gen::mesh_plan();
  plan.rings = std::min(plan.rings, 3), plan.sides = std::min(plan.sides, 4);
  return plan;
}

// Begins a frame that is refused, in one of the ways in which a frame may be: by its pose or by its deformation.
template <class Random>
std::string refused_frame(Body& body, Random& random) {
  const SkinnedMesh& mesh = body.character().mesh;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pose pose = random_pose(mesh, random, 2), lost = pose, short_one = pose;
  lost.back().translation[1] = nan, short_one.pop_back();
  AffinePose affine = gen::random_affine_pose(mesh, gen::JointKind::axes, random), lost_affine = affine, wide = affine;
  lost_affine.back().columns[2][0] = nan, wide.back().columns[0] = Point3(2e4, 0, 0);
  const std::vector<double> weights = gen::random_weights(mesh, random);
  std::vector<double> more = weights, huge = weights, undefined_ones = weights;
  more.push_back(0.5);
  if (weights.empty()) huge = undefined_ones = more;
  else huge[0] = 2e4, undefined_ones.back() = nan;
  const auto way = random() % 11;
  try {
    switch (way) {
      case 0: body.begin(lost); break;
      case 1: body.begin(short_one); break;
      case 2: body.begin(lost, {weights, affine}); break;
      case 3: body.begin(pose, {more, {}}); break;
      case 4: body.begin(pose, {huge, affine}); break;
      case 5: body.begin(pose, {undefined_ones, {}}); break;
      case 6: body.begin(pose, {weights, lost_affine}); break;
      case 7: body.begin(pose, {weights, wide}); break;
      case 8: body.begin(lost_affine, weights); break;
      case 9: body.begin(wide, weights); break;
      default: body.begin(affine, more);
    }
  } catch (const ModelError& e) {
    return e.what();
  }
  RC_LOG() << "way " << way << " is not refused";
  return "";
}

// Checks a body in frames that are refused in between, against one that never saw them.
void check_frames_after_refused_ones() {
  const auto plan = gen::classified_plan();
  std::mt19937 random(plan.seed);
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  RC_CLASSIFY(mesh.targets.count > 0, "morphed");
  const Character c = bake(std::move(mesh), {.triangles_per_leaf = *rc::gen::element(1, 3)});
  const RefitVariant& variant = drawn_variant();
  Body body(c, variant), other(c, variant);
  for (int frame = 0; frame < 4; ++frame) {
    const Pose pose = random_pose(c.mesh, random);
    const AffinePose affine = gen::random_affine_pose(c.mesh, gen::JointKind::shear, random);
    const std::vector<double> weights = gen::random_weights(c.mesh, random);
    for (Body* of : {&body, &other})
      if (frame == 0) of->begin(pose);
      else if (frame == 1) of->begin(pose, {weights, affine});
      else if (frame == 2) of->begin(affine, weights);
      else of->begin(pose, {weights, {}});
    const auto nodes = static_cast<int>(c.tree.nodes.size()), triangles = static_cast<int>(c.mesh.triangles.size());
    // Some balls and vertices are made before the frame that is refused, and the others after it.
    body.ball(static_cast<int>(random() % c.tree.nodes.size()));
    body.triangle(static_cast<int>(random() % c.mesh.triangles.size()));
    for (int i = 0; i < 3; ++i) RC_ASSERT(!refused_frame(body, random).empty());
    for (int n = 0; n < nodes; ++n)
      RC_ASSERT(body.ball(n).center == other.ball(n).center && body.ball(n).radius == other.ball(n).radius);
    for (int triangle = 0; triangle < triangles; ++triangle) RC_ASSERT(body.triangle(triangle) == other.triangle(triangle));
  }
}

// Checks vertices that are equal in double there, or as far apart as numbers can be.
void check_placements_at_the_end_of_double() {
  const gen::MeshPlan plan = small_plan();
  RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
  const double unit = *rc::gen::element(1.0, 1e-300, 1e39);
  SkinnedMesh mesh = gen::make_mesh(plan);
  for (Point3& v : mesh.vertices) v *= unit;
  for (Joint& joint : mesh.joints) joint.origin *= unit;
  const Character c = bake(std::move(mesh), {.triangles_per_leaf = *rc::gen::element(1, 3)});
  const RefitVariant& variant = drawn_variant();
  std::mt19937 random(plan.seed);
  Pose pose = random_pose(c.mesh, random);
  for (auto& joint : pose) joint.translation *= unit;
  Body first(c, variant), second(c, variant);
  first.begin(pose), second.begin(pose);
  for (int i = 0; i < 4; ++i) {
    const RigidTransform<double> at_a = gen::farthest_placement(random);
    RigidTransform<double> at_b = gen::farthest_placement(random);
    if (i < 3) at_b.translation = at_a.translation;
    if (i == 2) at_b.translation[0] = std::nextafter(at_b.translation[0], 0);
    const auto expected = oracle::all_pairs({c, pose, at_a}, {c, pose, at_b}, variant.skinning);
    QueryCounts counts;
    RC_ASSERT(sorted(collide({first, at_a}, {second, at_b}, Query::full, counts)) == expected);
    RC_ASSERT(collide({first, at_a}, {second, at_b}, Query::yes_no, counts).empty() == expected.empty());
    RC_TAG(expected.empty() ? "apart" : "in contact");
  }
}

void frames_that_are_refused_and_places_far_away(Suite& t) {
  t.holds("a body goes on with the frame before if one is refused, by its pose, its weights or its scales",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.3, .tags_at_least = {{"morphed", 0.4}}},
          check_frames_after_refused_ones);
  t.holds(
      "pairs of bodies at the end of what doubles are, where differences of places overflow, are those of testing all",
      {.number_type = "double", .cases = 100, .degenerate_at_least = 0.3, .tags_at_least = {{"in contact", 0.3}, {"apart", 0.3}}},
      check_placements_at_the_end_of_double);
}

}  // namespace

PROPTEST(collide) {
  pairs_are_those_of_testing_all(t);
  t.example("a ball that is undefined, or too small by rounding, hides no pair", {}, [] {
    const auto c = bake(lone_triangle());
    const RigidTransform<double> touching{identity_quaternion<double>(), {2, 0, 0}};
    const RefitVariant variant{"wrong", "", Skinning::spherical, false, Pieces::joint_sets, &undefined, &undefined};
    Body body(c, variant);
    body.begin(reference_pose(c.mesh));
    QueryCounts counts;
    const auto found = static_cast<long>(collide({body}, {body, touching}, Query::full, counts).size());
    return Checked(found == 1, found);
  });
  triangles_that_touch_where_balls_do(t);
  balls_that_are_apart_cost_one_test(t);
  frames_that_are_refused_and_places_far_away(t);
  t.example("a body that has begun no frame is refused by name, and none is copied", {}, [] {
    static_assert(!std::is_copy_constructible_v<Body> && !std::is_move_constructible_v<Body>);
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    Body begun(c, compared_variant("spherical_repaired")), other(c, compared_variant("spherical_repaired"));
    begun.begin(reference_pose(c.mesh));
    QueryCounts counts;
    const auto is_refused = [](const auto& call) { return gen::refuses<std::logic_error>(call); };
    return Checked(is_refused([&] { collide({begun}, {other}, Query::full, counts); }) &&
                       is_refused([&] { collide({other}, {begun}, Query::full, counts); }) &&
                       is_refused([&] { other.triangle(0); }) && is_refused([&] { other.ball(0); }),
                   4);
  });
  t.example("a placement that is not rigid, or not finite, and a pose with a NaN are refused by name", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1}));
    Body body(c, compared_variant("spherical_repaired"));
    body.begin(reference_pose(c.mesh));
    const auto message = [&](const RigidTransform<double>& at) -> std::string {
      try {
        QueryCounts counts;
        collide({body}, {body, at}, Query::full, counts);
        return "";
      } catch (const std::invalid_argument& e) {
        return e.what();
      }
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string stretched = message({{2, 0, 0, 0}, {0, 0, 0}}), lost = message({{1, 0, 0, 0}, {nan, 0, 0}});
    Pose pose = reference_pose(c.mesh);
    pose[1].translation[2] = nan;
    std::string refused;
    try {
      body.begin(pose);
    } catch (const ModelError& e) {
      refused = e.what();
    }
    return Checked(stretched.find("second body is not rigid") != std::string::npos &&
                       lost.find("second body is not finite") != std::string::npos &&
                       refused.find("joint 1") != std::string::npos,
                   3, stretched + "; " + lost + "; " + refused);
  });
}

}  // namespace proptests::suite_collide
