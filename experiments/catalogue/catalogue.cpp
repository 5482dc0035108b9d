// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/catalogue.hpp"

#include <algorithm>

#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/verification/score.hpp"
#include "experiments/baselines/baselines.hpp"
#include "experiments/collisions/detectors.hpp"
#include "experiments/scenes/methods.hpp"
#include "experiments/scenes/skinning_name.hpp"
#include "experiments/tightness/measure.hpp"

namespace refitlab {
namespace {

const char* yes_no(bool value) { return value ? "yes" : "no"; }

struct Comparison {
  std::string name, role;
  Skinning skinning;
  std::string description;
};

// Returns what is measured but is no method.
const std::vector<Comparison>& comparisons() {
  static const std::vector<Comparison> all{
      {"reference", "reference", Skinning::spherical, ""},
      {"linear_under_spherical", "comparison", Skinning::spherical,
       "the linear refit's balls against spherically blended vertices"},
      {"bottom_up", "comparison", Skinning::spherical,
       "smallest balls of the deformed leaf vertices, then of the children [Brown et al. 2001]"},
      {"optimal", "optimal", Skinning::spherical, ""},
      {"optimal_linear", "optimal", Skinning::linear, ""},
      {"optimal_dual_quaternion", "optimal", Skinning::dual_quaternion, ""}};
  return all;
}

}  // namespace

void write_models(const DefaultModels& models, const std::vector<std::string>& packed, const std::string& path) {
  ResultFile file({"model", "found", "packed_file"});
  for (std::size_t i = 0; i < models.models.size(); ++i)
    file.add({models.models[i].name, "yes", packed.empty() ? "" : packed[i]});
  for (const std::string& absent : models.absent) file.add({absent, "no", ""});
  file.write(path);
}

void write_variants(const std::string& path) {
  ResultFile file({"variant", "role", "skinning", "sound", "default", "description"});
  for (const std::string& column : tightness_columns()) {
    const auto at =
        std::find_if(comparisons().begin(), comparisons().end(), [&](const Comparison& c) { return c.name == column; });
    if (at != comparisons().end()) {
      file.add({at->name, at->role, table_name_of(at->skinning), "yes", "no", at->description});
      continue;
    }
    const Method& c = method(column);
    const RefitVariant& v = *c.variant;
    file.add({c.name, "refit", table_name_of(v.skinning), yes_no(v.sound),
              yes_no(c.stands_alone() && v.name == default_variant(v.skinning).name), c.description});
  }
  file.write(path);
}

void write_detectors(const std::string& path) {
  ResultFile file({"detector", "origin", "found", "tolerated_share_of_pairs", "description"});
  for (const DetectorKind& kind : detector_kinds())
    file.add({kind.name, name_of(kind.origin), "yes", format_number(kind.tolerated_share), kind.description});
  for (const std::string& engine : absent_engines()) file.add({engine, "engine", "no", "0", ""});
  file.write(path);
}

void write_constants(const std::string& path) {
  ResultFile file({"constant", "value", "unit"});
  file.add({"miss_tolerance", format_number(miss_tolerance), "1"});
  file.add({"synthetic_tolerance", format_number(synthetic_tolerance), "size of the coordinates"});
  file.write(path);
}

}  // namespace refitlab
