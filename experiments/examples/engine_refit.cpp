// The refit in an engine: which bounding spheres of a posed character does a ray hit? No vertex is skinned for it.
#include <cstdio>

#include "algorithms/model/procedural.hpp"
#include "algorithms/refit/character.hpp"

using namespace refitlab;

// Once, when the character is loaded: the sphere tree and what the refit looks at.
const Character character(make_man());
const RefitVariant& variant = default_variant(Skinning::spherical);

// Each frame, on demand: a node is refitted only when the ray reaches it.
int leaves_hit(int node, const SkinningPose<double>& pose, const Point3& from, const Point3& direction) {
  const Ball3<double> ball = variant.refit(character.refit_node(node, pose, variant.pieces));
  const Point3 to_center = ball.center - from;
  const double along = dot(to_center, direction);
  if (along < 0 || squared_norm<double, 3>(to_center - direction * along) > sq(ball.radius)) return 0;
  const TreeNode& n = character.tree.nodes[node];
  int hits = n.child_count == 0;
  for (int child = n.first_child; child < n.first_child + n.child_count; ++child)
    hits += leaves_hit(child, pose, from, direction);
  return hits;
}

int main() {
  const Clip& walk = character.model.clips[0];
  // Your engine's joint transforms go here: a rotation and a translation for each joint, from the reference posture.
  const Posture posture = walk.sample(walk.duration / 4);
  const auto pose = make_skinning_pose(character.model, character.sets, posture, variant.skinning);
  const int hits = leaves_hit(0, pose, {0, 1.2, 5}, {0, 0, -1});
  std::printf("a ray at the chest reaches %d leaves of %zu nodes\n", hits, character.tree.nodes.size());
  return hits > 0 ? 0 : 1;
}
