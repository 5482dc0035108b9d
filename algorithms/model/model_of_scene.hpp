// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that assimp read, as a model.
#pragma once

#include <assimp/scene.h>

#include <string>

#include "algorithms/model/model.hpp"

namespace refitlab {

// What later steps take for granted, assimp's own triangulation among them: meshes that are not empty, finite
// positions, indices in range, weights that are finite and not negative. Throws ModelError.
void check_scene(const aiScene& scene, const std::string& file);

// The model of a scene that check_scene let pass, by its triangles, as load_model says. file: for errors; the model's
// name.
Model model_of_scene(const aiScene& scene, const std::string& file);

}  // namespace refitlab
