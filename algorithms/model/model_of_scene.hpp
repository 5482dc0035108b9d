// SPDX-License-Identifier: GPL-3.0-or-later
// A scene becomes a model.
#pragma once

#include "algorithms/model/load_options.hpp"
#include "algorithms/model/model.hpp"
#include "algorithms/model/scene.hpp"

namespace refitlab {

// Returns the model as load_model says. It takes for granted that indices are in range, positions are finite, and weights are
// finite and not negative. The scene's file is the model's name. Throws the ModelErrors of load_model.
Model model_of_scene(const Scene& scene, const LoadOptions& options = {});

}  // namespace refitlab
