// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as a model.
#pragma once

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/model.hpp"
#include "algorithms/model/scene.hpp"

namespace refitlab {

// As load_model says. Takes for granted that indices are in range, positions finite, and weights finite and not negative.
// The scene's file is the model's name. Throws ModelError.
Model model_of_scene(const Scene& scene, const LoadOptions& options = {});

}  // namespace refitlab
