// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue: what the report needs to know of a run as a whole: its models, variants, detectors and constants.
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// models.csv: a row a model of the run, then those that are absent. packed: for the explorer, the file of each model's bytes
// (experiments/explorer/packed_model.hpp), from the folder of the results, or empty; as many as models, or none.
void write_models(const DefaultModels& models, const std::vector<std::string>& packed, const std::string& path);

// variants.csv: what the tightness experiment measures, in the report's order. role: "refit" for a variant, "reference" for the
// balls of the reference pose, "optimal" for the smallest balls, "comparison" for the rest.
void write_variants(const std::string& path);

// detectors.csv: what finds touching triangles, in the report's order, and the engines that were not found.
void write_detectors(const std::string& path);

// constants.csv: the tolerances that the report names.
void write_constants(const std::string& path);

// The bytes of each model in a file of the folder, and its path from the folder's parent. Procedural models are not packed: the
// explorer makes them itself. Throws std::logic_error if what is unpacked is another model.
std::vector<std::string> pack_models(const std::vector<Model>& models, const std::string& folder);

}  // namespace refitlab
