// SPDX-License-Identifier: GPL-3.0-or-later
// This shows the refit in an engine: which bounding spheres of a posed character does a ray hit? The mesh is not skinned for it;
// nodes of few vertices skin those.
#include <algorithm>
#include <cstdio>

#include "algorithms/bake/bake.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/runtime/tree/character.hpp"
#include "experiments/procedural/procedural.hpp"

using namespace refitlab;

const RefitVariant& variant = default_variant(Skinning::spherical);

// This happens each frame, on demand: a node is refitted only when the ray reaches it.
int leaves_hit(const Character& character, int node, const SkinningPalette<double>& palette, const Point3& from,
               const Point3& direction) {
  const Ball3<double> ball = variant.refit(character.refit_node(node, palette, variant.pieces));
  const Point3 to_center = ball.center - from;
  const double along = std::max(0., dot(to_center, direction));  // of the ray's nearest point to the center
  if (squared_norm<double, 3>(to_center - direction * along) > sq(ball.radius)) return 0;
  const TreeNode& n = character.tree.nodes[node];
  int hits = n.child_count == 0;
  for (int child = n.first_child; child < n.first_child + n.child_count; ++child)
    hits += leaves_hit(character, child, palette, from, direction);
  return hits;
}

int main(int argc, char** argv) try {
  // This happens once, when the character is loaded. It makes the sphere tree and the data of the refit.
  const Model model = argc > 1 ? load_model(argv[1]) : make_man();
  const Character character = bake(model);
  // Your engine's joint transforms go here: a rotation and a translation for each joint, from the reference pose.
  const Pose pose = model.clips.empty() ? reference_pose(model) : model.clips[0].sample(model.clips[0].duration / 4);
  const auto palette = make_skinning_palette(character.mesh, character.sets, pose, variant.skinning);
  const int hits = leaves_hit(character, 0, palette, {0, 1.2, 5}, {0, 0, -1});
  std::printf("a ray at the chest reaches %d leaves of %zu nodes\n", hits, character.tree.nodes.size());
} catch (const std::exception& e) {
  std::fprintf(stderr, "engine_refit: %s\n", e.what());
  return 1;
}
