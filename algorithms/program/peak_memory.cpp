// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/peak_memory.hpp"

#include <fstream>
#include <string>

namespace refitlab {

std::optional<double> peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kibibytes = 0; word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024e-6;
  return std::nullopt;
}

}  // namespace refitlab
