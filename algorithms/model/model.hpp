// SPDX-License-Identifier: GPL-3.0-or-later
// A Model is a skinned mesh and the clips that pose its joints.
#pragma once

#include <functional>
#include <span>
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

// A SourcePrimitive is a primitive of a file as one node shows it, and the part of the model that was made from it. A model
// vertex may come from several primitives, and from several vertices of one.
struct SourcePrimitive {
  int node, mesh, primitive, skin;  // indices in the file; -1 for no skin
  std::vector<int> vertices;        // by the primitive's vertex: the model's, or -1 for one that no triangle uses
  std::vector<int> triangles;       // by the primitive's triangle: the model's, or -1 for one that was dropped
};

// A MorphTarget has the displacements of the vertices that it moves, in the frame of the reference pose. Others stay.
struct MorphTarget {
  std::vector<std::pair<int, Point3>> displacements;  // by vertex, in increasing order
};

// A MorphedMesh is a mesh with morph targets as one node shows it. Before a vertex v of it is skinned, it is moved to v plus the
// sum over the targets of weight times displacement. No vertex has displacements of two meshes.
struct MorphedMesh {
  int node;                     // of the skeleton's nodes, whose WeightTrack has the weights
  std::vector<double> weights;  // by target, where no clip moves them
  std::vector<MorphTarget> targets;
};

// A LostInfluence is a joint to which the file gives a share of a vertex that quantize_weights rounds to 0. So no influence of
// the mesh tells of it, but a renderer of the file moves the vertex by it.
struct LostInfluence {
  int vertex, joint;
  double share;  // of the sum of the vertex's weights, in (0, 2^-24)
};

// A PlacedVertex is one that a file has in another frame than the model's reference pose. A renderer of the file begins with the
// file's coordinates, and rounds what these are.
struct PlacedVertex {
  int vertex, placement;  // the vertex of the file is moved by Model::placements[placement]
};

struct Model : SkinnedMesh {
  std::vector<Clip> clips = {};
  // This says how far the skin matrices M of a file are from rotations, after its scale s is taken out. It is the largest
  // Frobenius norm of M^T M / s^2 - I over the joints and the times that were checked on loading. It is 0 where clips are made of
  // rotations.
  double rigidity_defect = 0;
  // The clips' animations move this skeleton, which models from files have. Its joints are the mesh's.
  BoundSkeleton skeleton = {};
  // The model was made from these sources, which models from files have. A skinned mesh that several nodes show with one skin is
  // in the model once, and has a source for each node.
  std::vector<SourcePrimitive> sources = {};
  // Models loaded with Morphs::moving have these. Their vertices are those of weights 0.
  std::vector<MorphedMesh> morphs = {};
  std::vector<LostInfluence> lost_influences = {};  // of files, by vertex and joint in increasing order
  std::vector<Eigen::Matrix4d> placements = {};     // from the frames of a file's meshes to the reference pose
  std::vector<PlacedVertex> placed_vertices = {};   // by vertex and placement in increasing order
  // The notes say, in sentences for the user, what of the file is missing in the model or different.
  std::vector<std::string> notes = {};
};

// Says whether the joints are affine at one of 16 moments of a clip, evenly spread. For a model without clips the joints are
// taken as they rest.
Joints joints_of(const Model& model);

// Each returns those of a vertex.
std::span<const LostInfluence> lost_influences(const Model& model, int vertex);
std::span<const PlacedVertex> placed_vertices(const Model& model, int vertex);

// Returns the displacement of a vertex by a target, or null if it stays.
const Point3* displacement_of(const MorphTarget& target, int vertex);

// Returns all targets of all morphed meshes, those of the first mesh first.
MorphTargets morph_targets(const Model& model);

// Returns the model's mesh, with these targets.
SkinnedMesh skinned_mesh(Model model);

// Returns the track of a mesh's weights, or nullptr if they stay. The animation is to outlive it.
const WeightTrack* weight_track_of(const MorphedMesh& mesh, const Animation& animation);

// Returns the weights of a mesh by target, at a time of its track, or where they stay if that is nullptr.
Eigen::VectorXd weights_at(const MorphedMesh& mesh, const WeightTrack* track, double time, Side side = Side::after);

// Returns the weights of these targets, in their order, at a time of an animation of the model.
std::vector<double> morph_weights(const Model& model, const Animation& animation, double time);

}  // namespace refitlab
