// SPDX-License-Identifier: GPL-3.0-or-later
// This measures how the cost of bounds over time grows. It takes the man's walk several times over, and the man of ever more
// triangles, which the program `refitlab bake` bakes in a process of its own.
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
  std::string grown;                      // what grows: walk_cycles or triangles
  long walk_cycles, triangles, clusters;  // walk_cycles: in the clip, one after another
  double seconds;                         // of bounding the model, linear skinning
  // These are the peaks of memory of the baking process, in megabytes, until the bounds were made, and until the file was
  // written, which also has the baked character for refits. They are 0 if there was no such process.
  double peak_of_bounding, peak_of_all;
};

// Measures the growth. Progress goes to stdout. Throws std::runtime_error if the program fails.
std::vector<OverTimeGrowth> run_over_time_growth(const OverTimeGrowthSettings& settings);

// Returns a fingerprint of that program. Throws std::runtime_error if it cannot be read.
std::string identify_baking_program();

void write_over_time_growth(const std::vector<OverTimeGrowth>& rows, const std::string& path);

}  // namespace refitlab
