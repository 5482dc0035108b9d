// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds over time as the `extras` of a glTF file's skins, meshes, primitives and animations, for readers that know nothing of
// refitlab; extras.schema.json says what is in them.
#pragma once

#include <string>

#include "algorithms/bake/over_time/model_bounds.hpp"

namespace refitlab {

// The JSON text of a file with the bounds added. Skins, meshes and primitives get what holds in all clips and in the rest pose,
// animations what holds in them. Every other byte stays. Where extras of refitlab are there already, they are replaced.
// file: for errors. Throws ModelError for extras that are no object.
std::string with_extras(const std::string& json, const Model& model, const ModelBounds& bounds, double tolerance,
                        const std::string& file);

}  // namespace refitlab
