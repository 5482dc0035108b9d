// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment on deformations measures refits of characters whose joints scale, or that have morph targets or a reduced
// deformation. It measures how tight they are, what they miss, and what they cost beside refits of rigid characters.
#pragma once

#include <string>
#include <vector>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "experiments/deformations/deformed_costs.hpp"
#include "experiments/deformations/reduced_measures.hpp"

namespace refitlab {

struct DeformationSettings {
  int times_per_clip = 3;  // in the middles of as many equal parts
  ReducedSettings reduced;
  SpeedSettings speed;
};

// A DeformationMeasure is that of one variant in all poses of a character that is deformed in one way.
struct DeformationMeasure {
  std::string kind, variant;
  Skinning skinning;
  int poses;
  std::vector<LevelTightness> levels;
};

struct DeformationResult {
  std::string model;
  long joints = 0, targets = 0;  // of the model itself
  std::vector<DeformationMeasure> measures;
  std::vector<DeformedCost> costs;
  std::vector<ReducedResult> reduced;
  std::vector<ReducedCost> reduced_costs;
};

// Returns the model of a file with its morph targets and joints that scale, as its clips have them. Throws what load_model
// throws.
Model load_deforming(const std::string& path);

// DeformingModels are the generated model that deforms itself, and the real ones found in a folder. absent names those that are
// not there.
struct DeformingModels {
  std::vector<Model> models;
  std::vector<std::string> absent;
};
DeformingModels deforming_models(const std::string& folder);

// A model that deforms itself is measured as its clips have it. A rigid model with clips is deformed in every made-up way, and
// one without clips has no rows. Progress goes to stdout.
DeformationResult run_deformations(const Model& model, const DeformationSettings& settings);

void write_deformations(const std::vector<DeformationResult>& results, const std::string& path);

}  // namespace refitlab
