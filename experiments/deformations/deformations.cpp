// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/deformations.hpp"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "algorithms/program/guarded_load.hpp"
#include "algorithms/results/result_file.hpp"
#include "experiments/deformations/deformed_levels.hpp"
#include "experiments/deformations/deforming.hpp"
#include "experiments/deformations/deforming_man.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/skinning_name.hpp"

namespace refitlab {
namespace {

const char* const deforming_files[] = {"bear/scene.gltf", "raccoon/scene.gltf"};

// The variants of one skinning are side by side: the default one, the tightest one if there is a tighter one, and Algorithm 1
// repaired.
const std::vector<std::vector<std::string>> measured_variants = {
    {"linear_mixed"}, {"control_mixed", "control_many_pieces", "spherical_repaired"}, {"dual_quaternion_mixed"}};

void measure(const Character& c, const std::string& kind, const std::vector<DeformedPose>& poses, DeformationResult& result) {
  for (const auto& names : measured_variants) {
    std::vector<const RefitVariant*> variants;
    for (const std::string& name : names) variants.push_back(&refit_variant(name));
    auto levels = deformed_levels(c, variants, poses);
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const WorstLevel worst = worst_level(levels[v]);
      std::printf("  %-18s %-22s at most %.4f of the smallest (level %d), misses %ld\n", kind.c_str(), names[v].c_str(),
                  worst.ratio, worst.level, all_misses(levels[v]));
      result.measures.push_back({kind, names[v], variants[v]->skinning, static_cast<int>(poses.size()), std::move(levels[v])});
    }
    std::cout << std::flush;
  }
}

void measure_made_up(const Model& model, const std::vector<double>& shares, const DeformationSettings& settings,
                     DeformationResult& result) {
  const DeformingCharacters characters(model);
  for (const DeformationKind& kind : made_up_kinds)
    measure(characters.of(kind), kind.name, deformed_poses(characters.of(kind), kind, shares), result);
  result.costs = deformed_costs(characters, settings.speed);
  result.reduced = measure_reduced(model, settings.reduced);
  result.reduced_costs = reduced_costs(vibrating_character(model, settings.reduced), settings.speed);
}

class Rows {
 public:
  Rows(const std::string& model, ResultFile& file) : model_(model), file_(file) {}

  void add(const std::string& kind, const std::string& pose, const std::string& variant, const std::string& level,
           const char* quantity, double value, const char* unit = "1", const char* skinning = "all",
           const char* displacements = "smallest") {
    file_.add(
        {"deformations", model_, pose, variant, level, quantity, format_number(value), unit, skinning, kind, displacements});
  }

  void add(const std::string& kind, const std::string& variant, int poses, const std::vector<LevelTightness>& levels,
           const char* skinning, const char* displacements = "smallest") {
    const std::string pose = std::to_string(poses) + " poses";
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const std::string level = std::to_string(l + 1);
      const LevelTightness& t = levels[l];
      if (t.optimal_sum > 0)
        add(kind, pose, variant, level, "radius_ratio_to_optimal", t.ratio_to_optimal(), "1", skinning, displacements);
      add(kind, pose, variant, level, "nodes", static_cast<double>(t.nodes), "1", skinning, displacements);
      add(kind, pose, variant, level, "missed_balls", static_cast<double>(t.misses), "1", skinning, displacements);
    }
  }

 private:
  const std::string& model_;
  ResultFile& file_;
};

const char* table_name_of(DisplacementBalls balls) { return balls == DisplacementBalls::bd_tree ? "bd_tree" : "smallest"; }

void add_reduced(const ReducedResult& reduced, Rows& rows) {
  const bool is_skinned = reduced.kind == "vibration_skinned";
  rows.add(reduced.kind, "all", "basis", "all", "frames", reduced.frames);
  rows.add(reduced.kind, "all", "basis", "all", "basis_vectors", reduced.size);
  rows.add(reduced.kind, "all", "basis", "all", "share_of_squared_displacements", reduced.share);
  for (const ReducedMeasure& m : reduced.measures)
    rows.add(reduced.kind, m.variant, reduced.poses, m.levels, is_skinned ? table_name_of(Skinning::spherical) : "none",
             table_name_of(m.balls));
}

}  // namespace

Model load_deforming(const std::string& path) {
  Model model = load_model_guarded(path, {.joints = Joints::affine, .morphs = Morphs::moving});
  model.name = std::filesystem::path(path).filename().string();
  return model;
}

DeformingModels deforming_models(const std::string& folder) {
  DeformingModels out;
  out.models.push_back(make_deforming_man());
  for (const char* file : deforming_files) {
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    if (!std::filesystem::exists(path)) {
      out.absent.push_back(file);
      continue;
    }
    out.models.push_back(load_deforming(path.string()));
    out.models.back().name = path.parent_path().filename().string();
  }
  return out;
}

DeformationResult run_deformations(const Model& model, const DeformationSettings& settings) {
  const std::vector<double> shares = even_shares(settings.times_per_clip);
  DeformationResult result;
  result.model = model.name;
  result.joints = static_cast<long>(model.joints.size());
  result.targets = morph_targets(model).count;
  if (deforms_itself(model)) measure(bake_animated(model), "own", own_poses(model, shares), result);
  else if (!model.clips.empty()) measure_made_up(model, shares, settings, result);
  return result;
}

void write_deformations(const std::vector<DeformationResult>& results, const std::string& path) {
  ResultFile file(
      {"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "skinning", "kind", "displacements"});
  for (const DeformationResult& r : results) {
    Rows rows(r.model, file);
    rows.add("model", "all", "model", "all", "joints", static_cast<double>(r.joints));
    rows.add("model", "all", "model", "all", "morph_targets", static_cast<double>(r.targets));
    for (const DeformationMeasure& m : r.measures) rows.add(m.kind, m.variant, m.poses, m.levels, table_name_of(m.skinning));
    for (const DeformedCost& c : r.costs) {
      const auto add = [&](const char* quantity, double value, const char* unit) {
        rows.add(c.kind, "two of the first clip", c.variant, "all", quantity, value, unit,
                 table_name_of(refit_variant(c.variant).skinning));
      };
      add("ns_per_sphere", c.ns_per_sphere, "ns");
      add("time_ratio_to_rigid", c.to_rigid, "1");
      add("time_ratio_to_rigid_deformation_kept", c.to_rigid_kept, "1");
    }
    for (const ReducedResult& reduced : r.reduced) add_reduced(reduced, rows);
    for (const ReducedCost& c : r.reduced_costs) {
      rows.add("vibration", "first and last frame", c.variant, "all", "time_ratio_to_bd_tree", c.to_bd_tree, "1", "none",
               table_name_of(c.balls));
    }
  }
  file.write(path);
}

}  // namespace refitlab
