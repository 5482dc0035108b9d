// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/motion_bound_packs.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/cluster_body.hpp"
#include "algorithms/runtime/collide/motion_piece_merger.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "lemmas/b7_motion_bound.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/motion_pieces.hpp"
#include "proptests/oracles/placed_box.hpp"
#include "proptests/oracles/placed_vertices.hpp"

namespace proptests::suite_motion_bound_packs {
namespace {

using namespace refitlab;

bool holds(const Box<double>& box, const std::vector<Point3>& points, std::span<const int> vertices) {
  for (const int v : vertices)
    if (!oracle::holds(box, points[v])) return false;
  return true;
}

// Holds the motion bounds of some nodes, by their position.
struct NodeMotionBound {
  enum class Kind { single, merged };

  std::vector<MotionBoundPiecePack> packs;
  std::vector<FlippedBox> turned;
  std::vector<Box<double>> boxes;  // in the world

  NodeMotionBound(std::vector<MotionBoundPiecePack> bounds, std::size_t count)
      : packs(std::move(bounds)),
        turned(count),
        boxes(count) {}
  NodeMotionBound(const Character& c, const std::vector<int>& nodes)
      : NodeMotionBound(make_motion_bound_packs(c, oracle::motion_pieces(c, oracle::vertices_of_nodes(c, nodes))), nodes.size()) {
  }
  // Makes those of all nodes, of which pieces are merged or not.
  NodeMotionBound(const Character& c, Kind kind)
      : NodeMotionBound(make_motion_bound_packs(c, pieces(c, kind)), c.tree.nodes.size()) {}
  static std::vector<MotionPiece> pieces(const Character& c, Kind kind) {
    const auto lists = oracle::vertices_of_nodes(c);
    return kind == Kind::merged ? MotionPieceMerger(c).pieces(lists) : oracle::motion_pieces(c, lists);
  }

  // Bounds the nodes. Returns false if nothing is known of one of them.
  bool bound(MotionBound& motion_bound, const Pose& pose, const RigidTransform<double>& placement,
             Target target = best_target()) {
    return std::isfinite(motion_bound.box(pose, placement, target).low[0]) &&
           bound_again(motion_bound, pose, placement.translation);
  }
  // Bounds them again in the pose and placement of the last box, by the same target.
  bool bound_again(MotionBound& motion_bound, const Pose& pose, const Point3& translation) {
    if (!motion_bound.boxes(packs, pose, turned)) return false;
    for (std::size_t n = 0; n < boxes.size(); ++n) {
      boxes[n] = turned[n].box();
      for (int i = 0; i < 3; ++i) {
        double &low = boxes[n].low[i], &high = boxes[n].high[i];
        const double lost = motion_bound.lost() + 1e-14 * (std::max(std::abs(low), std::abs(high)) + std::abs(translation[i]));
        low += translation[i] - lost, high += translation[i] + lost;
      }
    }
    return true;
  }
};

std::vector<int> all_nodes(const Character& c) {
  std::vector<int> out;
  for (std::size_t n = 0; n < c.tree.nodes.size(); ++n) out.push_back(static_cast<int>(n));
  return out;
}

void boxes_of_nodes_hold_their_vertices(Suite& t) {
  t.holds("the boxes of nodes hold their vertices on every target, however joints are turned",
          {.number_type = "float", .cases = 300, .degenerate_at_least = 0.3, .tags_at_least = {{"bounded", 0.5}}}, [] {
            const auto plan = gen::classified_plan();
            const auto c = bake(gen::make_mesh(plan), {.triangles_per_leaf = *rc::gen::element(1, 10)});
            std::mt19937 random(plan.seed);
            NodeMotionBound nodes(c, random() % 2 ? NodeMotionBound::Kind::merged : NodeMotionBound::Kind::single);
            if (nodes.packs.empty()) RC_DISCARD("too many joints");
            const double spread = *rc::gen::element(0.0, 1e-3, 0.1, 0.5, 1.0);
            for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
              MotionBound motion_bound(c.mesh, c.sets, skinning);
              for (int frame = 0; frame < 3; ++frame) {
                Pose pose = gen::random_pose(c.mesh, random, spread);
                if (frame == 1) gen::spoil_lengths(pose, random);
                const auto placement = gen::random_placement(random);
                const auto points = oracle::placed_vertices(c.mesh, c.sets, pose, skinning, placement);
                for (const Target target : available_targets()) {
                  const bool is_bounded = nodes.bound(motion_bound, pose, placement, target);
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
            gen::attained(random, {.unit = unit, .far = far, .joints = *rc::gen::inRange(1, most_motion_bound_joints + 1)});
        const auto c = bake(scene.mesh, {.triangles_per_leaf = 8});
        NodeMotionBound nodes(c, {0});
        RC_ASSERT(!nodes.packs.empty());
        const int joints = static_cast<int>(scene.mesh.joints.size());
        for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
          MotionBound motion_bound(c.mesh, c.sets, skinning);
          const auto points = oracle::placed_vertices(c.mesh, c.sets, scene.pose, skinning, scene.placement);
          for (const Target target : available_targets()) {
            RC_LOG() << scene.what;
            RC_ASSERT(nodes.bound(motion_bound, scene.pose, scene.placement, target));
            RC_ASSERT(holds(nodes.boxes[0], points, c.vertices[0]));
            const double most = 2 * c.tree.nodes[0].reference.radius + 4 * lost_of_motion_bound * joints * scene.size + 1e-17 +
                                1e-13 * upper_norm(scene.placement.translation);
            for (int i = 0; i < 3; ++i) {
              double low = infinite, high = -infinite;
              for (const Point3& p : points) low = std::min(low, p[i]), high = std::max(high, p[i]);
              RC_ASSERT(nodes.boxes[0].edges()[i] <= std::max(most, high - low));
            }
          }
        }
      });
}

// Says whether the boxes of all clusters hold their vertices, and those of wide nodes hold theirs.
bool are_clusters_held(ClusterBody& body, const std::vector<Point3>& points) {
  const ClusterTree& tree = body.tree();
  bool ok = true;
  for (int wide_node = 0; wide_node < static_cast<int>(tree.wide_nodes().size()); ++wide_node)
    for (int i = 0; i < tree.wide_nodes()[wide_node].child_count; ++i) {
      if (tree.child(wide_node, i).cluster < 0) continue;
      const Box<double> box = oracle::in_world(body, get_box(body.wide_node_boxes(wide_node), i)),
                        whole = oracle::in_world(body, body.wide_node_box(wide_node));
      ok = ok && holds(box, points, tree.vertices().vertices(tree.child(wide_node, i).cluster));
      for (int k = 0; k < 3; ++k) ok = ok && whole.low[k] <= box.low[k] && box.high[k] <= whole.high[k];
    }
  return ok;
}

// Says whether a body's boxes hold the motion bounds of its nodes, with all that these may be off by, where something is known of
// them. pose is that of the last box.
bool are_motion_bounds_held(ClusterBody& body, MotionBound& motion_bound, const Pose& pose) {
  bool ok = true;
  for (int wide_node = 0; wide_node < static_cast<int>(body.tree().wide_nodes().size()); ++wide_node) {
    const WideNode& node = body.tree().wide_nodes()[wide_node];
    std::vector<FlippedBox> turned(static_cast<std::size_t>(node.child_count));
    if (!motion_bound.boxes(node.motion_bounds, pose, turned)) continue;
    for (int i = 0; i < node.child_count; ++i) {
      const Box<float> box = get_box(body.wide_node_boxes(wide_node), i);
      const Box<double> inner = turned[static_cast<std::size_t>(i)].box();
      for (int k = 0; k < 3; ++k)
        ok = ok && box.low[k] <= inner.low[k] - motion_bound.lost() && box.high[k] >= inner.high[k] + motion_bound.lost();
    }
  }
  return ok;
}

void turning_joints_and_clusters_of_bodies(Suite& t) {
  t.holds("joints that only turn, about points of their own, by rotations that are not quite of unit length",
          {.number_type = "float", .cases = 300, .tags_at_least = {{"bounded", 0.5}}}, [] {
            const auto plan = *gen::mesh_plan();
            const auto c = bake(gen::make_mesh(plan), {.triangles_per_leaf = 1});
            NodeMotionBound nodes(c, all_nodes(c));
            if (nodes.packs.empty()) RC_DISCARD("too many joints");
            const ClusterTree tree(c, {.most_triangles = 1});
            std::mt19937 random(plan.seed);
            std::normal_distribution<double> normal;
            const double spread = *rc::gen::element(1e-4, 1e-3, 1e-2, 0.3), far = *rc::gen::element(1.0, 30.0, 1000.0);
            Pose pose = gen::random_pose(c.mesh, random, spread);
            for (auto& joint : pose) {
              const Point3 pivot = Point3(normal(random), normal(random), normal(random)) * far;
              joint.translation = pivot - rotate(joint.rotation, pivot);
            }
            const RigidTransform<double> all{gen::random_rotation(random, 1), {0, 0, 0}};
            for (auto& joint : pose) joint = compose(all, joint);  // relative rotations stay small
            if (*rc::gen::arbitrary<bool>()) gen::spoil_lengths(pose, random);
            for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
              const auto placement = gen::random_placement(random);
              MotionBound motion_bound(c.mesh, c.sets, skinning);
              if (!nodes.bound(motion_bound, pose, placement)) continue;
              RC_TAG("bounded");
              const auto points = oracle::placed_vertices(c.mesh, c.sets, pose, skinning, placement);
              for (std::size_t n = 0; n < nodes.boxes.size(); ++n) RC_ASSERT(holds(nodes.boxes[n], points, c.vertices[n]));
              ClusterBody body(tree, skinning);
              body.begin(pose, placement);
              RC_ASSERT(are_clusters_held(body, points) && are_motion_bounds_held(body, motion_bound, pose));
            }
          });
  t.holds("the boxes of a body's clusters, from the joints alone or by control points, hold their vertices",
          {.number_type = "float", .cases = 200, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            const auto c = bake(gen::make_mesh(plan));
            const ClusterTree tree(c, {.most_triangles = *rc::gen::element(1, 5, 30), .most_children = 20});
            std::mt19937 random(plan.seed);
            const double spread = *rc::gen::element(0.0, 0.1, 0.5, 3.0);
            for (const Skinning skinning : gen::all_skinnings) {
              ClusterBody body(tree, skinning);
              for (int frame = 0; frame < 3; ++frame) {
                const Pose pose = gen::random_pose(c.mesh, random, spread);
                const auto placement = gen::random_placement(random);
                body.begin(pose, placement);
                // A refusal leaves the frame as it is.
                if (frame == 1) {
                  Pose bad = gen::random_pose(c.mesh, random, 3);
                  bad.back().rotation *= 2;
                  RC_ASSERT_THROWS_AS(body.begin(bad, placement), ModelError);
                }
                const auto points = oracle::placed_vertices(c.mesh, c.sets, pose, skinning, placement);
                RC_ASSERT(are_clusters_held(body, points));
              }
            }
          });
}

void rotations_off_unit_length(Suite& t) {
  t.example("a rotation center far away multiplies what rotations lack of unit length", {}, [] {
    SkinnedMesh model;
    model.name = "turned about a far point";
    model.vertices.assign(3, {0, 0, 0});
    model.triangles = {{0, 1, 2}};
    model.joints = {{"first", -1, {0, 0, 0}}, {"second", 0, {0, 0, 0}}};
    model.influences.assign(3, {{0, 0.5}, {1, 0.5}});
    const auto c = bake(std::move(model));
    NodeMotionBound nodes(c, {0});
    MotionBound motion_bound(c.mesh, c.sets, Skinning::spherical);
    const Point3 pivot(1000, 0, 0);
    bool ok = true;
    double farthest = 0;
    for (const double angle : {4e-5, 1e-4, 1e-3})
      // These joints are all, the first, and the last.
      for (const int who : {0, 1, 2})
        // A result for one frame does not hold for the next.
        for (const double off : {0.0, -4.9e-7, 4.9e-7}) {
          RigidTransform<double> swing{{std::cos(angle / 2), 0, 0, std::sin(angle / 2)}, {0, 0, 0}};
          swing.translation = pivot - rotate(swing.rotation, pivot);
          const RigidTransform<double> about{{0, 0, 1, 0}, {0, 0, 0}};
          Pose pose{about, compose(about, swing)};
          if (who != 2) pose[0].rotation *= 1 + off;
          if (who != 1) pose[1].rotation *= 1 + off;
          const auto points = oracle::placed_vertices(c.mesh, c.sets, pose, Skinning::spherical);
          farthest = std::max(farthest, std::abs(points[0][0]));
          motion_bound.box(pose, {});
          ok = ok && nodes.bound_again(motion_bound, pose, Point3::Zero()) && holds(nodes.boxes[0], points, c.vertices[0]) &&
               (off != 0 || nodes.boxes[0].extent() < 1000 * angle * 1.1);
        }
    return Checked(ok && farthest > 1e-3, 27, "by up to " + std::to_string(farthest));
  });
  t.example("a single joint turns about its origin, however far, by a rotation that is not quite of unit length", {}, [] {
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
        NodeMotionBound nodes(c, {0});
        for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
          MotionBound motion_bound(c.mesh, c.sets, skinning);
          std::mt19937 random(1);
          for (int turn = 0; turn < 20; ++turn) {
            Pose pose{{gen::random_rotation(random, 1), {0, 0, 0}}};
            pose[0].rotation *= 1 + off;
            const auto points = oracle::placed_vertices(c.mesh, c.sets, pose, skinning);
            const Box<double> box = motion_bound.box(pose, {});
            ok = ok && holds(box, points, c.vertices[0]) && nodes.bound_again(motion_bound, pose, Point3::Zero()) &&
                 holds(nodes.boxes[0], points, c.vertices[0]);
            ++tried;
          }
        }
      }
    return Checked(ok, tried);
  });
}

// Says whether a pack has what is known of a piece's weights, rounded to the safe side.
bool are_weights_rounded(const MotionBoundPiecePack& pack, std::size_t lane, const PieceWeights& weights) {
  const auto is_just_above = [](float x, double of) { return x >= of && x <= of * (1 + 3e-7); };
  double rest = 1;
  bool ok = true;
  for (std::size_t k = 0; k < most_motion_bound_joints; ++k) {
    const double least = k < weights.least.size() ? weights.least[k] : 0, rounded = pack.least[k][lane];
    ok = ok && rounded <= least && rounded >= least * (1 - 3e-7);
    rest -= rounded;
  }
  return ok && is_just_above(pack.rest[lane], rest) && is_just_above(pack.products[lane], weights.products) &&
         is_just_above(pack.squared_products[lane], weights.squared_products);
}

void tiny_models_and_tight_boxes(Suite& t) {
  t.holds("what is so small that its squares underflow is held too", {.number_type = "float", .cases = 200}, [] {
    const auto plan = *gen::mesh_plan();
    const double scale = *rc::gen::element(1e-15, 1e-17, 1e-19, 1e-22, 1e-30, 1e-50);
    SkinnedMesh model = gen::make_mesh(plan);
    for (Point3& v : model.vertices) v *= scale;
    for (auto& joint : model.joints) joint.origin *= scale;
    const auto c = bake(std::move(model), {.triangles_per_leaf = 1});
    NodeMotionBound nodes(c, all_nodes(c));
    if (nodes.packs.empty()) RC_DISCARD("too many joints");
    std::mt19937 random(plan.seed);
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
      Pose pose = gen::random_pose(c.mesh, random, 0.5);
      for (auto& joint : pose) joint.translation *= scale;
      auto placement = gen::random_placement(random);
      placement.translation *= scale;
      MotionBound motion_bound(c.mesh, c.sets, skinning);
      const auto points = oracle::placed_vertices(c.mesh, c.sets, pose, skinning, placement);
      const bool is_bounded = nodes.bound(motion_bound, pose, placement);
      if (skinning == Skinning::linear) RC_ASSERT(is_bounded);
      for (std::size_t n = 0; is_bounded && n < nodes.boxes.size(); ++n) RC_ASSERT(holds(nodes.boxes[n], points, c.vertices[n]));
    }
  });
  t.example("the clusters of a walking man have boxes little larger than their vertices'", {}, [] {
    const auto man = bake_animated(make_man());
    // It has one wide node.
    const ClusterTree tree(man, {.most_children = 96});
    const int count = tree.wide_nodes()[0].child_count;
    std::string text = "sum of widths over that of the vertices' boxes: ";
    bool ok = true;
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
      MotionBound motion_bound(man.mesh, man.sets, skinning);
      NodeMotionBound nodes(tree.wide_nodes()[0].motion_bounds, static_cast<std::size_t>(count));
      double exact = 0, bounded = 0;
      for (int i = 0; i < 10; ++i) {
        const Pose pose = man.clips[0].sample(i / 10.0 * man.clips[0].duration);
        const auto points = oracle::placed_vertices(man.mesh, man.sets, pose, skinning);
        ok = ok && nodes.bound(motion_bound, pose, {});
        for (int k = 0; k < count; ++k) {
          const auto vertices = tree.vertices().vertices(tree.child(0, k).cluster);
          auto box = Box<double>::empty();
          for (const int v : vertices) box.merge(points[v]);
          ok = ok && holds(nodes.boxes[k], points, vertices);
          exact += box.extent(), bounded += nodes.boxes[k].extent();
        }
      }
      ok = ok && bounded < (skinning == Skinning::linear ? 1.14 : 1.204) * exact;
      text += (skinning == Skinning::linear ? "" : ", ") + std::to_string(bounded / exact);
    }
    return Checked(ok, 3 * 10 * count, text);
  });
}

void packs_are_rounded_to_the_safe_side(Suite& t) {
  t.example(
      "what turns may add to the spread of a piece's box, what its images may lack, and what is known of its weights, is what "
      "motion_bound_kernel.hpp says, rounded to the safe side",
      {}, [] {
        bool ok = true;
        long lanes = 0;
        for (unsigned seed = 0; seed < 20; ++seed) {
          SkinnedMesh tube = gen::make_mesh({gen::MeshKind::tube, 8, 6, 4, seed});
          for (std::size_t v = 0; v < tube.influences.size(); ++v) {  // Neither weights nor what they leave of 1 are floats.
            auto& influences = tube.influences[v];
            double all = 0;
            for (std::size_t k = 0; k < influences.size(); ++k)
              all += influences[k].weight = static_cast<double>(k + 1 + (7 * v + 3 * k) % 5);
            for (auto& influence : influences) influence.weight /= all;
          }
          const auto c = bake(std::move(tube));
          std::vector<int> nodes;
          for (int n = 0; n < std::min(20, static_cast<int>(c.tree.nodes.size())); ++n) nodes.push_back(n);
          auto pieces = oracle::motion_pieces(c, oracle::vertices_of_nodes(c, nodes));
          const auto packs = make_motion_bound_packs(c, pieces);
          std::stable_sort(pieces.begin(), pieces.end(), [](const MotionPiece& p, const MotionPiece& q) {
            return p.weights.least.size() > q.weights.least.size();
          });
          for (std::size_t i = 0; i < packs.size() * motion_bound_lanes; ++i, ++lanes) {
            const MotionBoundPiecePack& pack = packs[i / motion_bound_lanes];
            const std::size_t lane = i % motion_bound_lanes;
            const MotionPiece& piece = pieces[std::min(i, pieces.size() - 1)];
            const double n = static_cast<double>(piece.weights.least.size()), radius = piece.reference.radius;
            const double expected = std::sqrt(2 * n * (n - 1)) * radius, spin = pack.spin[lane];
            ok = ok && pack.ball.joint_count[lane] == n && spin >= expected * (1 - 1e-12) && spin <= expected * (1 + 1e-5);
            ok = ok && pack.unsolved_more[lane] >= radius * n / 64 * (1 - 1e-6);
            ok = ok && are_weights_rounded(pack, lane, piece.weights);
          }
        }
        return Checked(ok && lanes > 1000, lanes);
      });
}

void rods_half_turns_and_what_has_no_pack(Suite& t) {
  t.example("across a rod whose ends turn apart, the box is that of the images, and what turns add", {}, [] {
    SkinnedMesh rod;
    rod.name = "rod";
    rod.joints = {{"first", -1, {0, 0, 0}}, {"second", 0, {0, 0, 0}}};
    for (const double x : {-1.0, 1.0})
      for (const double y : {-0.01, 0.01})
        for (const double w : {0.0, 0.5, 1.0}) {
          rod.vertices.push_back({x, y, 0});
          rod.influences.push_back({{0, w}, {1, 1 - w}});
        }
    rod.triangles = {{0, 1, 6}, {2, 3, 7}, {4, 5, 8}, {9, 10, 11}};
    const auto c = bake(std::move(rod), {.triangles_per_leaf = 8});
    NodeMotionBound nodes(c, {0});
    MotionBound motion_bound(c.mesh, c.sets, Skinning::spherical);
    const double half_diagonal = std::hypot(1, 0.01);
    std::string wrong;
    long tried = 0;
    for (const double degrees : {20., 40., 60., 80.}) {
      const double half = degrees / 360 * std::numbers::pi, cosine = std::cos(half), sine = std::sin(half);
      const Pose pose{{{std::cos(half / 2), 0, 0, std::sin(half / 2)}, {0, 0, 0}},
                      {{std::cos(half / 2), 0, 0, -std::sin(half / 2)}, {0, 0, 0}}};
      const double share = std::sqrt(squared_deviation_share(cosine)) + error_share(0), of_images = sine + 0.01 * cosine;
      const double low = of_images + share * half_diagonal * 2 * sine,
                   high = of_images + share * half_diagonal * (2 * sine + 1.0 / 32);
      for (const Target target : available_targets()) {
        if (!nodes.bound(motion_bound, pose, {}, target)) wrong += "no bound; ";
        const double across = nodes.boxes[0].high[1];
        if (!(across >= low * (1 - 1e-6) && across <= high + 1e-4))
          wrong += std::to_string(across) + " of " + std::to_string(low) + " to " + std::to_string(high) + "; ";
        ++tried;
      }
    }
    return Checked(wrong.empty(), tried, wrong);
  });
  t.example("nothing is known of nodes between joints half a turn apart", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 6, 5, 2, 1}));
    NodeMotionBound nodes(c, {0});
    MotionBound motion_bound(c.mesh, c.sets, Skinning::spherical);
    Pose pose(c.mesh.joints.size());
    const bool at_rest = nodes.bound(motion_bound, pose, {});
    for (std::size_t j = 1; j < pose.size(); j += 2) pose[j].rotation = {0, 1, 0, 0};
    return at_rest && !nodes.bound(motion_bound, pose, {});
  });
  t.example("pieces of too many joints or too far away have no packs", {}, [] {
    SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    const auto near = bake(model);
    for (Point3& v : model.vertices) v *= 1e25;
    const auto far = bake(model);
    return Checked(!NodeMotionBound(near, all_nodes(near)).packs.empty() && NodeMotionBound(far, all_nodes(far)).packs.empty());
  });
}

}  // namespace

PROPTEST(motion_bound_packs) {
  boxes_of_nodes_hold_their_vertices(t);
  turning_joints_and_clusters_of_bodies(t);
  rotations_off_unit_length(t);
  tiny_models_and_tight_boxes(t);
  packs_are_rounded_to_the_safe_side(t);
  rods_half_turns_and_what_has_no_pack(t);
}

}  // namespace proptests::suite_motion_bound_packs
