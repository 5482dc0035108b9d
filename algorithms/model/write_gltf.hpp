// SPDX-License-Identifier: GPL-3.0-or-later
// Models as glTF 2.0 files.
#pragma once

#include <string>

#include "algorithms/model/model.hpp"

namespace refitlab {

// The .glb file of a model whose clips are animations of its skeleton: of one from a file, or of a keyed one. It has one mesh
// of one primitive, whose vertices and triangles are in the order of the model, one skin with the model's joints, and all
// clips. Numbers are rounded to single precision; weights are not.
// Throws ModelError that names the model and the reason: no skeleton, morph targets, more joints than glTF can name, a
// node that a clip moves but whose rest is no translation, rotation and scale.
std::string gltf_bytes(const Model& model);

// The same in a file. Throws ModelError for one that cannot be written, too.
void write_gltf(const Model& model, const std::string& path);

}  // namespace refitlab
