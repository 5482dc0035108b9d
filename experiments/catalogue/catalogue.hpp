// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue is what the report needs to know of a run as a whole: its models, variants, detectors and constants.
#pragma once

#include <string>
#include <vector>

#include "experiments/scenes/scenes.hpp"

namespace refitlab {

// Writes models.csv, which has a row for each model of the run, and then those that are absent. packed is for the explorer, and
// becomes the column packed_file. It has the file of each model's bytes (experiments/explorer/packed_model.hpp), relative to the
// folder of the results, or an empty string. There are as many as models, or none.
void write_models(const DefaultModels& models, const std::vector<std::string>& packed, const std::string& path);

// Writes variants.csv, which lists what the tightness experiment measures, in the report's order. The role is "refit" for a
// variant, "reference" for the balls of the reference pose, "optimal" for the smallest balls, and "comparison" for the rest.
void write_variants(const std::string& path);

// Writes detectors.csv, which lists the detectors in the report's order, and the engines that were not found.
void write_detectors(const std::string& path);

// Writes constants.csv, which has the tolerances that the report names.
void write_constants(const std::string& path);

// Writes the bytes of each model to a file of the folder, and returns its path from the folder's parent. Procedural models are
// not packed: the explorer makes them itself. Throws std::logic_error if the unpacked model is a different one.
std::vector<std::string> pack_models(const std::vector<Model>& models, const std::string& folder);

}  // namespace refitlab
