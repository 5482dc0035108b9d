// SPDX-License-Identifier: GPL-3.0-or-later
// These are the skeletons of the built-in models and their vertex weights.
#pragma once

#include "experiments/procedural/procedural_mesh.hpp"

namespace refitlab {

// A Bone is a joint with the bone that it moves, in the reference pose.
struct Bone {
  std::string name;
  std::string parent;  // a bone that comes before this one; empty for the root
  Point3 origin, tip;
  double thickness;  // of the flesh around it, metres: weights blend over about this length
};

std::vector<Joint> joints_of(const std::vector<Bone>& bones);

// Adds "left_" and "right_" twins of bones of the left side. A parent is the twin if there is one.
void add_pair(std::vector<Bone>& bones, const std::vector<Bone>& left_side);

// Returns weights after Baran & Popovic 2007, "Automatic rigging and animation of 3D characters". For each joint in turn, its
// bone is hot and the others are cold; each vertex is heated by the bone whose flesh is nearest, and heat spreads along the skin.
// So weights blend over about a bone's thickness, and follow the skin rather than cross a gap. A vertex has at most four joints,
// and a weight fades to zero before it is left out.
std::vector<std::vector<Influence>> heat_weights(const SkinMesh& skin, const std::vector<Bone>& bones);

}  // namespace refitlab
