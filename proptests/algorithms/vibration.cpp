// SPDX-License-Identifier: GPL-3.0-or-later
// Tests reduced deformations of the experiments: how a mesh vibrates, principal components, and BD-tree's balls of them.
#include "experiments/deformations/vibration.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "algorithms/bake/bake.hpp"
#include "algorithms/methods/refit/bd_tree.hpp"
#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/refit/deformed_reference.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "experiments/deformations/deforming.hpp"
#include "experiments/deformations/deforming_man.hpp"
#include "experiments/deformations/reduced_basis.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_vibration {
namespace {

using namespace refitlab;

double largest(const std::vector<std::vector<Point3>>& frames) {
  double out = 0;
  for (const auto& frame : frames)
    for (const Point3& d : frame) out = std::max(out, d.norm());
  return out;
}

// Returns frames of random displacements, some of which are sums of others.
std::vector<std::vector<Point3>> random_frames(int count, std::size_t vertices, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<std::vector<Point3>> out;
  for (int f = 0; f < count; ++f) {
    auto& frame = out.emplace_back();
    const bool repeats = f > 1 && random() % 4 == 0;
    for (std::size_t v = 0; v < vertices; ++v)
      frame.push_back(repeats ? Point3(out[0][v] - 2 * out[1][v]) : Point3(normal(random), normal(random), normal(random)));
  }
  return out;
}

void check_basis() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const int frames = *rc::gen::inRange(1, 9), size = *rc::gen::inRange(1, frames + 1);
  const auto displacements = random_frames(frames, 5, random);
  const ReducedBasis basis = reduced_basis(displacements, size), whole = reduced_basis(displacements, frames);
  RC_ASSERT(basis.targets.count == size && basis.share >= 0 && basis.share <= whole.share + 1e-12);
  RC_ASSERT(std::abs(whole.share - 1) < 1e-12);
  double left = 0, all = 0;
  for (std::size_t f = 0; f < displacements.size(); ++f)
    for (std::size_t v = 0; v < displacements[f].size(); ++v) {
      const auto sum = [&](const ReducedBasis& b) {
        return displaced<double>(Point3(0, 0, 0), std::span<const Displacement<double>>(b.targets.of_vertex[v]),
                                 b.coordinates[f]);
      };
      const Point3& d = displacements[f][v];
      RC_ASSERT((sum(whole) - d).norm() < 1e-12 * (1 + d.norm()) * frames);
      left += (sum(basis) - d).squaredNorm(), all += d.squaredNorm();
    }
  RC_ASSERT(std::abs(1 - left / all - basis.share) < 1e-12);
  for (int k = 0; k < size; ++k) {
    double sum = 0;
    for (const auto& q : basis.coordinates) sum += q[static_cast<std::size_t>(k)] * q[static_cast<std::size_t>(k)];
    RC_ASSERT(std::abs(sum / frames - 1) < 1e-12);
  }
}

struct Published {
  Ball3<double> ball;
  // This is the size of the terms of its center and radius.
  double size;
};

// Returns a node's ball as published, by sums over its vertices.
Published published(const Character& c, int node, const std::vector<double>& q) {
  const auto vertices = c.vertices[node];
  Ball3<double> ball = c.tree.nodes[static_cast<std::size_t>(node)].reference;
  double size = ball.center.norm() + ball.radius;
  for (int k = 0; k < c.mesh.targets.count; ++k) {
    const auto of = [&](int v) {
      for (const Displacement<double>& d : c.mesh.displacements(v))
        if (d.target == k) return d.by;
      return Point3(0, 0, 0);
    };
    Point3 mean(0, 0, 0);
    for (const int v : vertices) mean += of(v) / static_cast<double>(vertices.size());
    double farthest = 0;
    for (const int v : vertices) farthest = std::max(farthest, (of(v) - mean).norm());
    const double weight = q[static_cast<std::size_t>(k)];
    ball.center += weight * mean;
    ball.radius += std::abs(weight) * farthest;
    size += std::abs(weight) * (mean.norm() + farthest);
  }
  return {ball, size};
}

void check_bd_tree() {
  const auto plan = gen::classified_plan();
  SkinnedMesh mesh = gen::make_mesh(plan);
  std::mt19937 random(plan.seed);
  gen::add_targets(mesh, random);
  const std::vector<double> q = gen::random_weights(mesh, random);
  const Character ours = bake(std::move(mesh), {.triangles_per_leaf = static_cast<int>(plan.seed % 3) + 1}, {}),
                  theirs = bd_tree(ours);
  RC_TAG(q.empty() ? "no targets" : "targets");
  const auto palette = make_skinning_palette(ours.mesh, ours.sets, reference_pose(ours.mesh), Skinning::dual_quaternion);
  const Deformation deformation{q, {}};
  ExactSkin exact(ours.mesh, ours.sets, palette, Skinning::dual_quaternion, deformation);
  DeformedReference our_reference(ours, Pieces::node), reference(theirs, Pieces::node);
  our_reference.begin(deformation), reference.begin(deformation);
  for (int n = 0; n < static_cast<int>(ours.tree.nodes.size()); ++n) {
    const Ball3<double> ball = reference.refit_node(n, palette).reference;
    const auto [expected, size] = published(ours, n, q);
    RC_ASSERT(std::abs(ball.radius - expected.radius) <= 1e-12 * size && (ball.center - expected.center).norm() <= 1e-12 * size);
    RC_ASSERT(our_reference.refit_node(n, palette).reference.radius <= ball.radius + 1e-12 * size);
    for (const int v : ours.vertices[n]) RC_ASSERT(exact.is_in(ball, v));
  }
}

// Says whether a jolt sets off every vertex, and nothing gains energy: late frames do not move farther than early ones by much.
bool vibrates(int frames) {
  SkinnedMesh mesh = gen::make_mesh({gen::MeshKind::tube, 10, 8, 3, 5});
  auto box = Box<double>::empty();
  for (const Point3& v : mesh.vertices) box.merge(v);
  const auto all = vibration(mesh, frames);
  if (static_cast<int>(all.size()) != frames || std::abs(largest(all) - 0.05 * box.edges().maxCoeff()) > 1e-12) return false;
  for (const Point3& d : all[0])
    if (!(d.norm() > 0)) return false;
  const std::vector<std::vector<Point3>> late(all.begin() + frames / 2, all.end());
  return largest(late) > 0 && largest(late) < largest(all) * 1.01;
}

// Says whether the vertices of a model that deforms itself are right: linearly skinned, they are the matrices of its file's
// joints times displaced vertices; other skinning has the same displacements, and the scales.
bool frames_have_the_whole_pose(const Model& model, double share) {
  const AnimatedCharacter c = bake_animated(model, {}, {});
  const std::array<double, 1> shares = {share};
  const DeformedPose pose = own_poses(model, shares).at(0);
  const Clip& clip = model.clips.at(0);
  const auto matrices = skin_matrices(model.skeleton, clip.animation, share * clip.duration);
  const auto weights = weights_at(clip.animation.weight_tracks.at(0), share * clip.duration);
  const DeformedFrame linear = frame_of(c, pose, Skinning::linear);
  const auto skinned = skin(c.mesh, c.sets, linear.palette, Skinning::linear, linear.deformation);
  for (std::size_t v = 0; v < skinned.size(); ++v) {
    Point3 at = model.vertices[v], sum(0, 0, 0);
    for (const Displacement<double>& d : c.mesh.displacements(static_cast<int>(v))) at += weights[d.target] * d.by;
    for (const Influence& i : model.influences[v])
      sum += i.weight * (matrices[static_cast<std::size_t>(i.joint)] * at.homogeneous()).head<3>();
    if (!((sum - skinned[v]).norm() < 1e-12)) return false;
  }
  for (const Skinning skinning : {Skinning::spherical, Skinning::dual_quaternion}) {
    const DeformedFrame frame = frame_of(c, pose, skinning);
    if (frame.deformation.weights != linear.deformation.weights || frame.deformation.scales.size() != c.mesh.joints.size())
      return false;
  }
  return linear.palette.is_affine() && linear.deformation.scales.empty();
}

}  // namespace

PROPTEST(vibration) {
  t.holds("the principal components have the share that they leave nothing else of, and all of them have everything",
          {.number_type = "double", .cases = 300}, check_basis);
  t.example("a basis of more frames than there are is refused", {}, [] {
    try {
      reduced_basis({{Point3(1, 0, 0)}}, 2);
      return false;
    } catch (const std::invalid_argument&) {
      return true;
    }
  });
  t.holds(
      "BD-tree's balls are the published ones, hold the displaced vertices exactly, and are no smaller than ours",
      {.number_type = "double against rational", .cases = 200, .degenerate_at_least = 0.1, .tags_at_least = {{"targets", 0.6}}},
      check_bd_tree);
  t.example("a jolt sets off every vertex, and the vibration stays within its first swings", {.number_type = "double"},
            [] { return vibrates(40); });
  t.example("the deforming man has targets that move, no pose of his is rigid, and frames have the whole of it",
            {.number_type = "double"}, [] {
              const Model man = make_deforming_man();
              if (!frames_have_the_whole_pose(man, 0.3)) return false;
              const std::vector<double> shares = even_shares(3);
              const auto poses = own_poses(man, shares);
              bool is_deformed = deforms_itself(man) && poses.size() == 3 * man.clips.size();
              for (const DeformedPose& pose : poses)
                is_deformed = is_deformed && !pose.scales.empty() && pose.weights.size() == 3;
              return is_deformed && poses[0].weights != poses[1].weights && !deforms_itself(make_man());
            });
}

}  // namespace proptests::suite_vibration
