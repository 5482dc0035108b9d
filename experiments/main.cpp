// experiments: the main job. Runs the experiments on the default models or on the user's own, and writes results and report.
#include <boost/program_options.hpp>
#include <iostream>

#include "algorithms/model/load.hpp"
#include "experiments/report/report.hpp"
#include "experiments/tightness/tightness.hpp"

namespace {

struct Options {
  std::vector<std::string> only, files;
  std::string models = "out/models", out = "out";
  int times = 50;
};

// False if only help was asked for.
bool parse(int argc, char** argv, Options& o) {
  namespace po = boost::program_options;
  const std::string names = "tightness";
  po::options_description description("experiments: refit variants compared on skinned characters");
  description.add_options()("help", "this text")(
      "model", po::value(&o.files)->multitoken(), "rigged files of one's own, in place of the default models")(
      "only", po::value(&o.only)->multitoken(), ("experiments to run, of: " + names).c_str())(
      "quick", "few sampled times per clip: a smoke run")("full", "many sampled times per clip")(
      "models", po::value(&o.models), "folder of the real models")("out", po::value(&o.out), "folder for all that is generated");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, description), map);
  po::notify(map);
  if (map.count("help")) return std::cout << description, false;
  if (map.count("quick") && map.count("full")) throw po::error("--quick and --full exclude each other");
  if (map.count("quick")) o.times = 5;
  if (map.count("full")) o.times = 200;
  for (const auto& name : o.only)
    if (name != "tightness") throw po::error("--only " + name + ": no such experiment; there are: " + names);
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace refitlab;
  Options options;
  if (!parse(argc, argv, options)) return 0;

  DefaultModels models;
  if (options.files.empty())
    models = default_models(options.models);
  else
    for (const auto& file : options.files) models.models.push_back(load_model(file));
  for (const auto& absent : models.absent) std::cout << "absent: " << absent << " (could not be fetched; the run goes on)\n";

  Report report;
  report.absent_models = models.absent;
  for (Model& model : models.models) {
    const Character character(std::move(model));
    const auto results = run_tightness(character, {.times_per_clip = options.times});
    report.tightness.insert(report.tightness.end(), results.begin(), results.end());
    if (report.pictures.empty()) {
      const auto [name, posture] = figure_twist(character.model);
      report.pictures = twist_pictures(character, name, posture, options.out + "/report/pictures");
    }
    write_tightness(report.tightness, options.out + "/results/tightness.csv");
  }
  write_report(report, options.out + "/report/index.html");
  std::cout << "results: " << options.out << "/results, report: " << options.out << "/report/index.html\n";
} catch (const std::exception& e) {
  std::cerr << "experiments: " << e.what() << '\n';
  return 1;
}
