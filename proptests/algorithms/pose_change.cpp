// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/pose_change.hpp"

#include <array>
#include <random>

#include "algorithms/bake/bake.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/collide/pose_change_kernel.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "lemmas/b9_pose_change.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"
#include "proptests/oracles/placed_vertices.hpp"

namespace proptests::suite_pose_change {
namespace {

using namespace refitlab;

// Returns the greatest | ||q||^2 - 1 |.
double greatest_defect(const Pose& pose) {
  double most = 0;
  for (const auto& joint : pose) most = std::max(most, std::abs(squared_norm(joint.rotation) - 1));
  return most;
}

// Returns the pose with each joint turned and moved by itself by about so much. Quaternions change their signs at random.
Pose changed(Pose pose, double by, std::mt19937& random) {
  std::normal_distribution<double> normal;
  for (auto& joint : pose) {
    joint.rotation = multiply(gen::random_rotation(random, by), joint.rotation);
    joint.rotation /= joint.rotation.norm();
    joint.translation += Point3(normal(random), normal(random), normal(random)) * by;
    if (random() % 2) joint.rotation = -joint.rotation;
  }
  return pose;
}

void boxes_hold_the_vertices_of_later_poses(Suite& t) {
  t.holds(
      "the box holds all vertices of a later pose, however much joints and placement have changed, in every skinning",
      {.number_type = "float", .cases = 500, .degenerate_at_least = 0.3, .tags_at_least = {{"bounded", 0.4}, {"no bound", 0.2}}},
      [] {
        const auto plan = gen::classified_plan();
        SkinnedMesh mesh = gen::make_mesh(plan);
        std::mt19937 random(plan.seed);
        std::normal_distribution<double> normal;
        const double far = *rc::gen::element(0.0, 0.0, 10.0, 1e5, 1e8);
        for (Joint& joint : mesh.joints) joint.origin += Point3(normal(random), normal(random), normal(random)) * far;
        const JointSets sets(mesh);
        const double spread = *rc::gen::element(0.0, 1e-3, 0.1, 0.5), by = *rc::gen::element(0.0, 1e-6, 1e-3, 0.03, 0.1, 0.5);
        for (const Skinning skinning : gen::all_skinnings) {
          MotionBound motion_bound(mesh, sets, skinning);
          PoseChange change(motion_bound);
          Pose pose = gen::random_pose(mesh, random, spread);
          const RigidTransform<double> placement = gen::near_or_far_placement(random);
          motion_bound.box(pose, placement);
          const bool is_posed = motion_bound.posed().has_value();
          change.start(motion_bound, pose, placement);
          for (int frame = 0; frame < 3; ++frame) {
            pose = changed(pose, by, random);
            RigidTransform<double> at = gen::near_or_far_placement(random);
            if (frame != 1) at.rotation = placement.rotation;
            if (frame == 2) gen::spoil_lengths(pose, random), at.rotation = gen::random_rotation(random, by);
            const auto vertices = oracle::placed_vertices(mesh, sets, pose, skinning, at);
            const double off = greatest_defect(pose);
            for (const Target target : available_targets()) {
              const auto box = change.box(pose, at, target);
              if (box) RC_ASSERT(is_posed && off <= 1e-6 && oracle::holds(*box, vertices));
              // Only blends that deviate, and rotations that have come apart, leave a pose without a bound.
              if (!motion_bound.deviates() && off < 4e-7) RC_ASSERT(box.has_value());
              if (motion_bound.deviates() && frame == 0) RC_TAG(box ? "bounded" : "no bound");
              if (by == 0 && spread == 0 && off < 4e-7) RC_ASSERT(box.has_value());
            }
          }
        }
      });
  t.holds("the box holds vertices where a ball's bound is attained, of 1 to 90 joints, at every scale and place",
          {.number_type = "float", .cases = 1000, .tags_at_least = {{"bounded", 0.5}}}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const double unit = *rc::gen::element(1.0, 1.0, 1e-12, 1e-18, 1e-30, 1e-300, 1e9),
                         far = *rc::gen::element(0.0, 1.0, 1e6, 1e30, 1e300);
            const gen::Attained scene = gen::attained(random, {.unit = unit, .far = far});
            const JointSets sets(scene.mesh);
            const Skinning skinning = gen::random_skinning(random);
            MotionBound motion_bound(scene.mesh, sets, skinning);
            // All joints turn alike, from the same pose or from one a little aside.
            const RigidTransform<double> aside{gen::random_rotation(random, 0.1), {0, unit, 0}};
            Pose before = scene.pose;
            const bool is_aside = random() % 2;
            if (is_aside)
              for (auto& joint : before) joint = compose(aside, joint);
            PoseChange change(motion_bound);
            motion_bound.box(before, scene.placement);
            change.start(motion_bound, before, scene.placement);
            const auto vertices = oracle::placed_vertices(scene.mesh, sets, scene.pose, skinning, scene.placement);
            for (const Target target : available_targets()) {
              const auto box = change.box(scene.pose, scene.placement, target);
              RC_LOG() << scene.what;
              RC_TAG(box ? "bounded" : "no bound");
              if (box) RC_ASSERT(oracle::holds(*box, vertices));
            }
          });
}

void how_much_larger(Suite& t) {
  t.example("a walking man's box of a hundredth or two of a step ago is larger by little more than he has moved", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    std::string text = "mean growth in metres on each side: ";
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings)
      for (const int steps : {0, 1, 2}) {
        MotionBound motion_bound(man, sets, skinning);
        PoseChange change(motion_bound);
        double growth = 0;
        for (int i = 0; i < 100; ++i) {
          const auto sample = [&](int k) { return man.clips[0].sample(k % 100 / 100.0 * man.clips[0].duration); };
          const Box<double> before = motion_bound.box(sample(i), {});
          change.start(motion_bound, sample(i), {});
          const auto box = change.box(sample(i + steps), {});
          if (!box) return Checked(false, i, "no bound");
          growth += (box->extent() - before.extent()) / 6 / 100;
        }
        const bool deviates = skinning == Skinning::spherical || skinning == Skinning::dual_quaternion;
        ok = ok && growth < 0.005 + (deviates ? 0.08 : 0.03) * steps && growth > 0;
        text += (steps == 0 ? "/ " : "") + std::to_string(growth) + " ";
      }
    return Checked(ok, 1200, text);
  });
  t.example("what a placement moves by does not make the box larger, and what it turns by does, by twice the sine of the half",
            {}, [] {
              const Model man = make_man();
              const JointSets sets(man);
              MotionBound motion_bound(man, sets, Skinning::spherical);
              PoseChange change(motion_bound);
              const Pose pose = reference_pose(man);
              motion_bound.box(pose, {});
              change.start(motion_bound, pose, {});
              const double still = change.box(pose, {})->extent(),
                           moved = change.box(pose, {identity_quaternion<double>(), {5, -3, 40}})->extent(),
                           turned = change.box(pose, {{std::cos(0.05), 0, std::sin(0.05), 0}, {0, 0, 0}})->extent(),
                           opposite = change.box(pose, {{-std::cos(0.05), 0, -std::sin(0.05), 0}, {0, 0, 0}})->extent();
              // He is 1.8 metres tall and stands at the origin.
              const double reach = (turned - still) / 6 / (2 * 2 * std::sin(0.025));
              return Checked(std::abs(moved - still) < 1e-9 && opposite == turned && reach > 1.8 && reach < 2.1, 4,
                             std::to_string(reach) + " metres from the origin");
            });
}

// Returns how the lemma says that bounds grow, with the share for errors, beside rounding.
double growth_of_lemma(const MotionBound& bound, const Pose& before, const Pose& after) {
  const JointAnchors& anchors = bound.anchors();
  const PoseChangeKernels& kernels = pose_change_kernels(best_target());
  std::vector<Lanes<float>> kept(static_cast<std::size_t>(rows_of_kept_pose * anchors.stride / Lanes<float>::count));
  JointChange change;
  kernels.keep(before[0].rotation.data(), anchors.joint_count, anchors.stride, anchors.rows(), kept.data()->lane.data());
  kernels.compare(after[0].rotation.data(), anchors.joint_count, anchors.stride, anchors.rows(), kept.data()->lane.data(),
                  change);
  const auto posed = *bound.posed();
  const double after_change = cosine_after_change<double>(posed.cosine, change.turned), moved = change.moved,
               n = bound.most_joints();
  const auto share_at = [](double cosine) { return std::sqrt(squared_deviation_share(cosine)); };
  const double share = share_at(after_change) + error_share(1e-6);
  if (after_change >= 0.6) return moved + share_at(1 - 2 * change.turned) * posed.spread + share * n * moved;
  return moved + share * (posed.spread + n * moved);
}

void boxes_grow_as_the_lemma_says(Suite& t) {
  t.example("on both sides of a cosine of 3/5 that is left, and where nothing turns, boxes grow as the lemma says", {}, [] {
    const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    const JointSets sets(mesh);
    const auto turned = [&](double half_angle) {
      Pose pose = reference_pose(mesh);
      pose[1].rotation = {std::cos(half_angle), std::sin(half_angle), 0, 0};
      return pose;
    };
    bool ok = true;
    std::string text;
    // The cosine was 3/4, and 3/4, 0.66, 0.61, 0.58 or 0.4 are left.
    const double half = std::acos(0.75);
    for (const double more : {0.0, 0.045, 0.07, 0.085, 0.175})
      for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
        MotionBound motion_bound(mesh, sets, skinning);
        PoseChange change(motion_bound);
        motion_bound.box(turned(half), {});
        change.start(motion_bound, turned(half), {});
        const double expected = growth_of_lemma(motion_bound, turned(half), turned(half + more)),
                     grown = (change.box(turned(half + more), {})->extent() - motion_bound.posed()->turned.extent()) / 6;
        // Where cosines fall by rounding alone, the share of a turn is a hundredth of a half.
        ok = ok && grown > expected && grown < 1.002 * expected + 0.01;
        text += std::to_string(grown) + " of " + std::to_string(expected) + " ";
      }
    return Checked(ok, 10, text);
  });
}

void what_joints_carry(Suite& t) {
  t.example("joints that turn in opposite directions about images that stay raise the vertex between them, within the box", {},
            [] {
              SkinnedMesh mesh;
              mesh.name = "raised";
              mesh.vertices.assign(3, {0, 0, 0});
              mesh.triangles = {{0, 1, 2}};
              mesh.joints = {{"left", -1, {0, 0, 0}}, {"right", 0, {0, 0, 0}}};
              mesh.influences.assign(3, {{0, 0.5}, {1, 0.5}});
              const JointSets sets(mesh);
              MotionBound motion_bound(mesh, sets, Skinning::dual_quaternion);
              PoseChange change(motion_bound);
              const Pose still{{identity_quaternion<double>(), {-1, 0, 0}}, {identity_quaternion<double>(), {1, 0, 0}}};
              const double before = motion_bound.box(still, {}).high[1];
              change.start(motion_bound, still, {});
              double raised = 0;
              bool ok = true;
              for (const double half : {-0.3, 0.1, 0.2, 0.3}) {  // of the angle, in radians
                const Pose pose{{{std::cos(half), 0, 0, std::sin(half)}, {-1, 0, 0}},
                                {{std::cos(half), 0, 0, -std::sin(half)}, {1, 0, 0}}};
                const auto vertices = oracle::placed_vertices(mesh, sets, pose, Skinning::dual_quaternion);
                raised = std::max(raised, std::abs(vertices[0][1]));
                const auto box = change.box(pose, {});
                ok = ok && box && oracle::holds(*box, vertices);
              }
              return Checked(ok && raised > 2 * before, 4,
                             std::to_string(raised) + ", and the earlier box reaches " + std::to_string(before));
            });
  t.example("points on both sides of a joint's anchor turn about it, within the box", {}, [] {
    SkinnedMesh mesh;
    mesh.name = "seesaw";
    mesh.vertices = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    mesh.joints = {{"first", -1, {0, 0, 0}}, {"second", 0, {0, 0, 0}}, {"third", 0, {0, 0, 0}}};
    mesh.influences.assign(3, {{0, 0.5}, {1, 0.5}});
    mesh.influences.resize(6, {{0, 0.5}, {2, 0.5}});
    const JointSets sets(mesh);
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(mesh, sets, skinning);
      PoseChange change(motion_bound);
      motion_bound.box(reference_pose(mesh), {});
      change.start(motion_bound, reference_pose(mesh), {});
      for (const double half : {0.01, 0.1, 0.25}) {  // of the angle, in radians
        // The others stay, so that no image of an anchor moves.
        Pose turned = reference_pose(mesh);
        turned[0].rotation = {std::cos(half), 0, 0, std::sin(half)};
        const auto box = change.box(turned, {});
        ok = ok && box && oracle::holds(*box, oracle::placed_vertices(mesh, sets, turned, skinning));
        // The rotation centers are the points that Hejl's skinning looks at, and they are a metre away.
        ok = ok && (skinning == Skinning::hejl || box->high[1] < 8 * half);
      }
    }
    return Checked(ok, 12);
  });
}

void anchors_of_joints(Suite& t) {
  t.example("an anchor is in the middle of a joint's points, and what is farthest counts, of joints that have any", {}, [] {
    const JointAnchors anchors =
        make_joint_anchors({{{1, 0, 0}, {3, 0, 0}}, {}, {{0, -4, 3}}, {{0, 0.1, 0}, {0, 0.2, 0}, {0, 0.3, 0}}});
    const float* const rows = anchors.rows();
    const auto is = [&](int joint, double x, double y, double z, double radius) {
      bool ok = true;
      for (const auto& [row, number] : {std::pair(0, x), {1, y}, {2, z}, {3, radius}})
        ok = ok && std::abs(rows[row * anchors.stride + joint] - number) < 1e-6;
      return ok;
    };
    bool ok = is(0, 2, 0, 0, 1) && is(2, 0, -4, 3, 0) && is(3, 0, 0.2, 0, 0.1);
    // Its points are within the radius of the anchor that float has.
    ok = ok && double{rows[3 * anchors.stride + 3]} >= 0.3 - double{rows[anchors.stride + 3]};
    for (int joint = 0; joint < anchors.stride; ++joint)
      ok = ok && (rows[3 * anchors.stride + joint] < 0) == (joint == 1 || joint > 3);
    return Checked(ok && anchors.joint_count == 4 && anchors.stride == 32 && anchors.farthest == 5, 4);
  });
  t.example("a joint without vertices goes where it likes", {}, [] {
    SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    for (const char* name : {"first", "last"}) mesh.joints.push_back({name, -1, {0, 0, 0}});
    const JointSets sets(mesh);
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(mesh, sets, skinning);
      PoseChange change(motion_bound);
      Pose pose = reference_pose(mesh);
      motion_bound.box(pose, {});
      change.start(motion_bound, pose, {});
      const double still = change.box(pose, {})->extent();
      pose[pose.size() - 2] = {{0, 1, 0, 0}, {3, 4, 5}};
      ok = ok && std::abs(change.box(pose, {})->extent() - still) < 1e-1 && change.box(pose, {})->extent() >= still;
    }
    return Checked(ok, 4);
  });
}

void poses_without_a_box(Suite& t) {
  t.example("a pose that is not surely rigid, of the wrong length, or with what is not finite has no box, and nothing is lost",
            {}, [] {
              const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
              const JointSets sets(mesh);
              long wrong = 0, tried = 0;
              for (const Skinning skinning : gen::all_skinnings) {
                MotionBound motion_bound(mesh, sets, skinning);
                PoseChange change(motion_bound);
                const Pose good = reference_pose(mesh);
                ++tried, wrong += change.box(good, {}).has_value();  // nothing is kept yet
                motion_bound.box(good, {});
                change.start(motion_bound, good, {});
                for (const Target target : available_targets()) {
                  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 1e200, 1e30})
                    for (std::size_t joint = 0; joint < good.size(); ++joint)
                      for (int i = 0; i < 7; ++i) {
                        Pose pose = good;
                        (i < 4 ? pose[joint].rotation[i] : pose[joint].translation[i - 4]) = bad;
                        ++tried, wrong += change.box(pose, {}, target).has_value();
                      }
                  for (const double off : {0.0, 1e-7, -1e-7, 1e-6, -1e-6, 1e-5, -0.1, -1.0})
                    for (std::size_t joint = 0; joint < good.size(); ++joint) {
                      Pose pose = good;
                      pose[joint].rotation *= std::sqrt(1 + off);
                      ++tried, wrong += change.box(pose, {}, target).has_value() != (std::abs(off) < 5e-7);
                    }
                  for (const std::size_t count : {std::size_t(0), good.size() - 1, good.size() + 1})
                    ++tried, wrong += change.box(Pose(count), {}, target).has_value();
                  ++tried, wrong += !change.box(good, {}, target).has_value();
                }
              }
              return Checked(wrong == 0, tried);
            });
  t.example("nothing is kept of a pose without a bound, and no box is made from one with rotations too far apart", {}, [] {
    const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 12, 8, 4, 7});
    const JointSets sets(mesh);
    Pose apart = reference_pose(mesh), infinitely_far = apart, stretched = apart;
    stretched[1].rotation *= 1.1;
    apart[1].rotation = {0.5, std::sqrt(0.75), 0, 0};
    apart[2].rotation = {0.5, -std::sqrt(0.75), 0, 0};
    infinitely_far[0].translation[0] = infinite;
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(mesh, sets, skinning);
      PoseChange change(motion_bound);
      const auto keeps = [&](const Pose& pose) {
        motion_bound.box(pose, {});
        change.start(motion_bound, pose, {});
        return change.box(reference_pose(mesh), {}).has_value();
      };
      const bool deviates = motion_bound.deviates();
      ok = ok && keeps(reference_pose(mesh)) && !keeps(infinitely_far) && !keeps(stretched) && keeps(apart) == !deviates;
      // A bound that has only placed the joints knows no box.
      motion_bound.box(reference_pose(mesh), {});
      ok = ok && motion_bound.posed() && motion_bound.place_checked(reference_pose(mesh), {}) && !motion_bound.posed();
    }
    return Checked(ok, 20);
  });
  t.example("a pose that was given up after its first box is not followed by another one at once", {}, [] {
    const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    const JointSets sets(mesh);
    MotionBound motion_bound(mesh, sets, Skinning::spherical);
    PoseChange change(motion_bound);
    const Pose pose = reference_pose(mesh);
    motion_bound.box(pose, {});
    // Returns after how many starts there is a box again.
    const auto starts = [&] {
      int count = 0;
      do ++count, change.start(motion_bound, pose, {});
      while (count < 100 && !change.box(pose, {}));
      return count;
    };
    bool ok = starts() == 1;
    change.give_up();
    ok = ok && !change.box(pose, {}) && starts() == 9;
    ok = ok && change.box(pose, {}) && change.box(pose, {});
    change.give_up();
    return Checked(ok && !change.box(pose, {}) && starts() == 1, 3);
  });
}

void bodies_that_come_nearer(Suite& t) {
  t.holds(
      "bodies that come nearer from far away, and part again, touch where all pairs of triangles say, with coarse bounds",
      {.number_type = "double", .cases = 60, .tags_at_least = {{"coarse", 0.8}, {"coarse in vain", 0.5}, {"in contact", 0.5}}},
      [] {
        const auto plan = gen::classified_plan();
        const auto c = bake(gen::make_mesh(plan));
        const ClusterTree tree(c, {.most_triangles = 10, .most_children = 9});
        std::mt19937 random(plan.seed);
        const Skinning skinning = *rc::gen::element(Skinning::spherical, Skinning::linear, Skinning::hejl);
        ClusterBody a(tree, skinning), b(tree, skinning);
        PairMemory memory;
        Pose pose_a = gen::random_pose(c.mesh, random, 0.05), pose_b = gen::random_pose(c.mesh, random, 0.05);
        constexpr int frames = 40;
        for (int frame = 0; frame < frames; ++frame) {
          pose_a = changed(pose_a, 0.002, random), pose_b = changed(pose_b, 0.002, random);
          const double apart = 0.02 * (frame - frames / 2) * (frame - frames / 2);
          const RigidTransform<double> at{{0, 0.6, 0, 0.8}, {apart, 0, 0}};
          a.begin(pose_a, {}), b.begin(pose_b, at);
          const auto of_a = oracle::placed_vertices(c.mesh, c.sets, pose_a, skinning),
                     of_b = oracle::placed_vertices(c.mesh, c.sets, pose_b, skinning, at);
          const bool is_coarse = b.is_coarse_bound_made();
          if (is_coarse) RC_TAG("coarse");
          RC_ASSERT(oracle::holds(a.coarse_bound(), of_a) && oracle::holds(b.coarse_bound(), of_b));
          QueryCounts counts;
          const auto found = collide(a, b, Query::full, counts, random() % 8 ? &memory : nullptr);
          RC_ASSERT(oracle::sorted(found) == oracle::all_pairs(c.mesh.triangles, of_a, c.mesh.triangles, of_b));
          if (!found.empty()) RC_TAG("in contact");
          if (is_coarse && !b.is_coarse_bound_made()) RC_TAG("coarse in vain");
          RC_ASSERT(oracle::holds(a.motion_bound(), of_a) && oracle::holds(b.motion_bound(), of_b) && !b.is_coarse_bound_made());
        }
      });
  t.example("bodies that stay far from each other make a motion bound now and then, and a coarse one in all other frames", {},
            [] {
              const auto man = bake_animated(make_man());
              const ClusterTree tree(man);
              ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical);
              int coarse = 0;
              constexpr int frames = 200;
              for (int frame = 0; frame < frames; ++frame) {
                const Pose pose = man.clips[0].sample(frame % 100 / 100.0 * man.clips[0].duration);
                a.begin(pose, {}), b.begin(pose, {identity_quaternion<double>(), {0.01 * frame, 0, 4}});
                QueryCounts counts;
                if (!collide(a, b, Query::full, counts).empty() || counts.ball_tests != 1 || a.nodes_bounded() > 0)
                  return Checked(false, frame, "frame " + std::to_string(frame));
                coarse += a.is_coarse_bound_made();
              }
              return Checked(coarse > frames * 8 / 10 && coarse < frames, frames, std::to_string(coarse) + " coarse");
            });
}

void frames_without_a_coarse_bound(Suite& t) {
  t.example("a frame of affine joints, one with a deformation, and one that is refused have no coarse bound of rigid joints", {},
            [] {
              const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1}));
              const ClusterTree tree(c);
              const Pose still = reference_pose(c.mesh);
              const std::size_t joints = still.size();
              // All joints move, which is far for the bound of a pose where none did.
              const AffinePose moved(joints, AffineMap<double>{identity_map<double>().columns, Point3(0, 0, 50)}),
                  stretched(joints, AffineMap<double>{{Point3(2, 0, 0), Point3(0, 2, 0), Point3(0, 0, 2)}, Point3::Zero()});
              bool ok = true;
              for (const Skinning skinning : gen::all_skinnings) {
                ClusterBody body(tree, skinning);
                const auto begin_coarse = [&] {
                  for (int frame = 0; frame < 2; ++frame) body.begin(still, {});
                  return body.is_coarse_bound_made();
                };
                const auto holds_all = [&](double factor, double z) {
                  for (const Point3& v : c.mesh.vertices)
                    if (!oracle::holds(body.coarse_bound(), Point3(v * factor + Point3(0, 0, z)))) return false;
                  return true;
                };
                ok = ok && begin_coarse() && holds_all(1, 0);
                body.begin(moved, {});
                ok = ok && !body.is_coarse_bound_made() && holds_all(1, 50) && begin_coarse();
                body.begin(still, {}, Deformation{{}, stretched});
                ok = ok && !body.is_coarse_bound_made() && holds_all(2, 0) && begin_coarse();
                Pose wrong = still;
                wrong[0].translation[2] = infinite;
                ok = ok && gen::refuses<ModelError>([&] { body.begin(wrong, {}); }) && body.is_coarse_bound_made() &&
                     holds_all(1, 0) && oracle::holds(body.motion_bound(), c.mesh.vertices);
              }
              return Checked(ok, 16);
            });
}

void bodies_that_were_near(Suite& t) {
  t.example("what is expected of a body is of its next frame alone", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1}));
    const ClusterTree tree(c);
    const Pose still = reference_pose(c.mesh);
    bool ok = true;
    for (const auto need : {ClusterBody::Need::nodes, ClusterBody::Need::skin}) {
      ClusterBody body(tree, Skinning::spherical);
      const auto is_coarse_in_next = [&] {
        body.begin(still, {});
        return body.is_coarse_bound_made();
      };
      ok = ok && !is_coarse_in_next() && is_coarse_in_next();
      body.expect(need);
      ok = ok && !is_coarse_in_next() && is_coarse_in_next();
    }
    return Checked(ok, 2);
  });
  t.example("bodies that a query with a memory found near have coarse bounds again where no such query asks", {}, [] {
    const auto c = bake(gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1}));
    const ClusterTree tree(c);
    const Pose still = reference_pose(c.mesh);
    const RigidTransform<double> far{identity_quaternion<double>(), {50, 0, 0}};
    bool ok = true;
    int tried = 0;
    for (const Query query : {Query::full, Query::yes_no})
      for (const bool in_crowd : {false, true}) {
        ClusterBody a(tree, Skinning::spherical), b(tree, Skinning::spherical);
        PairMemory memory;
        QueryCounts counts;
        for (int frame = 0; frame < 3; ++frame) {
          a.begin(still, {}), b.begin(still, {});
          collide(a, b, query, counts, &memory);
        }
        ok = ok && memory.are_near;
        for (int frame = 0; frame < 20; ++frame) {
          a.begin(still, {}), b.begin(still, far);
          CrowdCounts of_crowd;
          if (in_crowd) collide_all(std::array{&a, &b}, query, of_crowd);
          else collide(a, b, query, counts);
        }
        ok = ok && a.is_coarse_bound_made() && b.is_coarse_bound_made(), ++tried;
      }
    return Checked(ok, tried);
  });
}

PROPTEST(pose_change) {
  boxes_hold_the_vertices_of_later_poses(t);
  how_much_larger(t);
  boxes_grow_as_the_lemma_says(t);
  what_joints_carry(t);
  anchors_of_joints(t);
  poses_without_a_box(t);
  bodies_that_come_nearer(t);
  frames_without_a_coarse_bound(t);
  bodies_that_were_near(t);
}

}  // namespace
}  // namespace proptests::suite_pose_change
