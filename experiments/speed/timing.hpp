// SPDX-License-Identifier: GPL-3.0-or-later
// Google Benchmark measures nanoseconds per item, repeatedly.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/speed/statistics.hpp"  // of what ns_per_item returns

namespace refitlab {

struct SpeedSettings {
  double seconds_per_run = 0.1;  // at least, of each repetition
  int repetitions = 5;  // rounds, each with all variants in random order, so that a drifting machine hits all of them alike
};

struct Timed {
  std::string name;            // different for each
  int items;                   // that one call handles: nodes, clouds, frames
  std::function<void()> call;  // keeps its results from being optimised away
};

enum class Clock {
  processor,  // of all threads of this process, whoever else is on the cores
  wall        // for what runs on several threads
};

// Returns nanoseconds per item by name, with an entry for each repetition, in order. Those of one repetition were measured right
// after each other. The calls are made by this thread.
std::map<std::string, std::vector<double>> ns_per_item(const std::vector<Timed>& calls, const SpeedSettings& settings,
                                                       Clock clock = Clock::processor);

}  // namespace refitlab
