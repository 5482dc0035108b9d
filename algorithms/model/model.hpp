// SPDX-License-Identifier: GPL-3.0-or-later
// Model: a skinned mesh, and the clips that pose its joints.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/skeleton_motion.hpp"

namespace refitlab {

struct Clip {
  std::string name;
  double duration;                     // seconds
  std::function<Pose(double)> sample;  // at a time in [0, duration]; throws ModelError for a pose that is not rigid
  Animation animation = {};            // of the model's skeleton; without tracks where there is no skeleton
};

// A primitive of a file as one node shows it, and what of the model was made of it. A model vertex may be that of several
// primitives, and of several vertices of one.
struct SourcePrimitive {
  int node, mesh, primitive, skin;  // indices in the file; -1 for no skin
  std::vector<int> vertices;        // by the primitive's vertex: the model's, or -1 for one that no triangle uses
  std::vector<int> triangles;       // by the primitive's triangle: the model's, or -1 for one that was dropped
};

// By how much a morph target moves vertices, in the frame of the reference pose. Others stay.
struct MorphTarget {
  std::vector<std::pair<int, Point3>> displacements;  // by vertex, in increasing order
};

// A mesh with morph targets as one node shows it. Before a vertex v of it is skinned, it is moved to v plus the sum over the
// targets of weight times displacement. No vertex has displacements of two meshes.
struct MorphedMesh {
  int node;                     // of the skeleton's nodes, whose WeightTrack has the weights
  std::vector<double> weights;  // by target, where no clip moves them
  std::vector<MorphTarget> targets;
};

struct Model : SkinnedMesh {
  std::vector<Clip> clips = {};
  // How far the skin matrices M of a file, its scale s taken out, are from rotations: the largest Frobenius norm of
  // M^T M / s^2 - I over the joints and the times that were checked on loading. 0 where clips are made of rotations.
  double rigidity_defect = 0;
  // What the clips' animations move: of models from files. Its joints are the mesh's.
  BoundSkeleton skeleton = {};
  // Where all of it comes from: of models from files. A skinned mesh that several nodes show with one skin is in the model
  // once, and has a source for each node.
  std::vector<SourcePrimitive> sources = {};
  // Of models loaded with Morphs::moving, whose vertices are those of weights 0.
  std::vector<MorphedMesh> morphs = {};
  // What of the file is not in the model, or not as the file has it, in sentences for its user.
  std::vector<std::string> notes = {};
};

// Says whether the joints are affine at one of 16 moments of a clip, evenly spread. Those of a model without clips are as they rest.
Joints joints_of(const Model& model);

// All targets of all morphed meshes, those of the first mesh first.
MorphTargets morph_targets(const Model& model);

// Returns the model's mesh, with these targets.
SkinnedMesh skinned_mesh(Model model);

// In their order, the weights at a time of an animation of the model.
std::vector<double> morph_weights(const Model& model, const Animation& animation, double time, Side side = Side::after);

}  // namespace refitlab
