#include "experiments/options.hpp"

#include <boost/program_options.hpp>
#include <filesystem>
#include <iostream>

namespace refitlab {
namespace {

const char* const experiments[] = {"tightness", "speed", "volumes", "rounding", "collisions", "growth", "queries"};

}  // namespace

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
      "variant", po::value(&o.certificate.variant), "of the certificate: the refit variant, control_mixed unless given")(
      "check-options", "say whether these options can be run, and do nothing else")(
      "pack-models", "the models for the report's explorer too, in results/models");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, description), map);
  po::notify(map);
  if (map.count("help")) return std::cout << description, false;
  o.check_only = map.count("check-options");
  for (const auto& file : o.files)
    if (!std::filesystem::is_regular_file(file)) throw po::error("--model " + file + ": there is no such file");
  o.anew = map.count("anew");
  o.packs_models = map.count("pack-models");
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
  if (map.count("full")) o.rounding = {.postures = 80, .vertices_per_node = 16};
  if (map.count("quick")) o.collisions = {.frames = 2, .speed = {.seconds_per_run = 0.001, .repetitions = 1}, .first_model_only = true};
  if (map.count("full")) o.collisions = {.frames = 100, .speed = {.seconds_per_run = 0.2, .repetitions = 5}, .all_detectors = true};
  if (map.count("quick")) o.triangles = {.frames = 2, .speed = {.seconds_per_run = 0.001, .repetitions = 1}};
  if (map.count("full")) o.triangles = {.frames = 20, .up_to_a_million = true, .speed = {.seconds_per_run = 0.2, .repetitions = 5}};
  for (const auto& name : o.only)
    if (std::find(std::begin(experiments), std::end(experiments), name) == std::end(experiments))
      throw po::error("--only " + name + ": no such experiment; there are: " + names);
  return true;
}

}  // namespace refitlab
