// SPDX-License-Identifier: GPL-3.0-or-later
// Growth of the cost of bounds over time: the man's walk several times over, and the man of ever more triangles, which the program
// `refitlab bake` bakes in a process of its own.
#pragma once

#include <string>
#include <vector>

namespace refitlab {

struct OverTimeGrowthSettings {
  int repetitions = 1;   // of each measurement, whose least time counts
  int subdivisions = 2;  // of the finest man, which has 8270 triangles before
  bool up_to_a_million = false;
};

struct OverTimeGrowth {
  std::string by;                    // what grows: length or triangles
  long length, triangles, clusters;  // length: of the clip, in walks
  double seconds;                    // of bounding the model, linear skinning
  // The most that the process that bakes had until the bounds were there, and until the file was, which has the baked character
  // for refits, too. 0 where there was no such process.
  double peak_of_bounding, peak_of_all;
};

// Progress on stdout. Throws std::runtime_error if the program fails.
std::vector<OverTimeGrowth> run_over_time_growth(const OverTimeGrowthSettings& settings);

void write_over_time_growth(const std::vector<OverTimeGrowth>& rows, const std::string& path);

}  // namespace refitlab
