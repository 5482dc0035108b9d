// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/oracles/checked_folder.hpp"

#include <stdlib.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "algorithms/certificate/sha256.hpp"
#include "algorithms/results/write_whole.hpp"

namespace proptests::oracle {

namespace {

// Runs a command of the shell.
CheckerRun run(const std::string& command) {
  std::FILE* pipe = ::popen(("ulimit -t 120; timeout 300 " + command + " 2>&1").c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  CheckerRun run{WIFEXITED(status) ? WEXITSTATUS(status) : -1, {}};
  for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    run.lines.push_back(text.substr(at, end - at));
  }
  return run;
}

}  // namespace

std::string checker() { return PROPTESTS_CHECKER; }

std::string pairs_checker() { return checker() + "_pairs"; }

CheckerRun run_checker(const std::string& path, const std::string& program) { return run("python3 '" + program + "' " + path); }

CheckerRun run_clip_checker(const std::string& arguments, const std::string& modules) {
  return run("env PYTHONPATH='" + modules + "' '" PROPTESTS_CLIP_CHECKER "' " + arguments);
}

CheckerRun run_interval_test() { return run("\"$(dirname '" PROPTESTS_CLIP_CHECKER "')/over_time/test\""); }

nlohmann::json with_weight_vertex_vertices(nlohmann::json document) {
  document["vertices"] = nlohmann::json::array();
  for (const nlohmann::json& piece : document["pieces"]) {
    const std::size_t i = document["vertices"].size();
    document["vertices"].push_back({{"id", i},
                                    {"piece", i},
                                    {"position", piece["reference"]["center"]},
                                    {"weights", piece["weight_vertices"][0]},
                                    {"weight_vertices", {0}},
                                    {"shares", {"1"}}});
  }
  return document;
}

std::string sealed(nlohmann::json document) {
  const auto text = [&] { return document.dump(1, ' ', true) + "\n"; };
  document["digest"] = "";
  document["digest"] = refitlab::sha256(text());
  return text();
}

std::string CheckedFolder::file(std::size_t number) const {
  std::string name = std::to_string(number);
  name.insert(0, 6 - name.size(), '0');
  return folder_.file(name + ".json");
}

void CheckedFolder::add(const std::string& text) { std::ofstream(file(count_++), std::ios::binary) << text; }

std::string CheckedFolder::text(std::size_t number) const { return refitlab::read_whole(file(number)); }

std::vector<CheckedLine> CheckedFolder::check() const {
  if (count_ == 0) return {};
  const CheckerRun run = run_checker(path(), program_);
  std::vector<CheckedLine> out;
  bool all_accepted = true;
  for (const std::string& line : run.lines) {
    const std::string name = ": \"" + file(out.size()) + "\": ";
    const std::size_t at = line.find(name);
    if (out.size() == count_ || at == std::string::npos) throw std::runtime_error("the checker says: " + line);
    out.push_back({line.substr(0, at) + ": " + line.substr(at + name.size())});
    if (!out.back().is_accepted() && !out.back().is_rejected()) throw std::runtime_error("the checker says: " + line);
    all_accepted = all_accepted && out.back().is_accepted();
  }
  if (out.size() != count_ || run.status != (all_accepted ? 0 : 1))
    throw std::runtime_error("the checker ends with status " + std::to_string(run.status) + " after " +
                             std::to_string(out.size()) + " of " + std::to_string(count_) + " files");
  return out;
}

}  // namespace proptests::oracle
