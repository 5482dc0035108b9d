// experiments: the main job. Runs the experiments on the default models or on the user's own, and writes results and report.
#include <filesystem>
#include <iostream>

#include "algorithms/model/procedural.hpp"
#include "algorithms/results/write_whole.hpp"
#include "experiments/growth/characters.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/report/report.hpp"
#include "experiments/resume/resume.hpp"
#include "experiments/run_file.hpp"
#include "experiments/speed/balls.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"

namespace refitlab {
namespace {

void append(auto& all, const auto& results) { all.insert(all.end(), results.begin(), results.end()); }

// All that is wanted of one model.
void run_on(Model&& model, const Options& options, const RunFolder& run, Report& report) {
  std::cout << "== " << model.name << ": " << model.vertices.size() << " vertices, " << model.triangles.size() << " triangles, "
            << model.joints.size() << " joints, " << model.clips.size() << " clips" << std::endl;
  const std::string identity = identify(model), of_model = " of " + model.name;
  const Character character(std::move(model));
  const NamedPosture twist = figure_twist(character.model);
  if (report.pictures.empty())
    report.pictures = twist_pictures(character, twist.name, twist.posture, options.out + "/report/pictures");
  if (options.wants("tightness"))
    append(report.tightness, resumed_or(run, "tightness" + of_model, options.tightness, identity,
                                        [&] { return run_tightness(character, options.tightness); }));
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
  if (!parse(argc, argv, options)) return 0;
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
  for (Model& model : models.models) run_on(std::move(model), options, run, report);
  if (!models.models.empty()) write_results_by_model(options, report, result);
  // On one's own models these run only if they are asked for.
  if (options.files.empty() || !options.only.empty()) run_without_model(options, run, report, result);
  result.write();
  if (!options.explorer.empty()) report.explorer = read_whole(options.explorer);
  if (std::filesystem::exists(options.out + "/report/reference/index.html")) report.reference = "reference/index.html";
  write_report(report, options.out + "/report/index.html");
  std::cout << "results: " << options.out << "/results, report: " << options.out << "/report/index.html\n";
} catch (const std::exception& e) {
  std::cerr << "experiments: " << e.what() << '\n';
  return 1;
}
