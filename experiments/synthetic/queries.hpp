// SPDX-License-Identifier: GPL-3.0-or-later
// The queries experiment: every refit variant on many generated refit cases in exact rationals; what it misses, how
// loose it is, what it costs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace refitlab {

struct QueryResult {
  std::string variant, share;  // share: "all", "general" or "degenerate" queries
  long queries = 0, undefined = 0;
  long unbounded = 0;                            // all of space: no ball holds what dual quaternions make of a blend near 0
  long misses = 0, misses_beyond_tolerance = 0;  // queries with a missed vertex, undefined ones among them
  double worst_miss = 0;                         // of a defined ball, relative to the size of the coordinates
  double looseness_mean = 0, looseness_median = 0,
         looseness_max = 0;  // radius / smallest ball of sampled true positions
  double ns_per_refit = 0;   // rough; 0 where it was not timed
};

struct QuerySettings {
  int count = 20000;
  std::uint64_t seed = 2006;
};

// Geometry on all processors, then the cost of some of the queries on one thread. Progress and a table on stdout.
std::vector<QueryResult> run_queries(const QuerySettings& settings);

// out/results/queries.csv at path, and beside it the first queries as a file of cases for other programs to read.
void write_queries(const std::vector<QueryResult>& results, const QuerySettings& settings, const std::string& path);

}  // namespace refitlab
