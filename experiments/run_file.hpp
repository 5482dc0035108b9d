// SPDX-License-Identifier: GPL-3.0-or-later
// RunFile is out/results/run.csv, which has the result files that a run wrote and how long it measured. It is there once a run is
// done.
#pragma once

#include <filesystem>

#include "algorithms/results/result_file.hpp"
#include "experiments/options.hpp"

namespace refitlab {

class RunFile {
 public:
  explicit RunFile(const Options& options) : options_(options) { std::filesystem::remove(path()); }
  // Returns the path of a result file of this run.
  std::string operator()(const std::string& name) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
    return options_.out + "/results/" + name;
  }
  void write() const {
    ResultFile file({"file", "effort", "models"});
    for (const auto& name : names_) file.add({name, options_.effort, options_.files.empty() ? "default" : "own"});
    file.write(path());
  }

 private:
  std::string path() const { return options_.out + "/results/run.csv"; }
  const Options& options_;
  std::vector<std::string> names_;
};

}  // namespace refitlab
