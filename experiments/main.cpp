// SPDX-License-Identifier: GPL-3.0-or-later
// The program `experiments` is what experiments/run builds and runs. It measures the default models or the user's own, and writes
// tables and pictures.
#include <functional>
#include <future>
#include <iostream>
#include <set>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/deformations/deformations.hpp"
#include "experiments/engines/engines.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/over_time/crossfades.hpp"
#include "experiments/over_time/growth.hpp"
#include "experiments/over_time/over_time.hpp"
#include "experiments/pictures/cap_figure.hpp"
#include "experiments/pictures/engine_boxes_figure.hpp"
#include "experiments/pictures/failing_figure.hpp"
#include "experiments/pictures/sampled_miss_figure.hpp"
#include "experiments/pictures/scenario_figures.hpp"
#include "experiments/pictures/twist_figures.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/resume/resume.hpp"
#include "experiments/run_file.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/tightness/worst_twist.hpp"

namespace refitlab {
namespace {

void append(auto& all, const auto& results) { all.insert(all.end(), results.begin(), results.end()); }

// ModelResults are the measurements of the models.
struct ModelResults {
  std::vector<TightnessResult> tightness;
  std::vector<SpeedResult> speed;
  std::vector<BatchSpeed> batches;
  VolumeResults volumes;
  std::vector<RoundingResult> rounding;
  std::vector<CollisionResult> collisions;
  std::vector<OverTimeResult> over_time;
  std::vector<CrossfadesResult> crossfades;
  std::vector<EngineResult> engines;
  std::vector<DeformationResult> deformations;
};

// Draws the pictures of a model. The first model gets all but one. The second, or the only one, gets the walk through each other.
void draw_pictures(const AnimatedCharacter& character, const NamedPose& twist, const std::shared_future<NamedPose>& worst,
                   std::size_t index, std::size_t models, PictureTable& pictures) {
  if (index == 0) {
    draw_twist(character, twist, pictures);
    draw_failing(character, worst.get(), pictures);
    draw_caps(pictures);
    draw_walking(character, pictures);
  }
  if (index == std::min<std::size_t>(1, models - 1)) draw_walk_through(character, pictures);
}

// Runs all wanted experiments on one model, which is number index of so many.
void run_on(Model&& model, std::size_t index, std::size_t models, const Options& options, Units& run, PictureTable& pictures,
            ModelResults& results) {
  std::cout << "== " << model.name << ": " << model.vertices.size() << " vertices, " << model.triangles.size() << " triangles, "
            << model.joints.size() << " joints, " << model.clips.size() << " clips" << std::endl;
  const std::string identity = identify(model), of_model = " of " + model.name;
  const auto character = bake_animated(std::move(model));
  const NamedPose twist = figure_twist(character);
  // This takes seconds, so it is done when it is first asked for, which a resumed run may never do.
  const auto worst = std::async(std::launch::deferred, worst_twist, std::cref(character)).share();
  draw_pictures(character, twist, worst, index, models, pictures);
  if (options.wants("tightness"))
    append(results.tightness, resumed_or(run, "tightness" + of_model, options.tightness, identity, [&] {
             return run_tightness(character, {twist, worst.get()}, options.tightness);
           }));
  if (options.wants("speed")) {
    append(results.speed, resumed_or(run, "speed" + of_model, options.speed, identity,
                                     [&] { return run_speed(character, twist, options.speed); }));
    append(results.batches, resumed_or(run, "batch speed" + of_model, options.speed, identity,
                                       [&] { return run_batch_speed(character, twist, options.speed); }));
  }
  if (options.wants("volumes")) {
    const VolumeResults volumes = resumed_or(run, "volumes" + of_model, options.volumes, identity, [&] {
      VolumeResults of_this;
      run_volumes(character, twist, options.volumes, of_this);
      return of_this;
    });
    append(results.volumes.tightness, volumes.tightness);
    append(results.volumes.costs, volumes.costs);
  }
  if (options.wants("rounding"))
    append(results.rounding, resumed_or(run, "rounding" + of_model, options.rounding, identity,
                                        [&] { return run_rounding(character, twist, options.rounding); }));
  if (options.wants("collisions") && !(options.collisions.first_model_only && !results.collisions.empty()))
    append(results.collisions, resumed_or(run, "collisions" + of_model, options.collisions, identity,
                                          [&] { return run_collisions(character, options.collisions); }));
}

// Runs the experiments that need all of the models at once.
void run_over_time_on(const std::vector<Model>& models, const Options& options, Units& run, PictureTable& pictures,
                      ModelResults& results) {
  if (!options.wants("over_time")) return;
  for (const Model& model : models) {
    append(results.over_time, resumed_or(run, "bounds over time of " + model.name, options.over_time, identify(model),
                                         [&] { return run_over_time(model, options.over_time); }));
    append(results.crossfades, resumed_or(run, "crossfades of " + model.name, options.crossfades, identify(model),
                                          [&] { return run_crossfades(model, options.crossfades); }));
  }
  draw_sampled_miss(models, results.over_time, pictures);
}

void run_engines_on(const std::vector<Model>& models, const Options& options, Units& run, PictureTable& pictures,
                    ModelResults& results) {
  if (!options.wants("engines")) return;
  for (const Model& model : models)
    results.engines.push_back(resumed_or(run, "engines' bounds of " + model.name, options.engines, identify(model),
                                         [&] { return run_engines(model, options.engines); }));
  if (!models.empty()) draw_engine_boxes(models[0], pictures);
}

void run_deformations_on(const std::vector<Model>& models, const Options& options, Units& run, ModelResults& results) {
  if (!options.wants("deformations")) return;
  for (const Model& model : models)
    results.deformations.push_back(resumed_or(run, "deformations of " + model.name, options.deformations, identify(model),
                                              [&] { return run_deformations(model, options.deformations); }));
}

// Writes the files of the experiments on rigid models, each once all of its rows are there. Until then the file of the last whole
// run stays.
void write_results_by_model(const Options& options, const ModelResults& results, RunFile& result) {
  if (options.wants("tightness")) write_tightness(results.tightness, result("tightness.csv"));
  if (options.wants("speed")) {
    write_speed(results.speed, result("speed.csv"));
    write_batch_speed(results.batches, result("batch_speed.csv"));
  }
  if (options.wants("volumes")) write_volumes(results.volumes, result("volumes.csv"));
  if (options.wants("rounding")) write_rounding(results.rounding, options.rounding, result("rounding.csv"));
  if (options.wants("collisions")) write_collisions(results.collisions, result("collisions.csv"));
  if (options.wants("over_time")) {
    write_over_time(results.over_time, options.over_time, result("over_time.csv"));
    write_crossfades(results.crossfades, result("crossfades.csv"));
  }
  if (options.wants("engines")) write_engines(results.engines, result("engines.csv"));
}

// RunModels are the models of a run. Only the experiment on deformations takes those that deform.
struct RunModels {
  DefaultModels rigid;
  std::vector<Model> deforming;
};

// Keeps the characters that are wanted. Throws std::invalid_argument if a name is that of no model.
void keep_wanted_characters(const Options& options, RunModels& models) {
  std::set<std::string> names{no_character};
  for (std::vector<Model>* some : {&models.rigid.models, &models.deforming}) {
    for (const Model& model : *some) names.insert(model.name);
    std::erase_if(*some, [&](const Model& model) { return !options.wants_character(model.name); });
  }
  for (const std::string& name : options.characters)
    if (!names.contains(name)) {
      std::string all;
      for (const std::string& known : names) all += (all.empty() ? "" : ", ") + known;
      throw std::invalid_argument("--character " + name + ": these experiments have no such character; there are: " + all);
    }
}

RunModels load_models(const Options& options) {
  RunModels out;
  const bool is_of_deformations = options.only == std::vector<std::string>{"deformations"};
  for (const std::string& file : options.files)
    if (is_of_deformations) out.deforming.push_back(load_deforming(file));
    else out.rigid.models.push_back(load_named(file));
  if (!options.files.empty()) return out;
  if (options.wants_models()) out.rigid = default_models(options.models);
  if (options.wants("deformations")) {
    DeformingModels deforming = deforming_models(options.models);
    out.deforming = std::move(deforming.models);
    append(out.rigid.absent, deforming.absent);
  }
  keep_wanted_characters(options, out);
  return out;
}

// Runs the experiments, or parts of them, that have nothing to do with a model.
void run_without_model(const Options& options, Units& run, RunFile& result) {
  if (options.wants("growth")) {
    const SpeedSettings speed{options.speed.seconds_per_run / 5, options.speed.repetitions};
    write_joint_growth(resumed_or(run, "growth with the joints", speed, "", [&] { return run_joint_growth(speed); }),
                       result("joint_growth.csv"));
    write_triangle_growth(resumed_or(run, "growth with the triangles", options.triangles, "",
                                     [&] { return run_triangle_growth(options.triangles); }),
                          result("triangle_growth.csv"));
  }
  if (options.wants("crowds"))
    write_crowds(resumed_or(run, "crowds", options.crowds, "", [&] { return run_crowds(options.crowds); }), result("crowds.csv"));
  if (options.wants("synthetic"))
    write_synthetic(resumed_or(run, "synthetic", options.synthetic, "", [&] { return run_synthetic(options.synthetic); }),
                    options.synthetic, result("synthetic.csv"));
  if (options.wants("over_time"))
    write_over_time_growth(resumed_or(run, "growth of bounds over time", options.over_time_growth, identify_baking_program(),
                                      [&] { return run_over_time_growth(options.over_time_growth); }),
                           result("over_time_growth.csv"));
}

// Prints a line for each experiment and character that may run by itself, with --only and --character.
void list_parts(const Options& options, const RunModels& models) {
  const auto list = [&](const char* experiment, const std::string& character) {
    if (options.wants(experiment)) std::cout << experiment << '\t' << character << '\n';
  };
  for (std::size_t i = 0; i < models.rigid.models.size(); ++i)
    for (const char* experiment : experiments_on_models)
      if (i == 0 || std::string(experiment) != "collisions" || !options.collisions.first_model_only)
        list(experiment, models.rigid.models[i].name);
  for (const Model& model : models.deforming) list("deformations", model.name);
  if (options.wants_no_character())
    for (const char* experiment : experiments_without_model) list(experiment, no_character);
}

// Returns how often resumed_or will be called, which is once for collisions with the first model only. deforming is the number of
// the models that are for deformations alone.
std::size_t unit_count(const Options& options, std::size_t models, std::size_t deforming) {
  const auto count = [&](const char* name, std::size_t units) { return options.wants(name) ? units : 0; };
  const std::size_t with_collisions = options.collisions.first_model_only ? std::min<std::size_t>(models, 1) : models;
  std::size_t units = count("tightness", models) + count("speed", 2 * models) + count("volumes", models) +
                      count("rounding", models) + count("collisions", with_collisions) + count("over_time", 2 * models) +
                      count("engines", models) + count("deformations", models + deforming);
  if (options.wants_no_character())
    units += count("growth", 2) + count("crowds", 1) + count("synthetic", 1) + count("over_time", 1);
  return units;
}

// Writes what the report needs to know of the run as a whole.
void write_catalogue(const Options& options, const DefaultModels& models, RunFile& result) {
  const auto packed =
      options.packs_models ? pack_models(models.models, options.out + "/results/models") : std::vector<std::string>{};
  write_models(models, packed, result("models.csv"));
  write_variants(result("variants.csv"));
  write_detectors(result("detectors.csv"));
  write_constants(result("constants.csv"));
}

}  // namespace
}  // namespace refitlab

int main(int argc, char** argv) try {
  using namespace refitlab;
  Options options;
  if (!parse(argc, argv, options) || options.check_only) return 0;
  if (!options.certificate.file.empty()) {
    write_certificate(options.certificate, options.files.empty() ? make_man() : load_named(options.files[0], certified_models));
    return 0;
  }

  RunModels run_models = load_models(options);
  if (options.lists_parts) {
    list_parts(options, run_models);
    return 0;
  }
  auto& [models, deforming] = run_models;
  for (const auto& absent : models.absent) std::cout << "absent: " << absent << " (could not be fetched; the run goes on)\n";

  const RunFolder folder(options.out + "/units", options.anew);
  Units run(folder, unit_count(options, models.models.size(), deforming.size()));
  RunFile result(options);
  write_catalogue(options, models, result);
  PictureTable pictures(options.out + "/report/pictures", options.picture_size);
  ModelResults results;
  run_over_time_on(models.models, options, run, pictures, results);
  run_engines_on(models.models, options, run, pictures, results);
  run_deformations_on(models.models, options, run, results);
  run_deformations_on(deforming, options, run, results);
  for (std::size_t i = 0; i < models.models.size(); ++i)
    run_on(std::move(models.models[i]), i, models.models.size(), options, run, pictures, results);
  if (pictures.empty()) draw_caps(pictures);
  pictures.write(std::ref(result));
  if (!models.models.empty()) write_results_by_model(options, results, result);
  if (!results.deformations.empty()) write_deformations(results.deformations, result("deformations.csv"));
  if (options.wants_no_character()) run_without_model(options, run, result);
  result.write();
  std::cout << "results: " << options.out << "/results\n";
} catch (const std::exception& e) {
  std::cerr << "experiments: " << e.what() << '\n';
  return 1;
}
