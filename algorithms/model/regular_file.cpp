// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/regular_file.hpp"

#include <fstream>
#include <iterator>

namespace refitlab {

std::optional<std::string> bytes_of_regular_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  if (!in.is_open()) return std::nullopt;
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) return std::nullopt;
  return bytes;
}

}  // namespace refitlab
