// experiments: the main job. Runs the experiments on the default models or on the user's own, and writes results and report.
#include <filesystem>
#include <future>
#include <iostream>

#include "algorithms/model/procedural.hpp"
#include "algorithms/results/write_whole.hpp"
#include "experiments/growth/characters.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/report/cap_figure.hpp"
#include "experiments/report/encounter_figures.hpp"
#include "experiments/report/failing_figure.hpp"
#include "experiments/report/packed_models.hpp"
#include "experiments/report/report.hpp"
#include "experiments/report/twist_figures.hpp"
#include "experiments/resume/resume.hpp"
#include "experiments/run_file.hpp"
#include "experiments/speed/balls.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/tightness/worst_twist.hpp"

namespace refitlab {
namespace {

void append(auto& all, const auto& results) { all.insert(all.end(), results.begin(), results.end()); }

// The figures of a model: of the first all but one, and the walk through each other of the second, or of the only one.
void add_figures(const Character& character, const NamedPosture& twist, const std::shared_future<NamedPosture>& worst,
                 std::size_t index, std::size_t models, const std::string& folder, std::vector<Figure>& figures) {
  if (index == 0) {
    append(figures, twist_figures(character, twist, folder));
    figures.push_back(failing_figure(character, worst.get(), folder));
    figures.push_back(cap_figure(folder));
    figures.push_back(walking_figure(character, folder));
  }
  if (index == std::min<std::size_t>(1, models - 1)) figures.push_back(walk_through_figure(character, folder));
}

// All that is wanted of one model, which is number index of so many.
void run_on(Model&& model, std::size_t index, std::size_t models, const Options& options, const RunFolder& run, Report& report) {
  std::cout << "== " << model.name << ": " << model.vertices.size() << " vertices, " << model.triangles.size() << " triangles, "
            << model.joints.size() << " joints, " << model.clips.size() << " clips" << std::endl;
  const std::string identity = identify(model), of_model = " of " + model.name;
  const Character character(std::move(model));
  const NamedPosture twist = figure_twist(character.model);
  // Seconds of work: done when first asked for, which a resumed run may never do.
  const auto worst = std::async(std::launch::deferred, worst_twist, std::cref(character)).share();
  add_figures(character, twist, worst, index, models, options.out + "/report/pictures", report.figures);
  if (options.wants("tightness"))
    append(report.tightness, resumed_or(run, "tightness" + of_model, options.tightness, identity, [&] {
             return run_tightness(character, {twist, worst.get()}, options.tightness);
           }));
  if (options.wants("speed")) {
    append(report.speed, resumed_or(run, "speed" + of_model, options.speed, identity,
                                    [&] { return run_speed(character, twist, options.speed); }));
    append(report.batches, resumed_or(run, "batch speed" + of_model, options.speed, identity,
                                      [&] { return run_batch_speed(character, twist, options.speed); }));
  }
  if (options.wants("volumes")) {
    const VolumeResults results = resumed_or(run, "volumes" + of_model, options.volumes, identity, [&] {
      VolumeResults of_this;
      run_volumes(character, twist, options.volumes, of_this);
      return of_this;
    });
    append(report.volumes.tightness, results.tightness);
    append(report.volumes.costs, results.costs);
  }
  if (options.wants("rounding"))
    append(report.rounding, resumed_or(run, "rounding" + of_model, options.rounding, identity,
                                       [&] { return run_rounding(character, twist, options.rounding); }));
  if (options.wants("collisions") && !(options.collisions.first_model_only && !report.collisions.empty()))
    append(report.collisions, resumed_or(run, "collisions" + of_model, options.collisions, identity,
                                         [&] { return run_collisions(character, options.collisions); }));
}

// Each file once all of its rows are there: until then the one of the last whole run stays.
void write_results_by_model(const Options& options, const Report& report, RunFile& result) {
  if (options.wants("tightness")) write_tightness(report.tightness, result("tightness.csv"));
  if (options.wants("speed")) {
    write_speed(report.speed, result("speed.csv"));
    write_batch_speed(report.batches, result("batch_speed.csv"));
  }
  if (options.wants("volumes")) write_volumes(report.volumes, result("volumes.csv"));
  if (options.wants("rounding")) write_rounding(report.rounding, options.rounding, result("rounding.csv"));
  if (options.wants("collisions")) write_collisions(report.collisions, result("collision.csv"));
}

// What has nothing to do with a model.
void run_without_model(const Options& options, const RunFolder& run, Report& report, RunFile& result) {
  if (options.wants("growth")) {
    const SpeedSettings speed{options.speed.seconds_per_run / 5, options.speed.repetitions};
    report.joint_growth =
        resumed_or(run, "growth with the joints", speed, "", [&] { return run_joint_growth(speed); });
    write_joint_growth(report.joint_growth, result("joint_growth.csv"));
    report.character_growth =
        resumed_or(run, "growth with the characters", speed, "", [&] { return run_character_growth(speed); });
    write_character_growth(report.character_growth, result("character_growth.csv"));
    report.triangle_growth = resumed_or(run, "growth with the triangles", options.triangles, "",
                                        [&] { return run_triangle_growth(options.triangles); });
    write_triangle_growth(report.triangle_growth, result("triangle_growth.csv"));
  }
  if (options.wants("speed"))
    write_ball_speed(resumed_or(run, "ball speed", options.speed, "", [&] { return run_ball_speed(options.speed); }),
                     result("ball_speed.csv"));
  if (options.wants("queries")) {
    report.queries = resumed_or(run, "queries", options.queries, "", [&] { return run_queries(options.queries); });
    write_queries(report.queries, options.queries, options.out + "/results");
  }
}

}  // namespace
}  // namespace refitlab

int main(int argc, char** argv) try {
  using namespace refitlab;
  Options options;
  if (!parse(argc, argv, options) || options.check_only) return 0;
  if (!options.certificate.file.empty()) {
    write_certificate(options.certificate, options.files.empty() ? make_man() : load_named(options.files[0]));
    return 0;
  }

  DefaultModels models;
  const bool wants_models = options.wants("tightness") || options.wants("speed") || options.wants("volumes") || options.wants("rounding") ||
                            options.wants("collisions");
  if (options.files.empty() && wants_models)
    models = default_models(options.models);
  else
    for (const auto& file : options.files) models.models.push_back(load_named(file));
  for (const auto& absent : models.absent) std::cout << "absent: " << absent << " (could not be fetched; the run goes on)\n";

  const RunFolder run(options.out + "/units", options.anew);
  RunFile result(options);
  Report report;
  report.absent_models = models.absent;
  report.verdicts = options.out + "/results/verdicts.csv";
  PackedModels packed;
  if (!options.explorer.empty())
    for (const Model& model : models.models) packed.add(model);
  for (std::size_t i = 0; i < models.models.size(); ++i)
    run_on(std::move(models.models[i]), i, models.models.size(), options, run, report);
  if (report.figures.empty()) report.figures.push_back(cap_figure(options.out + "/report/pictures"));
  if (!models.models.empty()) write_results_by_model(options, report, result);
  // On one's own models these run only if they are asked for.
  if (options.files.empty() || !options.only.empty()) run_without_model(options, run, report, result);
  result.write();
  if (!options.explorer.empty()) report.explorer = packed.html() + read_whole(options.explorer);
  if (std::filesystem::exists(options.out + "/report/reference/index.html")) report.reference = "reference";
  write_report(report, options.out + "/report/index.html");
  std::cout << "results: " << options.out << "/results, report: " << options.out << "/report/index.html\n";
} catch (const std::exception& e) {
  std::cerr << "experiments: " << e.what() << '\n';
  return 1;
}
