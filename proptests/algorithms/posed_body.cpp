// SPDX-License-Identifier: GPL-3.0-or-later
// Tests posed bodies: their vertices are the doubles that skinning and placing all of a mesh makes.
#include "algorithms/certificate/posed_body.hpp"

#include "algorithms/bake/bake.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/all_pairs.hpp"

namespace proptests::suite_posed_body {
namespace {

using namespace refitlab;

void check_posed() {
  const auto plan = gen::classified_plan();
  SkinnedMesh mesh = gen::make_mesh(plan);
  const std::size_t used = mesh.vertices.size();
  mesh.vertices.push_back({7, 8, 9});  // It belongs to no triangle.
  mesh.influences.push_back(mesh.influences[0]);
  const auto c = bake(std::move(mesh));
  std::mt19937 random(plan.seed);
  const Pose pose = gen::random_pose(c.mesh, random);
  const RigidTransform<double> at{gen::random_rotation(random, 1), {1, 2, 3}};
  const auto skinning = *rc::gen::element(Skinning::linear, Skinning::spherical, Skinning::dual_quaternion);
  const ClusterTree tree(c);
  ClusterBody body(tree, skinning);
  body.begin(pose, at);
  const PosedBody found = posed_body(body, "it");
  const auto wanted = oracle::Posed{c, pose, at}.vertices(skinning);
  RC_ASSERT(found.name == "it");
  RC_ASSERT(found.triangles == c.mesh.triangles);
  std::vector<bool> is_used(used + 1);
  for (const auto& triangle : c.mesh.triangles)
    for (const int v : triangle) is_used[v] = true;
  for (std::size_t v = 0; v < found.vertices.size(); ++v)
    RC_ASSERT(found.vertices[v] == (is_used[v] ? wanted[v] : c.mesh.vertices[v]));
}

}  // namespace

PROPTEST(posed_body) {
  t.holds("each vertex of a triangle is as skinning and placing makes it, and others are as the mesh has them",
          {.number_type = "double", .cases = 60, .degenerate_at_least = 0.2}, check_posed);
}

}  // namespace proptests::suite_posed_body
