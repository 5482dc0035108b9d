// SPDX-License-Identifier: GPL-3.0-or-later
// Rigged models are loaded from glTF 2.0 files, and from FBX, X, Collada and whatever else assimp 5.2 reads with bones.
#pragma once

#include <string>

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns the model in a file. glTF is read by gltf_scene, and anything else by assimp_scene, which loses the morph targets.
//
// All meshes become one skin, in the pose that the first skinned mesh rests in (see mesh_binding.hpp), with the
// constant scale of the skin matrices multiplied in (and, where all of them mirror, mirrored in x). Polygons are
// triangulated; vertices of equal position, equal weights and equal displacements become one, whatever their normals,
// texture coordinates and colours, so that seams do not split the skin. Points and lines, triangles with two equal
// vertices, and vertices without a triangle are dropped. The triangles stay in the order of the file: node by node, depth first;
// Model::sources says where each comes from.
//
// All influences are kept, as quantize_weights rounds them. Joints are the nodes of all bones, weighted or not, and of
// meshes without bones. Clips are all animations of the file. Each is checked at its key times (see max_checked_times) for being
// rotations with the constant scale. A file that does not say so has 25 ticks a second. The options say what is accepted besides.
//
// Throws ModelError that names the file, the thing and the reason. The reasons are a file that is missing or no model, no skin,
// an empty mesh, a number that is not finite, a weight that is negative, a vertex without weight, a joint or vertex index out of
// range, weights whose sum says that some got lost, skin matrices that shear, or scale or mirror by different factors, and
// weights of morph targets that move.
Model load_model(const std::string& path, const LoadOptions& options = {});

// A clip is checked on loading at this many times, evenly chosen among its keys' times if there are more.
inline constexpr int max_checked_times = 256;

// If the sum of a vertex's weights is outside of these, some of its weights are taken to be lost.
inline constexpr double least_weight_sum = 0.9, greatest_weight_sum = 1.1;

}  // namespace refitlab
