// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/motion_bound.hpp"

#include <array>
#include <random>

#include "experiments/procedural/procedural.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/placed_vertices.hpp"

namespace proptests::suite_motion_bound {
namespace {

using namespace refitlab;

Box<double> box_of_vertices(const SkinnedMesh& model, const JointSets& sets, const Pose& pose, Skinning skinning,
                            const RigidTransform<double>& placement) {
  auto box = Box<double>::empty();
  for (const Point3& p : oracle::placed_vertices(model, sets, pose, skinning, placement)) box.merge(p);
  return box;
}

// Says whether a box encloses another. A box with a NaN encloses nothing here.
bool encloses(const Box<double>& outer, const Box<double>& inner) {
  for (int i = 0; i < 3; ++i)
    if (!(outer.low[i] <= inner.low[i] && outer.high[i] >= inner.high[i])) return false;
  return true;
}

bool is_everything(const Box<double>& box) {
  for (int i = 0; i < 3; ++i)
    if (box.low[i] != -infinite || box.high[i] != infinite) return false;
  return true;
}

// Puts the origins of some joints elsewhere, so that they are far from the vertices, each in another direction.
void put_joints_far_away(SkinnedMesh& model, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double far = std::array{0., 0., 10., 1e5, 1e8, 1e12}[random() % 6];
  for (Joint& joint : model.joints)
    if (random() % 3) joint.origin += Point3(normal(random), normal(random), normal(random)) * far;
}

void boxes_hold_their_vertices(Suite& t) {
  t.holds("the box holds all vertices, however joints are turned, near their origins or far away, in every skinning",
          {.number_type = "float", .cases = 600, .degenerate_at_least = 0.3}, [] {
            const auto plan = gen::classified_plan();
            SkinnedMesh model = gen::make_mesh(plan);
            std::mt19937 random(plan.seed);
            put_joints_far_away(model, random);
            const JointSets sets(model);
            const double spread = *rc::gen::element(0.0, 1e-5, 1e-3, 0.1, 0.5, 3.0);
            for (const Skinning skinning : gen::all_skinnings) {
              MotionBound motion_bound(model, sets, skinning);
              for (int frame = 0; frame < 4; ++frame) {
                Pose pose = gen::random_pose(model, random, spread);
                if (frame == 1) gen::spoil_lengths(pose, random);
                // All joints are turned together, so that relative rotations stay small.
                if (frame == 2)
                  for (auto& joint : pose) joint = compose(RigidTransform<double>{{0, 0.6, 0, 0.8}, {3, 4, 5}}, joint);
                const auto placement = gen::near_or_far_placement(random);
                const Box<double> box = motion_bound.box(pose, placement),
                                  of_vertices = box_of_vertices(model, sets, pose, skinning, placement);
                for (const Target target : available_targets())
                  RC_ASSERT(encloses(motion_bound.box(pose, placement, target), of_vertices));
                if (skinning != Skinning::dual_quaternion) RC_ASSERT(std::isfinite(box.extent()));
                if (frame == 0) RC_TAG(std::isfinite(box.extent()) ? "bounded" : "unbounded");
              }
            }
          });
  t.holds("joints that only turn, about points of their own: rotation centers far from all vertices",
          {.number_type = "float", .cases = 300}, [] {
            const auto plan = *gen::mesh_plan();
            const SkinnedMesh model = gen::make_mesh(plan);
            const JointSets sets(model);
            std::mt19937 random(plan.seed);
            std::normal_distribution<double> normal;
            const double spread = *rc::gen::element(1e-4, 1e-3, 1e-2, 0.3);
            const double far = *rc::gen::element(1.0, 30.0, 1000.0);
            Pose pose = gen::random_pose(model, random, spread);
            for (auto& joint : pose) {
              const Point3 pivot = Point3(normal(random), normal(random), normal(random)) * far;
              joint.translation = pivot - rotate(joint.rotation, pivot);
            }
            for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
              const RigidTransform<double> placement = gen::near_or_far_placement(random);
              RC_ASSERT(encloses(MotionBound(model, sets, skinning).box(pose, placement),
                                 box_of_vertices(model, sets, pose, skinning, placement)));
            }
          });
  t.holds(
      "the box holds vertices that are where a ball's bound is attained, of 1 to 90 joints, at every scale and place, "
      "however long quaternions are; and is wider by no more than what rounding is allowed",
      {.number_type = "float", .cases = 2000}, [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        const double unit = *rc::gen::element(1.0, 1.0, 1e-12, 1e-18, 1e-30, 1e-45, 1e-300, 1e9, 1e10),
                     far = *rc::gen::element(0.0, 1.0, 1e6, 1e30, 1e300);
        const gen::Attained scene = gen::attained(random, {.unit = unit, .far = far});
        const JointSets sets(scene.mesh);
        const Skinning skinning = gen::random_skinning(random);
        const int joints = static_cast<int>(scene.mesh.joints.size());
        MotionBound motion_bound(scene.mesh, sets, skinning);
        const Box<double> of_vertices = box_of_vertices(scene.mesh, sets, scene.pose, skinning, scene.placement);
        for (const Target target : available_targets()) {
          const Box<double> box = motion_bound.box(scene.pose, scene.placement, target);
          RC_LOG() << scene.what;
          RC_ASSERT(encloses(box, of_vertices));
          RC_ASSERT(is_everything(box) == (skinning == Skinning::dual_quaternion && joints > most_motion_bound_joints));
          if (is_everything(box)) continue;
          const double most = 2 * unit * 1.9 + 4 * lost_of_motion_bound * joints * scene.size + 1e-17 +
                              1e-13 * upper_norm(scene.placement.translation);
          for (int i = 0; i < 3; ++i) RC_ASSERT(box.edges()[i] <= std::max(of_vertices.edges()[i], most));
        }
      });
}

void swept_vertices_rigid_poses_and_many_joints(Suite& t) {
  t.example("a vertex swept about an axis bulges out of its joints' chord, and stays in the box", {}, [] {
    SkinnedMesh model;
    model.name = "swept";
    model.vertices.assign(3, {1, 0, 0});
    model.triangles = {{0, 1, 2}};
    model.joints = {{"first", -1, {0, 0, 0}}, {"second", 0, {0, 0, 0}}};
    model.influences.assign(3, {{0, 0.5}, {1, 0.5}});
    const JointSets sets(model);
    bool ok = true;
    double least = infinite;
    // Each joint turns by this angle in radians, alternately to either side.
    for (const double half : {0.2, 0.6, 1.0}) {
      const Pose pose{{{std::cos(half / 2), 0, 0, std::sin(half / 2)}, {0, 0, 0}},
                      {{std::cos(half / 2), 0, 0, -std::sin(half / 2)}, {0, 0, 0}}};
      for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
        const Box<double> box = MotionBound(model, sets, skinning).box(pose, {});
        ok = ok && encloses(box, box_of_vertices(model, sets, pose, skinning, {})) && box.high[0] < 1.6;
        least = std::min(least, (box.high[0] - std::cos(half)) / (1 - std::cos(half)));
      }
    }
    return Checked(ok && least > 1, 6, "blown up by at least " + std::to_string(least) + " times the bulge");
  });
  t.example("a pose counts as rigid by itself only where check_pose has nothing against it", {}, [] {
    const SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    const JointSets sets(model);
    MotionBound motion_bound(model, sets, Skinning::spherical);
    long wrong = 0, tried = 0;
    for (const double off : {0.0, 1e-7, -1e-7, 1e-6, -1e-6, 1.01e-6, -1.01e-6, 1e-5, -1e-5, 0.1, -0.1, -1.0})
      for (std::size_t joint = 0; joint < model.joints.size(); ++joint)
        for (const Target target : available_targets()) {
          Pose pose = reference_pose(model);
          pose[joint].rotation *= std::sqrt(1 + off);
          bool is_rigid = false;
          const Box<double> box = motion_bound.box(pose, {}, is_rigid, target);
          ++tried;
          if (is_rigid != (std::abs(off) < 5e-7)) ++wrong;
          if (is_everything(box) != (std::abs(off) > 2e-6)) ++wrong;
        }
    return Checked(wrong == 0, tried);
  });
  t.example("vertices whose squares float does not hold reach everywhere", {}, [] {
    SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    for (Point3& v : model.vertices) v *= 1e25;
    const JointSets sets(model);
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings)
      ok = ok && is_everything(MotionBound(model, sets, skinning).box(reference_pose(model), {}));
    return Checked(ok, 4);
  });
  t.example("more joints than a table of the widest pack holds, each where it belongs", {}, [] {
    const Model creature = make_creature();  // It has 56 joints.
    const JointSets sets(creature);
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(creature, sets, skinning);
      for (std::size_t joint = 0; joint < creature.joints.size(); ++joint) {
        Pose pose = reference_pose(creature);
        pose[joint].translation += Point3(0.3, 0.2, 0.1);
        const Box<double> of_vertices = box_of_vertices(creature, sets, pose, skinning, {});
        for (const Target target : available_targets()) {
          const Box<double> box = motion_bound.box(pose, {}, target);
          ok = ok && encloses(box, of_vertices) && box.extent() < 1.5 * of_vertices.extent();
        }
      }
    }
    return Checked(ok, 4 * 56);
  });
}

void boxes_of_a_walking_man(Suite& t) {
  t.example("a walking man's box is little larger than that of his vertices, in every skinning", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    bool ok = true;
    std::string text = "sum of widths over that of the vertices' box: ";
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(man, sets, skinning);
      double bounded = 0, exact = 0;
      for (int i = 0; i < 20; ++i) {
        const Pose pose = man.clips[0].sample(i / 20.0 * man.clips[0].duration);
        const Box<double> box = motion_bound.box(pose, {}), of_vertices = box_of_vertices(man, sets, pose, skinning, {});
        ok = ok && encloses(box, of_vertices);
        bounded += box.extent(), exact += of_vertices.extent();
      }
      ok = ok && bounded < (skinning == Skinning::hejl ? 1.21 : 1.16) * exact;
      text += (skinning == gen::all_skinnings[0] ? "" : ", ") + std::to_string(bounded / exact);
    }
    return Checked(ok, 80, text);
  });
  t.example("turned by a placement, the box is as tight: points are turned, not boxes", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    const Pose pose = man.clips[0].sample(0);
    const RigidTransform<double> placement{{std::cos(0.4), 0, std::sin(0.4), 0}, {10, 0, -20}};
    const Box<double> box = MotionBound(man, sets, Skinning::spherical).box(pose, placement),
                      of_vertices = box_of_vertices(man, sets, pose, Skinning::spherical, placement);
    return Checked(encloses(box, of_vertices) && box.extent() < 1.3 * of_vertices.extent(), 1,
                   std::to_string(box.extent() / of_vertices.extent()));
  });
  t.example("a quaternion and its opposite are one rotation: the box is the same", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    const Pose pose = man.clips[0].sample(0.3 * man.clips[0].duration);
    Pose negated = pose;
    for (std::size_t j = 0; j < negated.size(); j += 2) negated[j].rotation = -negated[j].rotation;
    bool ok = true;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(man, sets, skinning);
      const Box<double> box = motion_bound.box(pose, {}), again = motion_bound.box(negated, {});
      ok = ok && (box.low - again.low).norm() < 1e-4 && (box.high - again.high).norm() < 1e-4;
    }
    return Checked(ok, 4);
  });
}

void boxes_without_end(Suite& t) {
  t.example("dual quaternions half a turn apart have no box, and rotation centers help out in spherical skinning", {}, [] {
    SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 12, 8, 4, 7});
    const JointSets sets(model);
    Pose pose = reference_pose(model);
    pose[1].rotation = {0.5, std::sqrt(0.75), 0, 0};
    pose[2].rotation = {0.5, -std::sqrt(0.75), 0, 0};
    const Box<double> dual = MotionBound(model, sets, Skinning::dual_quaternion).box(pose, {}),
                      spherical = MotionBound(model, sets, Skinning::spherical).box(pose, {});
    return Checked(is_everything(dual) && std::isfinite(spherical.extent()) &&
                   encloses(spherical, box_of_vertices(model, sets, pose, Skinning::spherical, {})));
  });
  t.example("a body far from the world's origin is in its box for all that the sum loses",
            {.number_type = "double against rational"}, [] {
              const SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
              const JointSets sets(model);
              const MotionBound bound(model, sets, Skinning::linear);
              const AffinePose still(model.joints.size(), identity_map<double>());
              bool good = true;
              for (int i = 1; i <= 200; ++i) {
                const Point3 at(1e8 + i / 7.0, -1e8 - i / 9.0, i * 1e7 / 3);
                const Box<double> box = bound.box(still, {{1, 0, 0, 0}, at});
                for (const Point3& v : model.vertices)
                  for (int k = 0; k < 3; ++k) {
                    const Rational x = Rational(v[k]) + Rational(at[k]);
                    good = good && Rational(box.low[k]) <= x && x <= Rational(box.high[k]);
                  }
              }
              return Checked(good, 200);
            });
  t.example("what is not finite, or overflows, reaches everywhere", {}, [] {
    const SkinnedMesh model = gen::make_mesh({gen::MeshKind::tube, 6, 5, 3, 1});
    const JointSets sets(model);
    long wrong = 0, tried = 0;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound motion_bound(model, sets, skinning);
      for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 1e200, 1e30})
        for (int joint = 0; joint < 3; ++joint)
          for (int i = 0; i < 7; ++i) {
            Pose pose = reference_pose(model);
            (i < 4 ? pose[joint].rotation[i] : pose[joint].translation[i - 4]) = bad;
            ++tried, wrong += !is_everything(motion_bound.box(pose, {}));
          }
    }
    return Checked(wrong == 0, tried);
  });
}

void poses_of_the_wrong_length(Suite& t) {
  t.example("a pose of more or fewer transforms than joints is refused, and the bound is as before", {}, [] {
    const Model man = make_man();
    const JointSets sets(man);
    const Pose pose = reference_pose(man);
    long tried = 0;
    for (const Skinning skinning : gen::all_skinnings) {
      MotionBound bound(man, sets, skinning);
      const Box<double> before = bound.box(pose, {});
      for (const std::size_t count : {std::size_t(0), std::size_t(1), pose.size() - 1, pose.size() + 1, 2 * pose.size()}) {
        Pose wrong = pose;
        wrong.resize(count, pose[0]);
        if (!gen::refuses<ModelError>([&] { bound.box(wrong, {}); }) ||
            !gen::refuses<ModelError>([&] { bound.box(AffinePose(count), {}); }))
          return Checked(false, tried, std::to_string(count) + " transforms");
        tried += 2;
      }
      const Box<double> after = bound.box(pose, {});
      if (after.low != before.low || after.high != before.high) return Checked(false, tried, "another box");
    }
    return Checked(true, tried);
  });
}

}  // namespace

PROPTEST(motion_bound) {
  poses_of_the_wrong_length(t);
  boxes_hold_their_vertices(t);
  swept_vertices_rigid_poses_and_many_joints(t);
  boxes_of_a_walking_man(t);
  boxes_without_end(t);
}

}  // namespace proptests::suite_motion_bound
