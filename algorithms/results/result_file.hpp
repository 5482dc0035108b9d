// SPDX-License-Identifier: MIT
// Result files: tables in long form whose every row says where it comes from, written whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/results/write_whole.hpp"

namespace refitlab {

// What every result row carries after its own columns: commit, dirty flag, compiler, flags, CPU.
struct Provenance {
  std::string commit, dirty, compiler, flags, cpu;
  static const Provenance& of_this_build();
};

// The shortest decimal text that reads back as the same double; "nan", "inf" and "-inf" for what is no number.
std::string format_number(double value);

class ResultFile {
 public:
  explicit ResultFile(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  // One row, a value per column. seed: of the random choices behind the row (0 where there are none).
  void add(std::vector<std::string> row, std::uint64_t seed = 0);
  std::string text() const;  // RFC 4180 CSV with the provenance columns
  void write(const std::string& path) const { write_whole(path, text()); }

 private:
  std::vector<std::string> columns_;
  std::vector<std::pair<std::vector<std::string>, std::uint64_t>> rows_;
};

}  // namespace refitlab
