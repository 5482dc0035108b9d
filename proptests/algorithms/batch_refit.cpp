// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/batch/batch_refit.hpp"

#include <algorithm>
#include <random>

#include "algorithms/bake/build_tree.hpp"
#include "algorithms/runtime/batch/single_precision.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/refit/algorithm1_repaired.hpp"
#include "algorithms/runtime/refit/refit_linear.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/opposite_joints.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/gen/wide_models.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_batch_refit {
namespace {

using namespace refitlab;

// Returns a random pose. The squared lengths of some quaternions have the defect, the others none.
Pose random_pose(const SkinnedMesh& model, unsigned seed, double calm, double defect) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Pose pose = reference_pose(model);
  for (auto& t : pose) {
    t.rotation = {calm + normal(random), normal(random), normal(random), normal(random)};
    t.rotation = gen::of_defect(t.rotation.normalized(), random() % 2 ? defect : 0);
    t.translation = {normal(random), normal(random), normal(random)};
  }
  return pose;
}

// Says whether rounding in float may decide if the cap of the rotations' images, about the mean of these unit vectors, is a
// half-sphere, or whether their sum nearly vanishes.
bool is_near_a_right_angle(const std::vector<Quaternion<double>>& unit) {
  Quaternion<double> sum = Quaternion<double>::Zero();
  for (const auto& q : unit) sum += q;
  double far = 0;
  for (const auto& q : unit) far = std::max(far, squared_distance<double, 4>(q, sum.normalized()) / 4);
  return !(std::abs(8 * far * (1 - far) - 1) > 1e-3) || !(sum.norm() > 1e-3);
}

// Returns the triangle whose vertices are all moved by two joints alike.
SkinnedMesh triangle_between_two_joints() {
  SkinnedMesh model;
  model.name = "a triangle between two joints";
  model.joints = {{"a", -1, Point3::Zero()}, {"b", 0, Point3::UnitX()}};
  model.vertices = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
  model.triangles = {{0, 1, 2}};
  model.influences.assign(3, {{0, 0.5}, {1, 0.5}});
  return model;
}

// Decides exactly, after a quick test, since most vertices are far from the surface.
bool exact_encloses(const Ball3<double>& ball, const Point3& v) {
  if (norm<double, 3>(v - ball.center) * (1 + 1e-14) + 1e-150 < ball.radius) return true;
  return !std::isfinite(ball.radius) ||
         encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, convert<Rational>(v)) == Verdict::holds;
}

// Says whether the bound of the node is certainly all rotations. Near a right angle, and near a half-sphere of quaternions, float
// may decide otherwise.
bool is_any_rotation(const RefitNode<double>& node, const NodePiece& set) {
  std::vector<Quaternion<double>> unit;
  return set.weight_vertex_count > 1 && bound_joint_set_rotations<MeanBalls>(node, set, unit).center_ratio == 0 &&
         !is_near_a_right_angle(unit);
}

// Returns what rounding may do to a node's ball, by the formulas of refit_kernel.hpp.
double slack_of(const SphereTree& tree, const RefitNode<double>& node, Skinning skinning) {
  constexpr double epsilon = std::numeric_limits<float>::epsilon();
  double slack = 0, largest = 0;
  for (const TreeNode& n : tree.nodes) largest = std::max(largest, n.reference.center.norm());
  for (const NodePiece& set : node.pieces) {
    const PaletteEntry<double> palette = node.palette[set.joint_set];
    const auto n = static_cast<double>(palette.transforms.size());
    double size = 0, shortest = 1, defect = 0;
    for (const auto& t : palette.transforms) {
      size = std::max(size, t.translation.norm());
      defect = std::max(defect, std::abs(squared_norm(t.rotation) - 1));
    }
    if (skinning == Skinning::linear) {
      slack = std::max(slack, epsilon * (8 + n) * (size + largest) + 2 * (defect + 0x1p-48) * node.reference.radius);
      continue;
    }
    size = 0;
    for (const auto& image : palette.center_images) size = std::max(size, image.norm());
    // No vertex would be outside of such a ball.
    if (!is_any_rotation(node, set))
      for (int k = 0; k < set.weight_vertex_count; ++k)
        shortest = std::min(shortest, norm(blend_quaternion<double>(palette, node.weight_vertex(set, k))));
    const double x = (node.reference.center - palette.rotation_center).lpNorm<1>();
    slack = std::max(slack, epsilon * (66 + 2 * n) * (x / shortest + size + 2 * palette.rotation_center.norm()));
  }
  return 1.01 * slack;
}

// Returns what is wrong unless the balls of a model, which may be at any end of what is accepted, hold all vertices, skinned
// exactly and in double. The comparison is exact.
std::string what_is_missed(const gen::WideModel& wide) {
  const SkinnedMesh& model = wide.mesh;
  const JointSets sets(model);
  const SphereTree tree = build_sphere_tree(model, sets, {.triangles_per_leaf = wide.triangles_per_leaf});
  const NodeVertices vertices(tree, model);
  for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::hejl}) {
    const auto palette = make_skinning_palette(model, sets, wide.pose, skinning);
    const auto deformed = skin(model, sets, palette, skinning);
    double largest = wide.largest_length;  // Rotation centers of nearly parallel joints are far away.
    for (int s = 0; s < sets.count(); ++s) {
      largest = std::max(largest, palette[s].rotation_center.stableNorm());
      for (const Point3& image : palette[s].center_images) largest = std::max(largest, image.stableNorm());
    }
    ExactSkin exact(model, sets, palette, skinning);
    const auto complaint = [&](const std::string& how, auto&& ball_of) -> std::string {
      for (int n = 0; n < static_cast<int>(tree.nodes.size()); ++n) {
        const Ball3<float> of_floats = ball_of(n);
        const Ball3<double> ball{of_floats.center.cast<double>(), of_floats.radius};
        const std::string which = "node " + std::to_string(n) + " of skinning " + std::to_string(int(skinning)) + " by " + how;
        if (!ball.center.allFinite() || !(ball.radius >= 0)) return which + " is not a ball";
        if (largest < 0x1p40 && !std::isfinite(ball.radius)) return which + " is all of space";
        for (const int v : vertices[n])
          if (!exact.is_in(ball, v) || !exact_encloses(ball, deformed[v])) return which + " misses vertex " + std::to_string(v);
      }
      return "";
    };
    try {
      BatchRefit batch(tree, sets);
      for (const Target target : available_targets()) {
        const PackedBalls& balls =
            skinning == Skinning::linear ? batch.linear(palette, target) : batch.spherical(palette, target);
        if (const auto wrong = complaint(name_of(target), [&](int n) { return balls[n]; }); !wrong.empty()) return wrong;
      }
    } catch (const std::range_error& e) {  // This is thrown only for lengths that are too large.
      if (largest < 0x1p54) return e.what();
    }
  }
  return "";
}

// Makes a mesh and a pose in which one joint turns the opposite way to the rest. Of the weight vertices many are on one side and
// few on the other, so that these few are on the far side of the sphere from the mean.
std::pair<SkinnedMesh, Pose> lopsided(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  SkinnedMesh model;
  model.name = "lopsided";
  for (int j = 0; j < 4; ++j) model.joints.push_back({"joint " + std::to_string(j), j - 1, Point3(uniform(random), 0, 0)});
  for (int v = 0; v < 9; ++v) {
    model.vertices.push_back({uniform(random), uniform(random), uniform(random)});
    const double first = 0.01 + 0.05 * uniform(random), other = v == 0 ? 0.5 + 0.3 * uniform(random) : 0.01,
                 share = 0.02 + 0.9 * uniform(random);
    const double rest = 1 - first - other;
    model.influences.emplace_back();
    for (const auto& [joint, w] : quantize_weights({{0, first}, {1, share * rest}, {2, other}, {3, (1 - share) * rest}}))
      model.influences.back().push_back({joint, w});
    if (v % 3 == 2) model.triangles.push_back({v - 2, v - 1, v});
  }
  Pose pose = reference_pose(model);
  const double near = 0.1 * uniform(random);
  for (int j = 1; j < 4; ++j)
    pose[j].rotation = Quaternion<double>(near, j == 2 ? -1 : 1, 0, 0.05 * uniform(random)).normalized();
  return {std::move(model), std::move(pose)};
}

// Makes an octahedron about the origin, all of whose vertices are at the distance of its ball's radius. Its joints turn it alike,
// by a half-turn about an axis, and move its parts a little way to both sides, so that the bound is the least ball.
gen::WideModel where_the_bound_is_attained(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.98, 1.02);
  const int joints = 1 + static_cast<int>(random() % 3), axis = static_cast<int>(random() % 3);
  const double r = uniform(random), way = std::ldexp(uniform(random), -static_cast<int>(random() % 12) - 1);
  // If they are shared, they make a joint-set whose joints may have different lengths.
  const bool are_shared = joints > 1 && random() % 2;
  constexpr double little = 0x1p-12;
  gen::WideModel out;
  out.mesh.name = "octahedron";
  for (int j = 0; j < joints; ++j) out.mesh.joints.push_back({"joint " + std::to_string(j), j - 1, Point3::Zero()});
  for (int i = 0; i < 3; ++i)
    for (const int side : {1, -1}) {
      out.mesh.vertices.push_back(Point3::Unit(i) * (side * r));
      // The turned vertex moves on outwards.
      const bool is_last = i == axis && side == 1;
      if (are_shared)
        out.mesh.influences.push_back({{0, is_last ? little : 1 - little}, {joints - 1, is_last ? 1 - little : little}});
      else out.mesh.influences.push_back({{is_last ? joints - 1 : 0, 1}});
    }
  out.mesh.triangles = {{0, 2, 4}, {1, 3, 5}};
  out.triangles_per_leaf = 1 + static_cast<int>(random() % 2);
  const int about = (axis + 1) % 3;
  const double defects[] = {0, 1e-7, 1e-6, -1e-6};
  for (int j = 0; j < joints; ++j)
    out.pose.push_back(
        {gen::of_defect(Quaternion<double>::Unit(1 + about), defects[random() % 4]), Point3::Unit(axis) * (j == 0 ? way : -way)});
  out.largest_length = 2;
  out.what = std::to_string(joints) + " joints, r " + std::to_string(r);
  return out;
}

// Says whether a node has one joint-set whose rotations are not all rotations.
bool is_bounded(const RefitNode<double>& node) {
  std::vector<Quaternion<double>> scratch;
  return node.pieces.size() == 1 && bound_joint_set_rotations<MeanBalls>(node, node.pieces[0], scratch).center_ratio > 0;
}

// Returns what is wrong, or nothing.
std::string what_is_wrong(const SkinnedMesh& model, const Pose& pose, Skinning skinning) {
  const JointSets sets(model);
  const SphereTree tree = build_sphere_tree(model, sets);
  const NodeVertices vertices(tree, model);
  const auto palette = make_skinning_palette(model, sets, pose, skinning);
  const auto deformed = skin(model, sets, palette, skinning);
  BatchRefit batch(tree, sets);
  RefitLists<double> lists;
  ControlLists<double> control_lists;
  std::vector<std::pair<std::string, std::vector<Ball3<float>>>> all;
  for (const Target target : available_targets()) {
    const PackedBalls& balls = skinning == Skinning::linear ? batch.linear(palette, target) : batch.spherical(palette, target);
    all.push_back({name_of(target), {}});
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) all.back().second.push_back(balls[static_cast<int>(n)]);
  }
  for (const auto& [how, balls] : all) {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const int n = static_cast<int>(i);
      const auto node = tree.refit_node(n, palette);
      const Ball3<double> expected = skinning == Skinning::linear ? refit_linear<MeanBalls>(node, control_lists)
                                                                  : refit_algorithm1_repaired<MeanBalls>(node, lists);
      const Point3 center = balls[n].center.cast<double>();
      const double radius = balls[n].radius, slack = slack_of(tree, node, skinning), off = (center - expected.center).norm();
      const std::string which = "node " + std::to_string(n) + " by " + how;
      int weight_vertices = 0;
      for (const NodePiece& set : node.pieces) weight_vertices += set.weight_vertex_count;
      // The center is a mean of many terms, which may be off by more. So a ball is measured from the center that was computed.
      if (!(off <= slack * (1 + weight_vertices / 64.)))
        return which + ": center off by " + std::to_string(off / slack) + " slacks";
      if (!(radius >= expected.radius - off)) return which + ": smaller than in double";
      const bool one_set = node.pieces.size() == 1, is_sized = skinning == Skinning::linear || is_bounded(node);
      if (one_set && (is_sized || is_any_rotation(node, node.pieces[0])) && !(radius >= expected.radius - off + 0.8 * slack))
        return which + ": without the slack, " + std::to_string((radius - expected.radius) / slack) + " of it";
      if (!(radius <= (expected.radius + off + 2 * slack) * (1 + 2e-6))) return which + ": larger than the slack allows";
      for (const int v : vertices[n])
        if (!((deformed[v] - center).norm() <= radius)) return which + ": misses vertex " + std::to_string(v);
    }
  }
  return "";
}

void the_slack_holds_what_floats_lose(Suite& t) {
  for (const Skinning skinning : {Skinning::spherical, Skinning::linear}) {
    const std::string name = skinning == Skinning::linear ? "linear" : "spherical";
    t.holds("by every target, each ball is the scalar one up to the stated slack, and misses no vertex: " + name,
            {.number_type = "float pack", .cases = 60, .degenerate_at_least = 0.3}, [skinning] {
              const auto plan = gen::classified_plan();
              const SkinnedMesh model = gen::make_mesh(plan);
              const double defect = *rc::gen::element(0., 1e-7, 1e-6, -1e-6);
              const auto pose = random_pose(model, plan.seed, *rc::gen::element(0., 1., 5.), defect);
              RC_ASSERT(what_is_wrong(model, pose, skinning) == "");
            });
    t.example("the same of the built-in man and creature in mid-clip: " + name, {.number_type = "float pack"}, [skinning] {
      for (const Model& model : {make_man(), make_creature()}) {
        const Clip& clip = model.clips.back();
        const auto wrong = what_is_wrong(model, clip.sample(0.4 * clip.duration), skinning);
        if (!wrong.empty()) return Checked(false, 1, model.name + ": " + wrong);
      }
      return Checked(true, 2);
    });
  }
  t.example("of blends that nearly vanish the slack is as many times larger", {.number_type = "float pack"}, [] {
    const SkinnedMesh model = triangle_between_two_joints();
    for (const double half_angle : {1.0, 1.4, 1.5, 1.55, 1.57}) {
      Pose pose = reference_pose(model);
      pose[1] = {{std::cos(half_angle), 0, 0, std::sin(half_angle)}, {0.3, 0.2, 0.1}};
      const auto wrong = what_is_wrong(model, pose, Skinning::spherical);
      if (!wrong.empty()) return Checked(false, 1, std::to_string(half_angle) + ": " + wrong);
    }
    return Checked(true, 5);
  });
}

void hard_cases_miss_no_vertex(Suite& t) {
  t.example(
      "where a blend is zero, as that of a palette filled by hand may be, a ball holds the vertices in any rotation",
      {.number_type = "float pack"}, [] {
        const SkinnedMesh model = triangle_between_two_joints();
        const JointSets sets(model);
        const SphereTree tree = build_sphere_tree(model, sets);
        SkinningPalette<double> palette;
        const auto transforms = palette.append(2);
        transforms[0].rotation = {0.6, 0, 0.8, 0}, transforms[1].rotation = {-0.6, 0, -0.8, 0};
        const Point3 center(0.25, 0, 0.5), moved(2, -1, 3);
        for (auto& transform : transforms) transform.translation = moved - rotate<double>(transform.rotation, center);
        palette.complete(center);
        BatchRefit batch(tree, sets);
        for (const Target target : available_targets()) {
          const Ball3<float> ball = batch.spherical(palette, target)[0];
          for (const Point3& vertex : model.vertices)
            if (!((ball.center.cast<double>() - moved).norm() + (vertex - center).norm() <= ball.radius) || !(ball.radius < 10))
              return Checked(false, 1, name_of(target));
        }
        return Checked(true, 1);
      });
  t.holds("nor is a vertex missed where joints are turned nearly opposite ways, and a cap would be over a half-sphere",
          {.number_type = "float pack", .cases = 100, .tags_at_least = {{"beyond a right angle", 0.2}}}, [] {
            const gen::OppositeJoints soup = gen::opposite_joints(*rc::gen::arbitrary<unsigned>());
            RC_TAG(gen::label_of(soup));
            const auto wrong = what_is_wrong(soup.mesh, soup.pose, Skinning::spherical);
            if (!wrong.empty()) RC_FAIL(wrong);
          });
  t.holds("nor of what the interface accepts at its ends, be it skinned exactly: tiny, huge, of many joints, of lengths off 1",
          {.number_type = "float pack", .cases = 1500, .degenerate_at_least = 0.5}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const gen::WideModel wide = gen::wide_model(random);
            RC_CLASSIFY(wide.largest_length < 0x1p-126 || wide.largest_length > 0x1p50 || wide.mesh.joints.size() > 4,
                        "degenerate");
            RC_CLASSIFY(wide.mesh.joints.size() > 30);
            RC_CLASSIFY(wide.largest_length < 0x1p-126, "tiny");
            if (const auto wrong = what_is_missed(wide); !wrong.empty()) RC_FAIL(wrong + ": " + wide.what);
          });
  t.example("nor where the bound is attained: vertices on the edge of their ball, moved outwards by joints that turn them alike",
            {.number_type = "float pack"}, [] {
              std::mt19937 random(2006);
              constexpr long cases = 3000;
              for (long c = 0; c < cases; ++c) {
                const gen::WideModel wide = where_the_bound_is_attained(random);
                if (const auto wrong = what_is_missed(wide); !wrong.empty()) return Checked(false, c, wrong + ": " + wide.what);
              }
              return Checked(true, cases);
            });
  t.holds("nor where few weight vertices turn the other way than the rest", {.number_type = "float pack", .cases = 200}, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const auto [model, pose] = lopsided(random);
    if (const auto wrong = what_is_wrong(model, pose, Skinning::spherical); !wrong.empty()) RC_FAIL(wrong);
  });
}

void many_joints_and_great_lengths(Suite& t) {
  t.example("the slack grows with the number of joints, of which 90 turn alike", {.number_type = "float pack"}, [] {
    SkinnedMesh model;
    model.name = "a triangle of 90 joints";
    model.vertices = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    model.triangles = {{0, 1, 2}};
    std::vector<std::pair<int, double>> weights;
    for (int j = 0; j < 90; ++j) {
      model.joints.push_back({"joint " + std::to_string(j), j - 1, Point3(0.01 * j, 0, 0)});
      weights.emplace_back(j, 1);
    }
    model.influences.resize(3);
    for (auto& influences : model.influences)
      for (const auto& [joint, w] : quantize_weights(weights)) influences.push_back({joint, w});
    Pose pose = reference_pose(model);
    for (auto& t : pose) t.rotation = {0.6, 0.8, 0, 0};
    for (const Skinning skinning : {Skinning::spherical, Skinning::linear})
      if (const auto wrong = what_is_wrong(model, pose, skinning); !wrong.empty()) return Checked(false, 1, wrong);
    return Checked(true, 2);
  });
  t.example(
      "lengths are taken up to 2^58, by 0.1 % more or less for rounding, and refused beyond, be they of a node or of a joint", {},
      [] {
        long refused = 0, taken = 0;
        for (const double share : {0.998, 1.002})
          for (const bool moved : {true, false}) {
            const double length = share * largest_single_length;
            SkinnedMesh model;
            model.name = "a far triangle";
            model.joints = {{"a", -1, Point3::Zero()}};
            const Point3 p(moved ? 0 : length, 0, 0);
            model.vertices = {p, p + Point3::UnitY(), p + Point3::UnitZ()};
            model.triangles = {{0, 1, 2}};
            model.influences.assign(3, {{0, 1}});
            Pose pose = reference_pose(model);
            if (moved) pose[0].translation = {length, 0, 0};
            const JointSets sets(model);
            const SphereTree tree = build_sphere_tree(model, sets);
            for (const Skinning skinning : {Skinning::linear, Skinning::spherical}) try {
                const auto palette = make_skinning_palette(model, sets, pose, skinning);
                BatchRefit batch(tree, sets);
                const Ball3<float> ball = (skinning == Skinning::linear ? batch.linear(palette) : batch.spherical(palette))[0];
                if (!ball.center.allFinite() || !std::isfinite(ball.radius)) return Checked(false, taken, "not finite");
                taken += share < 1;
              } catch (const std::range_error&) {
                refused += share > 1;
              }
          }
        // This is the length itself, without a refit's rounding.
        if (checked_single(largest_single_length) != largest_single_length) return Checked(false, taken, "the greatest length");
        return Checked(taken == 4 && refused == 4, taken + refused);
      });
}

// Repeats the first weight vertex of all joint-sets of one or two joints. The hull is the same.
SphereTree with_repeated_weight_vertices(SphereTree tree, const JointSets& sets) {
  std::vector<double> weights;
  for (NodePiece& piece : tree.pieces) {
    const std::size_t joints = sets.joints(piece.joint_set).size();
    const auto from = tree.weight_vertices.begin() + piece.first_weight;
    const auto count = static_cast<std::ptrdiff_t>(joints) * piece.weight_vertex_count;
    piece.first_weight = static_cast<int>(weights.size());
    if (joints <= 2) weights.insert(weights.end(), from, from + static_cast<std::ptrdiff_t>(joints)), ++piece.weight_vertex_count;
    weights.insert(weights.end(), from, from + count);
  }
  tree.weight_vertices = std::move(weights);
  return tree;
}

void more_weight_vertices_than_joints(Suite& t) {
  t.example("one or two joints may have more weight vertices than joints: balls hold all vertices, by every target", {}, [] {
    Model man = make_man(400);
    const JointSets sets(man);
    const SphereTree tree = with_repeated_weight_vertices(build_sphere_tree(man, sets), sets);
    const NodeVertices vertices(tree, man);
    BatchRefit batch(tree, sets);
    long tried = 0, missed = 0;
    for (unsigned seed = 0; seed < 4; ++seed)
      for (const Skinning skinning : {Skinning::spherical, Skinning::linear}) {
        const Pose pose = random_pose(man, seed, 3, 0);
        const auto palette = make_skinning_palette(man, sets, pose, skinning);
        const auto deformed = skin(man, sets, palette, skinning);
        for (const Target target : available_targets()) {
          const PackedBalls& balls =
              skinning == Skinning::linear ? batch.linear(palette, target) : batch.spherical(palette, target);
          for (int n = 0; n < static_cast<int>(tree.nodes.size()); ++n)
            for (const int v : vertices[n]) {
              const Ball3<float> ball = balls[n];
              ++tried, missed += !(norm<double, 3>(deformed[v] - ball.center.cast<double>()) <= ball.radius);
            }
        }
      }
    return Checked(missed == 0, tried, std::to_string(missed) + " are outside");
  });
  t.example("a palette of affine joints is refitted linearly alone", {}, [] {
    const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
    const JointSets sets(mesh);
    const SphereTree tree = build_sphere_tree(mesh, sets);
    BatchRefit batch(tree, sets);
    const auto palette = make_skinning_palette(mesh, sets, AffinePose(mesh.joints.size(), identity_map<double>()));
    batch.linear(palette);
    return gen::refuses<std::invalid_argument>([&] { batch.spherical(palette); });
  });
}

}  // namespace

PROPTEST(batch_refit) {
  more_weight_vertices_than_joints(t);
  the_slack_holds_what_floats_lose(t);
  hard_cases_miss_no_vertex(t);
  many_joints_and_great_lengths(t);
  t.example(
      "of the built-in man's nodes most are refitted whole and some are merged, in lanes of unlike weight vertices too", {}, [] {
        const Model man = make_man();
        const JointSets sets(man);
        const SphereTree tree = build_sphere_tree(man, sets);
        const PackedNodes packed(tree, sets);
        const auto unlike = [](const NodeBlocks& blocks) {
          long count = 0;
          for (int b = 0; b < blocks.block_count; ++b) count += blocks.blocks[b].share == 0;
          return count;
        };
        const NodeBlocks nodes = packed.nodes(), pieces = packed.pieces();
        const auto merged = static_cast<long>(packed.merged().size()), whole = static_cast<long>(tree.nodes.size()) - merged;
        return Checked(whole > 5 * merged && merged > 100 && unlike(nodes) > 100 && unlike(nodes) < nodes.block_count / 2 &&
                           unlike(pieces) > 50 && unlike(pieces) < pieces.block_count / 2,
                       whole + merged,
                       std::to_string(whole) + " whole, " + std::to_string(merged) + " merged; of unlike lanes are " +
                           std::to_string(unlike(nodes)) + " of " + std::to_string(nodes.block_count) + " blocks and " +
                           std::to_string(unlike(pieces)) + " of " + std::to_string(pieces.block_count) + " of pieces");
      });
}

}  // namespace proptests::suite_batch_refit
