// experiments: the main job. Runs the experiments on the default models or on the user's own, and writes results and report.
#include <boost/program_options.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "algorithms/model/procedural.hpp"
#include "algorithms/results/result_file.hpp"
#include "experiments/certificates/certificates.hpp"
#include "experiments/collisions/collisions.hpp"
#include "experiments/growth/characters.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/queries/queries.hpp"
#include "experiments/report/report.hpp"
#include "experiments/resume/resume.hpp"
#include "experiments/rounding/rounding.hpp"
#include "experiments/speed/balls.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

namespace {

const char* const experiments[] = {"tightness", "speed", "volumes", "rounding", "collisions", "growth", "queries"};

struct Options {
  std::string effort = "default";
  std::vector<std::string> only, files;
  std::string models = "out/models", out = "out";
  refitlab::TightnessSettings tightness;
  refitlab::SpeedSettings speed;
  refitlab::VolumeSettings volumes;
  refitlab::RoundingSettings rounding;
  refitlab::CollisionSettings collisions{.frames = 6, .speed = {.seconds_per_run = 0.005, .repetitions = 3}};
  refitlab::TriangleGrowthSettings triangles{.speed = {.seconds_per_run = 0.01, .repetitions = 3}};
  refitlab::QuerySettings queries;
  bool anew = false;
  refitlab::CertificateRequest certificate;
  bool wants(const std::string& name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  }
};

// The files in out/results that a run wrote, and how long it measured: run.csv, which is there once a run is done.
class RunFile {
 public:
  explicit RunFile(const Options& options) : options_(options) { std::filesystem::remove(path()); }
  // The path of a result file of this run.
  std::string operator()(const std::string& name) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
    return options_.out + "/results/" + name;
  }
  void write() const {
    refitlab::ResultFile file({"file", "effort", "models"});
    for (const auto& name : names_) file.add({name, options_.effort, options_.files.empty() ? "default" : "own"});
    file.write(path());
  }

 private:
  std::string path() const { return options_.out + "/results/run.csv"; }
  const Options& options_;
  std::vector<std::string> names_;
};

// False if only help was asked for.
bool parse(int argc, char** argv, Options& o) {
  namespace po = boost::program_options;
  std::string names;
  for (const char* name : experiments) names += std::string(names.empty() ? "" : ", ") + name;
  po::options_description description("experiments: refit variants compared on skinned characters");
  description.add_options()("help", "this text")(
      "model", po::value(&o.files)->multitoken(), "rigged files of one's own, in place of the default models")(
      "only", po::value(&o.only)->multitoken(), ("experiments to run, of: " + names).c_str())(
      "quick", "few sampled times per clip, short timings: a smoke run")("full", "many sampled times per clip, long timings")(
      "anew", "run everything, also what an earlier run of this very program finished with the same options and models")(
      "models", po::value(&o.models), "folder of the real models")("out", po::value(&o.out), "folder for all that is generated")(
      "certificate", po::value(&o.certificate.file),
      "write why a refitted ball holds its vertices to this file, and do nothing else; of the model given, or the procedural man")(
      "node", po::value(&o.certificate.node), "of the certificate: in the sphere tree, 0 being its root")(
      "clip", po::value(&o.certificate.clip), "of the certificate: the first unless given")(
      "time", po::value(&o.certificate.seconds), "of the certificate: seconds into the clip")(
      "variant", po::value(&o.certificate.variant), "of the certificate: the refit variant, control_mixed unless given");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, description), map);
  po::notify(map);
  if (map.count("help")) return std::cout << description, false;
  o.anew = map.count("anew");
  for (const char* name : {"node", "clip", "time", "variant"})
    if (map.count(name) && !map.count("certificate")) throw po::error(std::string("--") + name + " is for --certificate");
  if (map.count("certificate") && o.certificate.file.empty()) throw po::error("--certificate takes a file to write");
  if (map.count("certificate") && o.files.size() > 1) throw po::error("--certificate is of one --model");
  if (map.count("quick") && map.count("full")) throw po::error("--quick and --full exclude each other");
  if (map.count("quick")) o.effort = "quick";
  if (map.count("full")) o.effort = "full";
  if (map.count("quick")) o.tightness.times_per_clip = 5, o.speed = {.seconds_per_run = 0.01, .repetitions = 3}, o.queries.count = 2000;
  if (map.count("full")) o.tightness.times_per_clip = 200, o.speed = {.seconds_per_run = 0.5, .repetitions = 15}, o.queries.count = 100000;
  if (map.count("quick")) o.volumes = {.times_per_clip = 2, .nodes_per_level = 32, .speed = o.speed};
  if (map.count("full")) o.volumes = {.times_per_clip = 50, .nodes_per_level = 256, .speed = o.speed};
  if (map.count("quick")) o.rounding = {.postures = 1, .speed = o.speed};
  if (map.count("full")) o.rounding = {.postures = 80, .vertices_per_node = 16, .speed = o.speed};
  if (map.count("quick")) o.collisions = {.frames = 2, .speed = {.seconds_per_run = 0.001, .repetitions = 1}, .first_model_only = true};
  if (map.count("full")) o.collisions = {.frames = 100, .speed = {.seconds_per_run = 0.2, .repetitions = 5}, .all_detectors = true};
  if (map.count("quick")) o.triangles = {.frames = 2, .speed = {.seconds_per_run = 0.001, .repetitions = 1}};
  if (map.count("full")) o.triangles = {.frames = 20, .up_to_a_million = true, .speed = {.seconds_per_run = 0.2, .repetitions = 5}};
  for (const auto& name : o.only)
    if (std::find(std::begin(experiments), std::end(experiments), name) == std::end(experiments))
      throw po::error("--only " + name + ": no such experiment; there are: " + names);
  return true;
}

void append(auto& all, const auto& results) { all.insert(all.end(), results.begin(), results.end()); }

// All that is wanted of one model.
void run_on(refitlab::Model&& model, const Options& options, const refitlab::RunFolder& run, refitlab::Report& report) {
  using namespace refitlab;
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
void write_results_by_model(const Options& options, const refitlab::Report& report, RunFile& result) {
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
void run_without_model(const Options& options, const refitlab::RunFolder& run, refitlab::Report& report, RunFile& result) {
  using namespace refitlab;
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
  write_report(report, options.out + "/report/index.html");
  std::cout << "results: " << options.out << "/results, report: " << options.out << "/report/index.html\n";
} catch (const std::exception& e) {
  std::cerr << "experiments: " << e.what() << '\n';
  return 1;
}
