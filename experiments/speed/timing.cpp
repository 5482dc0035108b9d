// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>

namespace refitlab {
namespace {

using Times = std::map<std::string, std::vector<double>>;

// Progress says every ten seconds how many runs are done.
class Progress {
 public:
  explicit Progress(std::size_t total) : total_(total) {}
  void ran(std::size_t runs) {
    done_ += runs;
    if (const auto now = Clock::now(); now - shown_at_ > std::chrono::seconds(10)) {
      std::cout << "[timing] " << done_ << " of " << total_ << " runs" << std::endl;
      shown_at_ = now;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  const std::size_t total_;
  std::size_t done_ = 0;
  Clock::time_point shown_at_ = Clock::now();
};

// A Collector collects nanoseconds per item by name, with an entry for each round, and how often a call was made in the latest.
class Collector : public benchmark::BenchmarkReporter {
 public:
  Collector(Clock clock, std::size_t total) : clock_(clock), progress_(total) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const std::string& name = run.run_name.function_name;
      times[name].push_back((clock_ == Clock::wall ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime()) /
                            run.counters.at("items"));
      iterations[name] = run.iterations;
    }
    progress_.ran(runs.size());
  }
  Times times;
  std::map<std::string, benchmark::IterationCount> iterations;

 private:
  const Clock clock_;
  Progress progress_;
};

void initialise_once() {
  static const bool initialised = [] {
    char name[] = "experiments";
    char* arguments[] = {name, nullptr};
    int count = 1;
    benchmark::Initialize(&count, arguments);
    return true;
  }();
  (void)initialised;
}

}  // namespace

// Google Benchmark would mix the repetitions of all calls, and then the first of one may be made long after the first of another.
// So each round is a run of its own. The first one finds out how often to make a call, and the others make it as often.
Times ns_per_item(const std::vector<Timed>& calls, const SpeedSettings& settings, Clock clock) {
  initialise_once();
  Collector collector(clock, calls.size() * static_cast<std::size_t>(settings.repetitions));
  std::vector<const Timed*> order;
  for (const Timed& timed : calls) order.push_back(&timed);
  std::mt19937 random(1);
  for (int round = 0; round < settings.repetitions; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (const Timed* timed : order) {
      auto* run = benchmark::RegisterBenchmark(timed->name.c_str(), [timed](benchmark::State& state) {
        for (auto _ : state) timed->call();
        state.counters["items"] = timed->items;
      });
      if (round == 0) run->MinTime(settings.seconds_per_run);
      else run->Iterations(collector.iterations.at(timed->name));
      run->Unit(benchmark::kNanosecond);
      if (clock == Clock::wall) run->UseRealTime();
      else run->MeasureProcessCPUTime();
    }
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::ClearRegisteredBenchmarks();
  }
  return collector.times;
}

}  // namespace refitlab
