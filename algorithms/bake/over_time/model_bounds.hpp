// SPDX-License-Identifier: GPL-3.0-or-later
// ModelBounds are bounds over time of everything in a model: its clusters of triangles, the file's primitives, meshes and skins,
// and the whole. They hold in every clip and in the rest pose, and, on request, while any clip fades to any other.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "algorithms/bake/over_time/any_pose.hpp"
#include "algorithms/bake/over_time/bound_over_time.hpp"
#include "algorithms/bake/over_time/crossfaded_joints.hpp"
#include "algorithms/runtime/tree/cluster_bounds.hpp"

namespace refitlab {

// PartKind says which kind of part a bound is for.
enum class PartKind { whole, skin, mesh, primitive, cluster };
const char* name_of(PartKind kind);

struct ModelPart {
  PartKind kind;
  // This is the file's skin or mesh. For a primitive and a cluster it is the position in Model::sources. For the whole, and for
  // models that are not from glTF, it is -1.
  int index;
  std::vector<int> vertices;   // the model's, in increasing order
  std::vector<int> triangles;  // of a cluster; the model's
};

// A box and a ball are made from these intervals of time (ProvenInterval).
struct PartIntervals {
  std::vector<ProvenInterval> box, ball;
};

struct BoundedClip {
  std::string name;
  double duration;                       // seconds
  std::vector<BoundedPart> parts;        // by part
  std::vector<PartIntervals> intervals;  // by part; empty unless asked for
  std::vector<BoundedPart> nodes;        // by node of ModelBoundsOptions::nodes
};

// These bounds hold while a clip fades to another, or back, at any time of either clip, and before and after.
struct BoundedCrossfade {
  int first, second;               // positions in the model's clips
  std::vector<BoundedPart> parts;  // by part
};

struct ModelBounds {
  Skinning skinning;
  std::vector<ModelPart> parts;                    // the whole first, clusters last
  std::vector<BoundedClip> clips;                  // those of the model, in order
  RotationBlend rotations = RotationBlend::slerp;  // as crossfades blend them
  std::vector<BoundedCrossfade> crossfades;        // of each two clips; empty unless asked for
  // These bounds come by part, without the clusters, and are missing where bound_any_pose has none. The list is empty unless
  // asked for.
  std::vector<std::optional<AnyPoseBound>> any_pose;
  std::vector<BoundedPart> rest;        // by part: the joints where the file's nodes leave them without a clip
  std::vector<BoundedPart> rest_nodes;  // the same by node
  int dop = 6;                          // as in the options
  long moments = 0;                     // at which some part's vertices were skinned
};

struct ModelBoundsOptions {
  Skinning skinning = Skinning::linear;
  double tolerance = 0.01;      // as in OverTimeOptions
  int cluster_triangles = 128;  // of a cluster at most, a multiple of 4 from 4 to 512; 0 for no clusters
  int dop = 6;                  // k of the k-DOPs, of which boxes are a part: one of dop_sizes
  // These are the vertices of each node of a tree (NodeVertices), in increasing order. They are bounded in clips and in the rest
  // pose, too.
  std::vector<std::vector<int>> nodes = {};
  bool crossfades = false;  // bound what is between two clips, too
  double crossfade_tolerance = 0.2;
  RotationBlend rotations = RotationBlend::slerp;  // of crossfades
  bool any_pose = false;                           // bound what poses of code could do, too
  bool with_intervals = false;                     // keep the intervals of the clips' bounds
  // Bounds are wider by this share of the distance of a vertex's images by its joints from the scene's origin, because a renderer
  // skins in float and is off by as much. Where blended quaternions are short, they are wider by more (ErrorGrowth).
  double renderer_rounding = 0x1p-19;
  // This is called with the share that is done, from any thread, one call at a time.
  std::function<void(double)> progress = {};
};

// Returns the parts of a model. Its clusters are the meshlets of each source primitive's triangles. Throws std::invalid_argument
// for cluster_triangles out of range.
std::vector<ModelPart> parts_of(const Model& model, int cluster_triangles);

// Bounds the parts of a model, on all processors. Throws ModelError where there is no bound or floats do not hold it, and for a
// model without keys,
// std::invalid_argument for a k that is none of dop_sizes, and what parts_of throws.
ModelBounds bound_model(const Model& model, const ModelBoundsOptions& options = {});

// Returns the smallest k-DOP around all parts, of which there is at least one, and the smallest ball, rounded outward. All have
// the same k. The ball is all of space if it goes beyond the range of float, which bound_model refuses.
BoundedPart around(std::span<const BoundedPart> parts);

// Returns, by part, the bounds that hold in all clips, in the rest pose and in all crossfades that were asked for.
std::vector<BoundedPart> bounds_of_all(const ModelBounds& bounds);

// Returns the clusters for a file. Triangles are those of the file's primitives.
ClusterBounds clusters_of(const Model& model, const ModelBounds& bounds);

}  // namespace refitlab
