// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/resume/run_folder.hpp"

#include <cctype>
#include <filesystem>

#include "algorithms/results/result_file.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/tree/fingerprint.hpp"

namespace refitlab {
namespace {

const char* const extension = ".unit";

std::string fingerprint_of(const std::string& bytes) {
  Fingerprint out;
  out.add_bytes(bytes);
  return out.text();
}

// Two builds of uncommitted changes have one provenance, but are not one program.
const std::string& this_program() {
  static const std::string fingerprint = fingerprint_of(read_whole("/proc/self/exe"));
  return fingerprint;
}

// Returns all that has to be the same. It can be read by people too.
std::string head(const std::string& unit, const std::string& inputs) {
  const Provenance& p = Provenance::of_this_build();
  return "refitlab unit 1\nunit: " + unit + "\ncommit: " + p.commit + " " + p.dirty + "\ncompiler: " + p.compiler +
         "\nflags: " + p.flags + "\ncpu: " + p.cpu + "\nprogram: " + this_program() + "\ninputs: " + inputs + "\n";
}

std::string seal(const std::string& result) {
  return "result: " + std::to_string(result.size()) + " bytes, " + fingerprint_of(result) + "\n";
}

}  // namespace

RunFolder::RunFolder(const std::string& folder, bool anew) : folder_(folder), lock_(folder) {
  if (!anew) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == extension) std::filesystem::remove(entry.path());
}

std::string RunFolder::path(const std::string& unit) const {
  std::string name;
  for (const char c : unit) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return (std::filesystem::path(folder_) / (name.substr(0, 100) + "-" + fingerprint_of(unit) + extension)).string();
}

std::optional<std::string> RunFolder::find(const std::string& unit, const std::string& inputs) const {
  if (!std::filesystem::exists(path(unit))) return std::nullopt;
  const std::string text = read_whole(path(unit)), expected = head(unit, inputs);
  if (!text.starts_with(expected)) return std::nullopt;
  const std::size_t end_of_seal = text.find('\n', expected.size());
  if (end_of_seal == std::string::npos) return std::nullopt;
  const std::string result = text.substr(end_of_seal + 1);
  if (text.substr(expected.size(), end_of_seal + 1 - expected.size()) != seal(result)) return std::nullopt;
  return result;
}

void RunFolder::keep(const std::string& unit, const std::string& inputs, const std::string& result) const {
  write_whole(path(unit), head(unit, inputs) + seal(result) + result);
}

}  // namespace refitlab
