#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/reach_packs.hpp"

#include <random>

#include "algorithms/runtime/collide/cluster_body.hpp"
#include "algorithms/model/procedural/procedural.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/random_posture.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness.hpp"

namespace proptests::suite_reach_packs {
namespace {

using namespace refitlab;

RigidTransform<double> random_placement(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {gen::random_rotation(random, 1), Point3(normal(random), normal(random), normal(random))};
}

// Rotations as files of floats have them: up to 1e-6 off in the square of their length.
void spoil_lengths(Posture& posture, std::mt19937& random) {
  std::uniform_real_distribution<double> off(-4.9e-7, 4.9e-7);
  for (auto& t : posture) t.rotation *= 1 + off(random);
}

std::vector<Point3> placed_vertices(const Character& c, const Posture& posture, const RigidTransform<double>& placement,
                                    Skinning skinning) {
  auto out = skin(c.mesh, c.sets, make_skinning_pose(c.mesh, c.sets, posture, skinning), skinning);
  for (Point3& p : out) p = apply(placement, p);
  return out;
}

bool holds(const Box<double>& box, const Point3& p) {
  for (int i = 0; i < 3; ++i)
    if (!(box.low[i] <= p[i] && p[i] <= box.high[i])) return false;
  return true;
}
bool holds(const Box<double>& box, const std::vector<Point3>& points, std::span<const int> vertices) {
  for (const int v : vertices)
    if (!holds(box, points[v])) return false;
  return true;
}

// Of some nodes, by their position.
struct NodeReach {
  std::vector<ReachPiecePack> packs;
  std::vector<FlippedBox> scratch;
  std::vector<Box<double>> boxes;

  NodeReach(const Character& c, const std::vector<int>& nodes)
      : packs(make_reach_packs(c, pieces_of_nodes(c, nodes))), scratch(nodes.size()), boxes(nodes.size()) {}

  // False if nothing is known of one.
  bool bound(Reach& reach, const Posture& posture, const RigidTransform<double>& placement,
             Target target = best_target()) {
    return std::isfinite(reach.box(posture, placement, target).low[0]) &&
           reach.boxes(packs, posture, placement, scratch, boxes, target);
  }
};

std::vector<int> all_nodes(const Character& c) {
  std::vector<int> out;
  for (std::size_t n = 0; n < c.tree.nodes.size(); ++n) out.push_back(static_cast<int>(n));
  return out;
}

constexpr Skinning all_skinnings[] = {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion, Skinning::hejl};

}  // namespace

PROPTEST(reach_packs) {
  t.holds("the boxes of nodes hold their vertices on every target, however joints are turned",
          {.number_type = "float", .cases = 300, .degenerate_at_least = 0.3}, [] {
            const auto plan = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const auto c = bake(gen::make_mesh(plan), {.triangles_per_leaf = *rc::gen::element(1, 10)});
            NodeReach nodes(c, all_nodes(c));
            if (nodes.packs.empty()) RC_DISCARD("too many joints");
            std::mt19937 random(plan.seed);
            const double spread = *rc::gen::element(0.0, 1e-3, 0.1, 0.5, 1.0);
            for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
              Reach reach(c.mesh, c.sets, skinning);
              for (int frame = 0; frame < 3; ++frame) {
                Posture posture = gen::random_posture(c.mesh, random, spread);
                if (frame == 1) spoil_lengths(posture, random);
                const auto placement = random_placement(random);
                const auto points = placed_vertices(c, posture, placement, skinning);
                for (const Target target : available_targets()) {
                  const bool is_bounded = nodes.bound(reach, posture, placement, target);
                  if (skinning == Skinning::linear) RC_ASSERT(is_bounded);
                  RC_TAG(is_bounded ? "bounded" : "unbounded");
                  for (std::size_t n = 0; is_bounded && n < nodes.boxes.size(); ++n)
                    RC_ASSERT(holds(nodes.boxes[n], points, c.vertices[n]));
                }
              }
            }
          });
  t.holds(
      "boxes hold vertices that are where a ball's bound is attained, of 1 to 8 joints, at every scale and place, however "
      "long quaternions are; and are wider by no more than what rounding is allowed",
      {.number_type = "float", .cases = 2000}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const double unit = *rc::gen::element(1.0, 1.0, 1e-12, 1e-18, 1e-30, 1e-45, 1e-300, 1e9, 1e10),
                     far = *rc::gen::element(0.0, 1.0, 1e6, 1e30, 1e300);
        const gen::Attained scene =
            gen::attained(random, {.unit = unit, .far = far, .joints = *rc::gen::inRange(1, most_reach_joints + 1)});
        const auto c = bake(scene.mesh, {.triangles_per_leaf = 8});
        NodeReach nodes(c, {0});
        RC_ASSERT(!nodes.packs.empty());
        const int joints = static_cast<int>(scene.mesh.joints.size());
        for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
          Reach reach(c.mesh, c.sets, skinning);
          const auto points = placed_vertices(c, scene.posture, scene.placement, skinning);
          for (const Target target : available_targets()) {
            RC_LOG() << scene.what;
            RC_ASSERT(nodes.bound(reach, scene.posture, scene.placement, target));
            RC_ASSERT(holds(nodes.boxes[0], points, c.vertices[0]));
            const double most = 2 * c.tree.nodes[0].reference.radius + 4 * lost_of_reach * joints * scene.size + 1e-17 +
                                1e-13 * upper_norm(scene.placement.translation);
            for (int i = 0; i < 3; ++i) {
              double low = infinite, high = -infinite;
              for (const Point3& p : points) low = std::min(low, p[i]), high = std::max(high, p[i]);
              RC_ASSERT(nodes.boxes[0].edges()[i] <= std::max(most, high - low));
            }
          }
        }
      });
  t.holds("joints that only turn, about points of their own, by rotations that are not quite of unit length",
          {.number_type = "float", .cases = 300}, [] {
            const auto plan = *gen::mesh_plan();
            const auto c = bake(gen::make_mesh(plan), {.triangles_per_leaf = 1});
            NodeReach nodes(c, all_nodes(c));
            if (nodes.packs.empty()) RC_DISCARD("too many joints");
            std::mt19937 random(plan.seed);
            std::normal_distribution<double> normal;
            const double spread = *rc::gen::element(1e-4, 1e-3, 1e-2, 0.3), far = *rc::gen::element(1.0, 30.0, 1000.0);
            Posture posture = gen::random_posture(c.mesh, random, spread);
            for (auto& joint : posture) {
              const Point3 pivot = Point3(normal(random), normal(random), normal(random)) * far;
              joint.translation = pivot - rotate(joint.rotation, pivot);
            }
            const RigidTransform<double> all{gen::random_rotation(random, 1), {0, 0, 0}};
            for (auto& joint : posture) joint = compose(all, joint);  // relative rotations stay small
            if (*rc::gen::arbitrary<bool>()) spoil_lengths(posture, random);
            for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
              const auto placement = random_placement(random);
              Reach reach(c.mesh, c.sets, skinning);
              if (!nodes.bound(reach, posture, placement)) continue;
              const auto points = placed_vertices(c, posture, placement, skinning);
              for (std::size_t n = 0; n < nodes.boxes.size(); ++n)
                RC_ASSERT(holds(nodes.boxes[n], points, c.vertices[n]));
            }
          });
  t.holds("the boxes of a body's clusters, from the joints alone or by control points, hold their vertices",
          {.number_type = "float", .cases = 200, .degenerate_at_least = 0.3}, [] {
            const auto plan = *gen::mesh_plan();
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const auto c = bake(gen::make_mesh(plan));
            const ClusterTree tree(c, {.most_triangles = *rc::gen::element(1, 5, 30), .most_children = 20});
            std::mt19937 random(plan.seed);
            const double spread = *rc::gen::element(0.0, 0.1, 0.5, 3.0);
            for (const Skinning skinning : all_skinnings) {
              ClusterBody body(tree, skinning);
              for (int frame = 0; frame < 3; ++frame) {
                const Posture posture = gen::random_posture(c.mesh, random, spread);
                const auto placement = random_placement(random);
                body.begin(posture, placement);
                if (frame == 1) {  // what is refused leaves the frame as it is
                  Posture bad = gen::random_posture(c.mesh, random, 3);
                  bad.back().rotation *= 2;
                  RC_ASSERT_THROWS_AS(body.begin(bad, placement), ModelError);
                }
                const auto points = placed_vertices(c, posture, placement, skinning);
                for (int fan = 0; fan < static_cast<int>(tree.fans().size()); ++fan)
                  for (int i = 0; i < tree.fans()[fan].child_count; ++i) {
                    if (tree.child(fan, i).cluster < 0) continue;
                    const Box<double> box = body.child_box(fan, i), whole = body.fan_box(fan);
                    RC_ASSERT(holds(box, points, tree.vertices().vertices(tree.child(fan, i).cluster)));
                    for (int k = 0; k < 3; ++k) RC_ASSERT(whole.low[k] <= box.low[k] && box.high[k] <= whole.high[k]);
                  }
              }
            }
          });
  t.example("a rotation center far away multiplies what rotations lack of unit length", {}, [] {
    SkinnedMesh model;
    model.name = "turned about a far point";
    model.vertices.assign(3, {0, 0, 0});
    model.triangles = {{0, 1, 2}};
    model.joints = {{"first", -1, {0, 0, 0}}, {"second", 0, {0, 0, 0}}};
    model.influences.assign(3, {{0, 0.5}, {1, 0.5}});
    const auto c = bake(std::move(model));
    NodeReach nodes(c, {0});
    Reach reach(c.mesh, c.sets, Skinning::spherical);
    const Point3 pivot(1000, 0, 0);
    bool ok = true;
    double farthest = 0;
    for (const double angle : {4e-5, 1e-4, 1e-3})
      for (const int who : {0, 1, 2})  // all joints, the first, the last
        for (const double off : {0.0, -4.9e-7, 4.9e-7}) {  // what held of a frame does not hold of the next
          RigidTransform<double> swing{{std::cos(angle / 2), 0, 0, std::sin(angle / 2)}, {0, 0, 0}};
          swing.translation = pivot - rotate(swing.rotation, pivot);
          const RigidTransform<double> about{{0, 0, 1, 0}, {0, 0, 0}};
          Posture posture{about, compose(about, swing)};
          if (who != 2) posture[0].rotation *= 1 + off;
          if (who != 1) posture[1].rotation *= 1 + off;
          const auto points = placed_vertices(c, posture, {}, Skinning::spherical);
          farthest = std::max(farthest, std::abs(points[0][0]));
          reach.box(posture, {});
          ok = ok && reach.boxes(nodes.packs, posture, {}, nodes.scratch, nodes.boxes) &&
               holds(nodes.boxes[0], points, c.vertices[0]) && (off != 0 || nodes.boxes[0].extent() < 1000 * angle * 1.1);
        }
    return Checked(ok && farthest > 1e-3, 27, "by up to " + std::to_string(farthest));
  });
  t.example("a single joint turns about its origin, however far, by a rotation that is not quite of unit length", {},
            [] {
              bool ok = true;
              long tried = 0;
              for (const double far : {1.0, 100.0, 1e3, 1e5})
                for (const double off : {-4.9e-7, 0.0, 4.9e-7}) {
                  SkinnedMesh model;
                  model.name = "far from its joint";
                  model.vertices = {{1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
                  model.triangles = {{0, 1, 2}};
                  model.joints = {{"far", -1, {far / 3, far, far / 7}}};
                  model.influences.assign(3, {{0, 1}});
                  const auto c = bake(std::move(model), {.triangles_per_leaf = 1});
                  NodeReach nodes(c, {0});
                  for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
                    Reach reach(c.mesh, c.sets, skinning);
                    std::mt19937 random(1);
                    for (int turn = 0; turn < 20; ++turn) {
                      Posture posture{{gen::random_rotation(random, 1), {0, 0, 0}}};
                      posture[0].rotation *= 1 + off;
                      const auto points = placed_vertices(c, posture, {}, skinning);
                      const Box<double> box = reach.box(posture, {});
                      ok = ok && holds(box, points, c.vertices[0]) &&
                           reach.boxes(nodes.packs, posture, {}, nodes.scratch, nodes.boxes) &&
                           holds(nodes.boxes[0], points, c.vertices[0]);
                      ++tried;
                    }
                  }
                }
              return Checked(ok, tried);
            });
  t.holds("what is so small that its squares underflow is held too", {.number_type = "float", .cases = 200}, [] {
    const auto plan = *gen::mesh_plan();
    const double scale = *rc::gen::element(1e-15, 1e-17, 1e-19, 1e-22, 1e-30, 1e-50);
    SkinnedMesh model = gen::make_mesh(plan);
    for (Point3& v : model.vertices) v *= scale;
    for (auto& joint : model.joints) joint.origin *= scale;
    const auto c = bake(std::move(model), {.triangles_per_leaf = 1});
    NodeReach nodes(c, all_nodes(c));
    if (nodes.packs.empty()) RC_DISCARD("too many joints");
    std::mt19937 random(plan.seed);
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
      Posture posture = gen::random_posture(c.mesh, random, 0.5);
      for (auto& joint : posture) joint.translation *= scale;
      auto placement = random_placement(random);
      placement.translation *= scale;
      Reach reach(c.mesh, c.sets, skinning);
      const auto points = placed_vertices(c, posture, placement, skinning);
      if (!nodes.bound(reach, posture, placement)) continue;
      for (std::size_t n = 0; n < nodes.boxes.size(); ++n) RC_ASSERT(holds(nodes.boxes[n], points, c.vertices[n]));
    }
  });
  t.example("the clusters of a walking man have boxes little larger than their vertices'", {}, [] {
    const auto man = bake(make_man());
    const ClusterTree tree(man, {.most_children = 96});  // one fan
    const int count = tree.fans()[0].child_count;
    std::string text = "sum of widths over that of the vertices' boxes: ";
    bool ok = true;
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
      Reach reach(man.mesh, man.sets, skinning);
      std::vector<FlippedBox> scratch(count);
      std::vector<Box<double>> boxes(count);
      double exact = 0, bounded = 0;
      for (int i = 0; i < 10; ++i) {
        const Posture posture = man.clips[0].sample(i / 10.0 * man.clips[0].duration);
        const auto points = placed_vertices(man, posture, {}, skinning);
        reach.box(posture, {});
        ok = ok && reach.boxes(tree.fans()[0].reach, posture, {}, scratch, boxes);
        for (int k = 0; k < count; ++k) {
          const auto vertices = tree.vertices().vertices(tree.child(0, k).cluster);
          auto box = Box<double>::empty();
          for (const int v : vertices) box.merge(points[v]);
          ok = ok && holds(boxes[k], points, vertices);
          exact += box.extent(), bounded += boxes[k].extent();
        }
      }
      ok = ok && bounded < (skinning == Skinning::linear ? 1.21 : 1.29) * exact;
      text += (skinning == Skinning::linear ? "" : ", ") + std::to_string(bounded / exact);
    }
    return Checked(ok, 3 * 10 * count, text);
  });
  t.example("what turns may add to the spread of a piece's box, and what its images may lack, is what reach_kernel.hpp says, rounded up", {}, [] {
    bool ok = true;
    long lanes = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 8, 6, 4, seed}));
      std::vector<int> nodes;
      for (int n = 0; n < std::min(20, static_cast<int>(c.tree.nodes.size())); ++n) nodes.push_back(n);
      const auto pieces = pieces_of_nodes(c, nodes);
      for (const ReachPiecePack& pack : make_reach_packs(c, pieces))
        for (int lane = 0; lane < reach_lanes; ++lane, ++lanes) {
          const double n = pack.ball.joint_count[lane];
          double squared_half = 0;
          for (int i = 0; i < 3; ++i) squared_half += std::pow(static_cast<double>(pack.half[i][lane]), 2);
          const double expected = std::sqrt(2 * n * (n - 1) * squared_half), spin = pack.spin[lane];
          ok = ok && spin >= expected * (1 - 1e-12) && spin <= expected * (1 + 1e-5);
          ok = ok && pack.box_unsolved[lane] >= std::sqrt(squared_half) * n / 64 * (1 - 1e-6);
        }
    }
    return Checked(ok && lanes > 1000, lanes);
  });
  t.example("nothing is known of nodes between joints half a turn apart", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 6, 5, 2, 1}));
    NodeReach nodes(c, {0});
    Reach reach(c.mesh, c.sets, Skinning::spherical);
    Posture posture(c.mesh.joints.size());
    const bool at_rest = nodes.bound(reach, posture, {});
    for (std::size_t j = 1; j < posture.size(); j += 2) posture[j].rotation = {0, 1, 0, 0};
    return at_rest && !nodes.bound(reach, posture, {});
  });
  t.example("pieces of too many joints or too far away have no packs", {}, [] {
    SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    const auto near = bake(model);
    for (Point3& v : model.vertices) v *= 1e25;
    const auto far = bake(model);
    return Checked(!make_reach_packs(near, pieces_of_nodes(near, all_nodes(near))).empty() &&
                   make_reach_packs(far, pieces_of_nodes(far, all_nodes(far))).empty());
  });
}

}  // namespace proptests::suite_reach_packs
