// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds over time become the `extras` of a glTF file's skins, meshes, primitives and animations, for readers that know nothing
// of refitlab. extras.schema.json says what is in them.
#pragma once

#include <string>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

// Returns the JSON text of a file with the bounds added. Skins, meshes and primitives get bounds for all clips and the rest pose,
// and animations get their own. options are those with which the bounds were made. Every other byte stays. Existing extras of
// refitlab are replaced, or removed where there is no bound. file is for error messages. Throws ModelError for extras that are no
// object.
std::string with_extras(const std::string& json, const Model& model, const ModelBounds& bounds, const ModelBoundsOptions& options,
                        const std::string& file);

}  // namespace refitlab
