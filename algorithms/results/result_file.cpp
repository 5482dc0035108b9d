// SPDX-License-Identifier: MIT
#include "algorithms/results/result_file.hpp"

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "refitlab_build.hpp"  // generated at build time: commit, compiler, flags

namespace refitlab {
namespace {

// Returns the name of the first processor, with its family and model where Linux has them: a virtual machine may not tell its
// generation in the name.
std::string cpu_name() {
  std::string name = "unknown", numbers;
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line) && !line.empty();) {
    const std::string key = line.substr(0, line.find_last_not_of(" \t", line.find(':') - 1) + 1);
    const std::string value = line.find(": ") == std::string::npos ? "" : line.substr(line.find(": ") + 2);
    if (key == "model name") name = value;
    if (key == "cpu family") numbers += ", family " + value;
    if (key == "model") numbers += ", model " + value;
  }
  return name + numbers;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void append_row(std::ostringstream& out, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) out << (i ? "," : "") << csv_field(fields[i]);
  out << '\n';
}

Provenance& provenance() {
  static Provenance p{REFITLAB_COMMIT, REFITLAB_DIRTY, REFITLAB_COMPILER, REFITLAB_FLAGS, cpu_name()};
  return p;
}

}  // namespace

const Provenance& Provenance::of_this_build() { return provenance(); }
void Provenance::add_to_cpu(const std::string& note) { provenance().cpu += note; }

std::string format_number(double value) {
  const DefaultFloatEnvironment environment;
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

void ResultFile::add(std::vector<std::string> row, std::uint64_t seed) {
  if (row.size() != columns_.size()) throw std::logic_error("a result row must have a value per column");
  rows_.emplace_back(std::move(row), seed);
}

std::string ResultFile::text() const {
  std::ostringstream out;
  const Provenance& p = Provenance::of_this_build();
  auto header = columns_;
  header.insert(header.end(), {"commit", "dirty", "compiler", "flags", "cpu", "seed"});
  append_row(out, header);
  for (const auto& [row, seed] : rows_) {
    auto fields = row;
    fields.insert(fields.end(), {p.commit, p.dirty, p.compiler, p.flags, p.cpu, std::to_string(seed)});
    append_row(out, fields);
  }
  return out.str();
}

}  // namespace refitlab
