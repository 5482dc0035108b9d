// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/options.hpp"

#include <boost/program_options.hpp>
#include <filesystem>
#include <iostream>
#include <map>

#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/packs/limit_targets.hpp"

namespace refitlab {
namespace {

std::vector<std::string> all_experiments() {
  std::vector<std::string> out(std::begin(experiments_on_models), std::end(experiments_on_models));
  for (const char* name : experiments_without_model)
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  return out;
}

// This shows only that everything runs. It has collisions of one character only, and too few repetitions for times to mean much.
void measure_quickly(Options& o) {
  o.effort = "quick";
  const SpeedSettings speed{.seconds_per_run = 0.01, .repetitions = 3}, once{.seconds_per_run = 0.001, .repetitions = 1};
  o.tightness = {.times_per_clip = 5};
  o.speed = speed;
  o.volumes = {.times_per_clip = 2, .nodes_per_level = 32, .speed = speed};
  o.rounding = {.poses = 1, .vertices_per_node = 1, .speed = speed};
  o.collisions = {.frames = 2, .speed = once, .first_model_only = true};
  o.triangles = {.frames = 2, .subdivisions = 1, .speed = once};
  o.crowds = {.most_characters = 100, .speed = once};
  o.synthetic.count = 1000;
  o.over_time = {.random_times = 20, .halvings = 2, .exact_checks = 1, .clips = 1};
  o.crossfades = {.times = 3, .weights = 3, .clips = 2, .cluster_triangles = 0};
  o.over_time_growth = {.subdivisions = 1};
  o.engines = {.times_per_clip = 10, .clips = 1, .speed = once};
  o.deformations = {.times_per_clip = 1, .reduced = {.poses = 2}, .speed = once};
}

// These are the settings for the numbers of the paper and README.
void measure_fully(Options& o) {
  o.effort = "full";
  o.picture_size = 1;
  const SpeedSettings speed{.seconds_per_run = 0.2, .repetitions = 7};
  o.tightness = {.times_per_clip = 100};
  o.speed = speed;
  o.volumes = {.times_per_clip = 20, .nodes_per_level = 128, .speed = {.seconds_per_run = 0.05, .repetitions = 7}};
  o.rounding = {.poses = 20, .vertices_per_node = 8, .speed = {.seconds_per_run = 0.05, .repetitions = 7}};
  o.collisions = {.frames = 50, .speed = {.seconds_per_run = 0.05, .repetitions = 5}, .all_detectors = true};
  o.triangles = {.frames = 20, .subdivisions = 3, .speed = {.seconds_per_run = 0.1, .repetitions = 5}};
  o.crowds = {.most_characters = 10000, .speed = {.seconds_per_run = 0.1, .repetitions = 5}};
  o.synthetic.count = 50000;
  o.over_time = {.random_times = 10000, .halvings = 12, .exact_checks = 200};
  o.crossfades = {.times = 25, .weights = 9, .all_skinnings = true};
  o.over_time_growth = {.repetitions = 3, .subdivisions = 3, .up_to_a_million = true};
  o.engines = {.times_per_clip = 10000, .speed = {.seconds_per_run = 0.05, .repetitions = 15}, .unseen_clips = true};
  o.deformations = {.times_per_clip = 20, .reduced = {.poses = 20}, .speed = {.seconds_per_run = 0.05, .repetitions = 15}};
}

// Limits all kernels to those of a target of this name.
void limit_to(const std::string& name) {
  std::string names;
  for (const Target target : available_targets()) {
    if (name == name_of(target)) {
      limit_targets(target);
      return Provenance::add_to_cpu(", kernels up to " + name);
    }
    names += (names.empty() ? "" : ", ") + std::string(name_of(target));
  }
  throw boost::program_options::error("--target " + name + ": this processor runs no such kernels; it runs: " + names);
}

}  // namespace

bool parse(int argc, char** argv, Options& o) {
  namespace po = boost::program_options;
  const std::vector<std::string> experiments = all_experiments();
  std::string names;
  for (const std::string& name : experiments) names += (names.empty() ? "" : ", ") + name;
  po::options_description description("experiments: refit variants compared on skinned characters");
  description.add_options()("help", "this text")("model", po::value(&o.files)->multitoken(),
                                                 "rigged files of one's own, in place of the default models")(
      "only", po::value(&o.only)->multitoken(), ("experiments to run, of: " + names).c_str())(
      "quick", "few sampled times per clip, short timings: a smoke run")(
      "full", "many sampled times per clip, long timings, all detectors, up to a million triangles: the paper's numbers")(
      "anew", "run everything, also what an earlier run of this very program finished with the same options and models")(
      "models", po::value(&o.models), "folder of the real models")("out", po::value(&o.out), "folder for all that is generated")(
      "certificate", po::value(&o.certificate.file),
      "write why a refitted ball holds its vertices to this file, and do nothing else; of the model given, or the procedural "
      "man")("node", po::value(&o.certificate.node), "of the certificate: in the sphere tree, 0 being its root")(
      "clip", po::value(&o.certificate.clip), "of the certificate: the first unless given")(
      "time", po::value(&o.certificate.seconds), "of the certificate: seconds into the clip")(
      "variant", po::value(&o.certificate.variant), "of the certificate: the refit variant, control_mixed unless given")(
      "character", po::value(&o.characters)->multitoken(),
      "of the default models those of these names; none is what has nothing to do with a model")(
      "target", po::value<std::string>(),
      "the widest kernels to use, as on an older processor (baseline, avx2 or avx512), but for engines'")(
      "list-parts", "print each experiment and character that these options ask for, and do nothing else")(
      "check-options", "say whether these options can be run, and do nothing else")(
      "pack-models", "the models for the report's explorer too, in results/models");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, description), map);
  po::notify(map);
  if (map.count("help")) return std::cout << description, false;
  o.check_only = map.count("check-options");
  o.lists_parts = map.count("list-parts");
  if (map.count("character") && map.count("model")) throw po::error("--character is of the default models, --model of one's own");
  for (const auto& file : o.files)
    if (!std::filesystem::is_regular_file(file)) throw po::error("--model " + file + ": there is no such file");
  std::map<std::string, std::string> paths;  // by what results call a model
  for (const auto& file : o.files)
    if (const auto [other, is_new] = paths.emplace(std::filesystem::path(file).filename().string(), file); !is_new)
      throw po::error("--model " + file + ": results would not tell it from " + other->second + ", which has the same name");
  o.anew = map.count("anew");
  o.packs_models = map.count("pack-models");
  for (const char* name : {"node", "clip", "time", "variant"})
    if (map.count(name) && !map.count("certificate")) throw po::error(std::string("--") + name + " is for --certificate");
  if (map.count("certificate") && o.certificate.file.empty()) throw po::error("--certificate takes a file to write");
  if (map.count("certificate") && o.files.size() > 1) throw po::error("--certificate is of one --model");
  if (map.count("quick") && map.count("full")) throw po::error("--quick and --full exclude each other");
  if (map.count("quick")) measure_quickly(o);
  if (map.count("full")) measure_fully(o);
  for (const auto& name : o.only)
    if (std::find(experiments.begin(), experiments.end(), name) == experiments.end())
      throw po::error("--only " + name + ": no such experiment; there are: " + names);
  if (map.count("target")) limit_to(map["target"].as<std::string>());
  return true;
}

}  // namespace refitlab
