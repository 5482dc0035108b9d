// SPDX-License-Identifier: GPL-3.0-or-later
// The animations of a glTF file become clips here.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/gltf_nodes.hpp"
#include "algorithms/model/gltf_numbers.hpp"

namespace refitlab {

// Returns all clips, each from 0 to the latest of its keys. A part of a node that no channel moves stays as the node has it.
// Throws ModelError that names the clip, the node, the key and the reason. The reasons are a key that is not finite, out of
// order, or a zero rotation; a rotation of a spline that is not of unit length; a sampler without keys, with fewer values than it
// needs, or of an unknown interpolation; two channels of one part of a node. Notes get a sentence for each clip whose rotations
// are not of unit length.
std::vector<Animation> convert_animations(const tinygltf::Model& source, const GltfNodes& nodes, const GltfNumbers& numbers,
                                          const std::string& file, std::vector<std::string>& notes);

}  // namespace refitlab
