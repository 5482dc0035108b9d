// experiments: the main job. Runs the experiments on the default models or on the user's own, and writes results and report.
#include <boost/program_options.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "experiments/collisions/collisions.hpp"
#include "experiments/growth/characters.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/queries/queries.hpp"
#include "experiments/report/report.hpp"
#include "experiments/speed/balls.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

namespace {

const char* const experiments[] = {"tightness", "speed", "volumes", "collisions", "growth", "queries"};

struct Options {
  std::vector<std::string> only, files;
  std::string models = "out/models", out = "out", explorer;
  refitlab::TightnessSettings tightness;
  refitlab::SpeedSettings speed;
  refitlab::VolumeSettings volumes;
  refitlab::CollisionSettings collisions{.frames = 6, .speed = {.seconds_per_run = 0.005, .repetitions = 3}};
  refitlab::TriangleGrowthSettings triangles{.speed = {.seconds_per_run = 0.01, .repetitions = 3}};
  refitlab::QuerySettings queries;
  bool wants(const std::string& name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  }
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
      "models", po::value(&o.models), "folder of the real models")("out", po::value(&o.out), "folder for all that is generated")(
      "explorer", po::value(&o.explorer), "HTML to put into the report (of experiments/explorer/build)");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, description), map);
  po::notify(map);
  if (map.count("help")) return std::cout << description, false;
  if (map.count("quick") && map.count("full")) throw po::error("--quick and --full exclude each other");
  if (map.count("quick")) o.tightness.times_per_clip = 5, o.speed = {.seconds_per_run = 0.01, .repetitions = 3}, o.queries.count = 2000;
  if (map.count("full")) o.tightness.times_per_clip = 200, o.speed = {.seconds_per_run = 0.5, .repetitions = 15}, o.queries.count = 100000;
  if (map.count("quick")) o.volumes = {.times_per_clip = 2, .nodes_per_level = 32, .speed = o.speed};
  if (map.count("full")) o.volumes = {.times_per_clip = 50, .nodes_per_level = 256, .speed = o.speed};
  if (map.count("quick")) o.collisions = {.frames = 2, .speed = {.seconds_per_run = 0.001, .repetitions = 1}, .first_model_only = true};
  if (map.count("full")) o.collisions = {.frames = 100, .speed = {.seconds_per_run = 0.2, .repetitions = 5}, .all_detectors = true};
  if (map.count("quick")) o.triangles = {.frames = 2, .speed = {.seconds_per_run = 0.001, .repetitions = 1}};
  if (map.count("full")) o.triangles = {.frames = 20, .up_to_a_million = true, .speed = {.seconds_per_run = 0.2, .repetitions = 5}};
  for (const auto& name : o.only)
    if (std::find(std::begin(experiments), std::end(experiments), name) == std::end(experiments))
      throw po::error("--only " + name + ": no such experiment; there are: " + names);
  return true;
}

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace refitlab;
  Options options;
  if (!parse(argc, argv, options)) return 0;

  DefaultModels models;
  const bool wants_models = options.wants("tightness") || options.wants("speed") || options.wants("volumes") || options.wants("collisions");
  if (options.files.empty() && wants_models)
    models = default_models(options.models);
  else
    for (const auto& file : options.files) models.models.push_back(load_named(file));
  for (const auto& absent : models.absent) std::cout << "absent: " << absent << " (could not be fetched; the run goes on)\n";

  Report report;
  report.absent_models = models.absent;
  if (!options.explorer.empty()) report.explorer = read_text(options.explorer);
  for (Model& model : models.models) {
    std::cout << "== " << model.name << ": " << model.vertices.size() << " vertices, " << model.triangles.size() << " triangles, "
              << model.joints.size() << " joints, " << model.clips.size() << " clips" << std::endl;
    const Character character(std::move(model));
    const NamedPosture twist = figure_twist(character.model);
    if (report.pictures.empty())
      report.pictures = twist_pictures(character, twist.name, twist.posture, options.out + "/report/pictures");
    if (options.wants("tightness")) {
      const auto results = run_tightness(character, options.tightness);
      report.tightness.insert(report.tightness.end(), results.begin(), results.end());
      write_tightness(report.tightness, options.out + "/results/tightness.csv");
    }
    if (options.wants("speed")) {
      const auto results = run_speed(character, twist, options.speed);
      report.speed.insert(report.speed.end(), results.begin(), results.end());
      write_speed(report.speed, options.out + "/results/speed.csv");
      const auto batches = run_batch_speed(character, twist, options.speed);
      report.batches.insert(report.batches.end(), batches.begin(), batches.end());
      write_batch_speed(report.batches, options.out + "/results/batch_speed.csv");
    }
    if (options.wants("volumes")) {
      run_volumes(character, twist, options.volumes, report.volumes);
      write_volumes(report.volumes, options.out + "/results/volumes.csv");
    }
    if (options.wants("collisions") && !(options.collisions.first_model_only && !report.collisions.empty())) {
      const auto results = run_collisions(character, options.collisions);
      report.collisions.insert(report.collisions.end(), results.begin(), results.end());
      write_collisions(report.collisions, options.out + "/results/collision.csv");
    }
  }
  // These have nothing to do with a model given: on one's own models they run only if they are asked for.
  if (options.wants("growth") && (options.files.empty() || !options.only.empty())) {
    report.joint_growth = run_joint_growth({options.speed.seconds_per_run / 5, options.speed.repetitions});
    write_joint_growth(report.joint_growth, options.out + "/results/joint_growth.csv");
    report.character_growth = run_character_growth({options.speed.seconds_per_run / 5, options.speed.repetitions});
    write_character_growth(report.character_growth, options.out + "/results/character_growth.csv");
    report.triangle_growth = run_triangle_growth(options.triangles);
    write_triangle_growth(report.triangle_growth, options.out + "/results/triangle_growth.csv");
  }
  if (options.wants("speed") && (options.files.empty() || !options.only.empty()))
    write_ball_speed(run_ball_speed(options.speed), options.out + "/results/ball_speed.csv");
  if (options.wants("queries") && (options.files.empty() || !options.only.empty())) {
    report.queries = run_queries(options.queries);
    write_queries(report.queries, options.queries, options.out + "/results");
  }
  if (std::filesystem::exists(options.out + "/report/reference/index.html")) report.reference = "reference/index.html";
  write_report(report, options.out + "/report/index.html");
  std::cout << "results: " << options.out << "/results, report: " << options.out << "/report/index.html\n";
} catch (const std::exception& e) {
  std::cerr << "experiments: " << e.what() << '\n';
  return 1;
}
