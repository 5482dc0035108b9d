// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what deforms a reference pose: affine joints and their polar decomposition, scales, and weights of morph targets.
#include "algorithms/runtime/skinning/deformation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/refuses.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_deformation {
namespace {

using namespace refitlab;
using gen::JointKind;
using Matrix = Eigen::Matrix3d;

Matrix matrix_of(const AffineMap<double>& map) {
  Matrix out;
  out << map.columns[0], map.columns[1], map.columns[2];
  return out;
}

Matrix matrix_of(const refitlab::Quaternion<double>& q) { return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix(); }

SkinnedMesh small_mesh(const gen::MeshPlan& plan, std::mt19937& random) {
  SkinnedMesh mesh = gen::make_mesh(plan);
  gen::add_targets(mesh, random);
  return mesh;
}

JointKind drawn_kind() {
  return *rc::gen::element(JointKind::rigid, JointKind::uniform, JointKind::axes, JointKind::shear, JointKind::mirrored,
                           JointKind::flat, JointKind::extreme, JointKind::mixed);
}

// Returns the message of the refusal, or nothing if the deformation is accepted.
std::string refusal(const SkinnedMesh& mesh, const Deformation& deformation) {
  try {
    check_deformation(mesh, deformation);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

// Returns the vertex by the definition, in rationals, as a sum over all weights and all targets.
Vec<Rational, 3> by_definition(const SkinnedMesh& mesh, const Deformation& d, int vertex) {
  Vec<Rational, 3> moved = convert<Rational>(mesh.vertices[static_cast<std::size_t>(vertex)]);
  for (int t = 0; t < mesh.targets.count && !d.weights.empty(); ++t)
    for (const auto& by : mesh.displacements(vertex))
      for (int i = 0; by.target == t && i < 3; ++i)
        moved[i] += Rational(d.weights[static_cast<std::size_t>(t)]) * Rational(by.by[i]);
  if (d.scales.empty()) return moved;
  Vec<Rational, 3> out = Vec<Rational, 3>::Zero();
  for (const Influence& influence : mesh.influences[static_cast<std::size_t>(vertex)]) {
    const auto& map = d.scales[static_cast<std::size_t>(influence.joint)];
    for (int row = 0; row < 3; ++row) {
      Rational image(map.offset[row]);
      for (int i = 0; i < 3; ++i) image += Rational(map.columns[static_cast<std::size_t>(i)][row]) * moved[i];
      out[row] += Rational(influence.weight) * image;
    }
  }
  return out;
}

void decomposed_joints_and_deformed_vertices(Suite& t) {
  t.holds("an affine joint is a rotation behind a symmetric scale about its origin, up to rounding",
          {.number_type = "double", .cases = 1000, .tags_at_least = {{"mirrors", 0.1}, {"flattens", 0.05}, {"turns", 0.4}}}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 1, 1});
            mesh.joints[0].origin = Point3(0.3, -0.7, 2);
            const AffineMap<double> joint = gen::random_affine_pose(mesh, drawn_kind(), random)[0];
            const SplitJoint parts = split(joint, mesh.joints[0].origin);
            const Matrix a = matrix_of(joint), s = matrix_of(parts.scale), r = matrix_of(parts.rigid.rotation);
            RC_CLASSIFY(a.determinant() < 0, "mirrors");
            RC_CLASSIFY(a.determinant() == 0, "flattens");
            RC_CLASSIFY(std::abs(parts.rigid.rotation[0]) < 0.9, "turns");
            RC_ASSERT(s == s.transpose());
            RC_ASSERT(std::abs(squared_norm(parts.rigid.rotation) - 1) <= 1e-15);
            RC_ASSERT((r * s - a).norm() <= 1e-14 * a.norm() + 1e-300);
            const Point3& origin = mesh.joints[0].origin;
            const double size = 1e-14 * (1 + a.norm()) * (1 + origin.norm()) + 1e-14 * joint.offset.norm();
            RC_ASSERT((apply(parts.scale, origin) - origin).norm() <= size);
            const Point3 x(1.5, -0.5, 0.25);
            RC_ASSERT((apply(parts.rigid, apply(parts.scale, x)) - apply(joint, x)).norm() <= size * 10);
            // The rotation is the nearest one: no eigenvalue of S is negative but the least one of a mirror.
            const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Matrix>(s).eigenvalues();
            const double rounding = 1e-14 * a.norm();
            RC_ASSERT(values[1] >= -rounding && values[0] + values[1] >= -rounding);
            RC_ASSERT(a.determinant() < 0 || values[0] >= -rounding);
          });
  t.holds("a deformed vertex is the sum over targets, and then over the scales of its joints",
          {.number_type = "rational", .cases = 300, .degenerate_at_most = 0.85, .tags_at_least = {{"both", 0.3}}}, [] {
            const auto plan = *gen::mesh_plan();
            std::mt19937 random(plan.seed);
            const SkinnedMesh mesh = small_mesh(plan, random);
            const JointSets sets(mesh);
            Deformation d;
            if (random() % 4) d.weights = gen::random_weights(mesh, random);
            if (random() % 4) d.scales = gen::random_scales(mesh, drawn_kind(), random);
            RC_CLASSIFY(gen::is_degenerate(plan) || d.is_none(), "degenerate");
            RC_CLASSIFY(!d.weights.empty() && !d.scales.empty(), "both");
            // The vertices are skinned by joints that do not move.
            const auto palette = make_skinning_palette(mesh, sets, reference_pose(mesh), Skinning::dual_quaternion);
            ExactSkin exact(mesh, sets, palette, Skinning::dual_quaternion, d);
            const auto doubles = deformed_vertices(mesh, sets, d);
            for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
              const Vec<Rational, 3> expected = by_definition(mesh, d, v);
              RC_ASSERT(exact.exact(v) == expected);
              Point3 near;
              for (int i = 0; i < 3; ++i) near[i] = CGAL::to_double(expected[i]);
              // The sum may be much shorter than what it is a sum of: weights to 1000, scales to 5000.
              RC_ASSERT((doubles[static_cast<std::size_t>(v)] - near).norm() <= 1e-6);
            }
          });
}

void affine_joints_are_skinned_linearly(Suite& t) {
  t.holds("linear skinning by affine joints is the sum of the images", {.number_type = "rational", .cases = 150}, [] {
    const auto plan = *gen::mesh_plan();
    std::mt19937 random(plan.seed);
    const SkinnedMesh mesh = small_mesh(plan, random);
    const JointSets sets(mesh);
    const Deformation morphs{gen::random_weights(mesh, random), {}};
    const AffinePose pose = gen::random_affine_pose(mesh, drawn_kind(), random);
    const auto palette = make_skinning_palette(mesh, sets, pose);
    RC_ASSERT(palette.is_affine() && palette.is_measured());
    ExactSkin exact(mesh, sets, palette, Skinning::linear, morphs);
    Deformation all = morphs;
    all.scales = pose;  // The sum is the same.
    for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) RC_ASSERT(exact.exact(v) == by_definition(mesh, all, v));
  });
  t.holds("rigid joints as affine ones are skinned as rigid ones, up to rounding", {.number_type = "double", .cases = 150}, [] {
    const auto plan = *gen::mesh_plan();
    std::mt19937 random(plan.seed);
    const SkinnedMesh mesh = gen::make_mesh(plan);
    const JointSets sets(mesh);
    const AffinePose pose = gen::random_affine_pose(mesh, JointKind::rigid, random);
    const auto [rigid, scales] = split(mesh, pose);
    const auto a = skin(mesh, sets, make_skinning_palette(mesh, sets, pose), Skinning::linear);
    const auto b = skin(mesh, sets, make_skinning_palette(mesh, sets, rigid, Skinning::linear), Skinning::linear);
    for (std::size_t v = 0; v < a.size(); ++v) RC_ASSERT((a[v] - b[v]).norm() <= 1e-12 * (1 + a[v].norm()));
  });
}

}  // namespace

PROPTEST(deformation) {
  t.example("a palette of affine joints is skinned linearly alone, and other skinning is refused", {}, [] {
    const SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
    const JointSets sets(mesh);
    AffinePose moved(mesh.joints.size(), identity_map<double>());
    for (auto& joint : moved) joint.offset = {100, 0, 0};
    const auto palette = make_skinning_palette(mesh, sets, moved);
    bool ok = skin(mesh, sets, palette, Skinning::linear)[0][0] > 50;
    for (const Skinning skinning : {Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion})
      ok = ok && gen::refuses<std::invalid_argument>([&] { skin(mesh, sets, palette, skinning); });
    return Checked(ok, 4);
  });
  decomposed_joints_and_deformed_vertices(t);
  affine_joints_are_skinned_linearly(t);
  t.example("what is out of range or of another number is refused by name", {}, [] {
    std::mt19937 random(1);
    SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, 1});
    mesh.targets = {2, std::vector<std::vector<Displacement<double>>>(mesh.vertices.size())};
    AffinePose huge = gen::random_scales(mesh, JointKind::axes, random);
    huge[1].columns[2][0] = 1.1e4;
    const AffinePose good = gen::random_scales(mesh, JointKind::axes, random);
    AffinePose few = good, many = good;
    few.pop_back(), many.push_back(good[0]);
    const auto says = [&](const Deformation& d, const char* words) { return refusal(mesh, d).find(words) != std::string::npos; };
    bool are_numbers_refused = true;
    for (int i = 0; i < 12; ++i)  // the first nine are those of the matrix
      for (const double bad : {std::nan(""), -HUGE_VAL, HUGE_VAL, -1.1e40, 1.1e40}) {
        AffinePose scales = good;
        (i < 9 ? scales[1].columns[static_cast<std::size_t>(i / 3)][i % 3] : scales[1].offset[i - 9]) = bad;
        const char* const reason = !std::isfinite(bad) ? "its transform is not finite"
                                   : i < 9             ? "its matrix is out of range"
                                                       : "its translation is out of range";
        are_numbers_refused = are_numbers_refused && says({{}, scales}, reason) && says({{}, scales}, "joint 1");
      }
    return are_numbers_refused && refusal(mesh, {{}, good}).empty() && says({{}, many}, "transforms for 2 joints") &&
           says({{1, 2, 3}, {}}, "has 3 weights for 2 morph targets") && refusal(mesh, {{-1e4, 0}, {}}).empty() &&
           refusal(mesh, {{1e4, 0}, {}}).empty() && says({{}, huge}, "joint 1") &&
           says({{}, huge}, "its matrix is out of range") && says({{}, few}, "transforms for 2 joints") &&
           says({{1}, {}}, "has 1 weights for 2 morph targets") &&
           says({{1, std::nan("")}, {}}, "its weight of morph target 1 is not finite") &&
           says({{-INFINITY, 1}, {}}, "its weight of morph target 0 is not finite") &&
           says({{-6e3, 6e3}, {}}, "weights of morph targets sum to more than 1e4");
  });
}

}  // namespace proptests::suite_deformation
