// SPDX-License-Identifier: MIT
// Result files are tables in long form. Every row says where it comes from. They are written whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/results/write_whole.hpp"

namespace refitlab {

// Every result row has these after its own columns: commit, dirty flag, compiler, flags, CPU.
struct Provenance {
  std::string commit, dirty, compiler, flags, cpu;
  static const Provenance& of_this_build();
  // Says after the processor's name, in all rows that are written from now on, that a run did not use all of it.
  static void add_to_cpu(const std::string& note);
};

// Returns the shortest decimal text that reads back as the same double, or "nan", "inf" or "-inf".
std::string format_number(double value);

class ResultFile {
 public:
  explicit ResultFile(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  // Adds a row, which has a value for each column. seed is that of the random choices behind the row, or 0 if there are none.
  void add(std::vector<std::string> row, std::uint64_t seed = 0);
  std::string text() const;  // RFC 4180 CSV with the provenance columns
  void write(const std::string& path) const { write_whole(path, text()); }

 private:
  std::vector<std::string> columns_;
  std::vector<std::pair<std::vector<std::string>, std::uint64_t>> rows_;
};

}  // namespace refitlab
