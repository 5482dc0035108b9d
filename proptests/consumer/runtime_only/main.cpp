// SPDX-License-Identifier: MIT
// Reads a baked character, by itself and from a glTF file, bends it, and asks which triangles of two of it touch, as a game does,
// with nothing but the runtime. Exits with 1 if the answer is not that of bodies that stand in each other, and beside each other.
#include <cmath>
#include <cstdio>
#include <exception>

#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/tree/baked_file.hpp"
#include "algorithms/runtime/tree/character_file.hpp"

int main(int, char** argv) try {
  using namespace refitlab;
  const Character arm = read_character(argv[1]);
  const BakedFile baked = read_baked(argv[2]);
  if (!baked.character || bytes_of(*baked.character) != bytes_of(arm)) return std::puts("the files have two characters"), 1;
  const ClusterTree clusters(arm);
  Pose pose = reference_pose(arm.mesh);
  for (auto& joint : pose) joint = {{std::cos(0.1), 0, std::sin(0.1), 0}, Point3::Zero()};  // It is turned as a whole.

  ClusterBody first(clusters, Skinning::spherical), second(clusters, Skinning::spherical), third(clusters, Skinning::spherical);
  first.begin(pose, {});
  second.begin(reference_pose(arm.mesh), {identity_quaternion<double>(), {0.1, 0, 0}});
  third.begin(pose, {identity_quaternion<double>(), {10, 0, 0}});
  QueryCounts counts;
  const auto touching = collide(first, second, Query::full, counts), apart = collide(first, third, Query::full, counts);

  ClusterBody* const bodies[] = {&first, &second, &third};
  CrowdCounts of_crowd;
  const auto contacts = collide_all(bodies, Query::yes_no, of_crowd);

  const RefitVariant& variant = default_variant(Skinning::spherical);
  const auto palette = make_skinning_palette(arm.mesh, arm.sets, pose, variant.skinning);
  const Ball3<double> ball = variant.refit(arm.refit_node(0, palette, variant.pieces));
  std::printf("%s: %zu triangles in a ball of radius %.3f; %zu pairs touch, %zu from afar, %zu contact of a crowd\n",
              arm.mesh.name.c_str(), arm.mesh.triangles.size(), ball.radius, touching.size(), apart.size(), contacts.size());
  return touching.empty() || !apart.empty() || contacts.size() != 1 || !(ball.radius > 0) ? 1 : 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "runtime_only: %s\n", e.what());
  return 1;
}
