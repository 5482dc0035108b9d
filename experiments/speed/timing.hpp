// Timing by Google Benchmark: nanoseconds of processor time per item, repeated.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace refitlab {

struct SpeedSettings {
  double seconds_per_run = 0.1;  // at least, of each repetition
  int repetitions = 5;           // of all variants in random order, so that a drifting machine hits all of them alike
};

struct Timed {
  std::string name;            // different for each
  int items;                   // that one call handles: nodes, clouds, frames
  std::function<void()> call;  // keeps its results from being optimised away
};

// By name, one entry a repetition. Of all threads of this process, the calls being made by this one.
std::map<std::string, std::vector<double>> ns_per_item(const std::vector<Timed>& calls,
                                                       const SpeedSettings& settings);

// values is not empty.
double median(std::vector<double> values);

// The median over the repetitions of the ratio in the same repetition.
double median_ratio(const std::vector<double>& times, const std::vector<double>& base);

}  // namespace refitlab
