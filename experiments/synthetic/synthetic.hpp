// SPDX-License-Identifier: GPL-3.0-or-later
// The synthetic experiment runs every refit variant on many synthetic cases in exact rationals. It measures what each misses, how
// loose it is, and what it costs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace refitlab {

struct SyntheticResult {
  std::string variant;
  long cases = 0, undefined = 0;
  long unbounded = 0;                            // all of space: no ball holds what dual quaternions make of a blend near 0
  long misses = 0, misses_beyond_tolerance = 0;  // cases with a missed vertex, undefined ones among them
  double worst_miss = 0;                         // of a defined ball, relative to the size of the coordinates
  double looseness_mean = 0, looseness_median = 0,
         looseness_max = 0;  // radius / smallest ball of sampled true positions
  double ns_per_refit = 0;   // rough; 0 where it was not timed
};

struct SyntheticSettings {
  int count = 20000;
  std::uint64_t seed = 2006;
};

// Measures the geometry on all processors, then the cost of some of the cases on one thread. Progress and a table go to stdout.
std::vector<SyntheticResult> run_synthetic(const SyntheticSettings& settings);

// Writes out/results/synthetic.csv to path, and beside it the first cases as a file of cases for other programs to read.
void write_synthetic(const std::vector<SyntheticResult>& results, const SyntheticSettings& settings, const std::string& path);

}  // namespace refitlab
