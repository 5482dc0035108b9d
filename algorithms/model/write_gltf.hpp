// SPDX-License-Identifier: GPL-3.0-or-later
// Models are written as glTF 2.0 files.
#pragma once

#include <string>

#include "algorithms/model/model.hpp"

namespace refitlab {

// Returns the .glb file of a model whose clips are animations of its skeleton, which is a model from a file or a keyed one. It
// has one mesh of one primitive, whose vertices and triangles are in the order of the model, one skin with the model's joints,
// and all clips. Numbers are rounded to single precision; weights are not.
// Throws ModelError that names the model and the reason. The reasons are no skeleton, morph targets, more joints than glTF can
// name, and a node that a clip moves but whose rest is no translation, rotation and scale.
std::string gltf_bytes(const Model& model);

// Writes the same to a file. Also throws ModelError for a file that cannot be written.
void write_gltf(const Model& model, const std::string& path);

}  // namespace refitlab
