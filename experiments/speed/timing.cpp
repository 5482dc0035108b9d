// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace refitlab {
namespace {

using Times = std::map<std::string, std::vector<double>>;

// A Collector collects nanoseconds per item by name, with an entry for each repetition.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(Clock clock) : clock_(clock) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        times[run.run_name.function_name].push_back(
            (clock_ == Clock::wall ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime()) / run.counters.at("items"));
  }
  Times times;

 private:
  const Clock clock_;
};

// Progress says every ten seconds how many repetitions of a list of calls are done.
class Progress {
 public:
  Progress(std::size_t calls, const SpeedSettings& settings)
      : seconds_per_run_(settings.seconds_per_run),
        total_(calls * static_cast<std::size_t>(settings.repetitions)) {}
  // Runs that are shorter than asked only find out how often to call.
  void ran(std::chrono::duration<double> run) {
    done_ = std::min(done_ + (run.count() >= seconds_per_run_), total_);
    if (const auto now = Clock::now(); now - shown_at_ > std::chrono::seconds(10)) {
      std::cout << "[timing] " << done_ << " of " << total_ << " runs" << std::endl;
      shown_at_ = now;
    }
  }
  using Clock = std::chrono::steady_clock;

 private:
  const double seconds_per_run_;
  const std::size_t total_;
  std::size_t done_ = 0;
  Clock::time_point shown_at_ = Clock::now();
};

void initialise_once() {
  static const bool initialised = [] {
    char name[] = "experiments", interleave[] = "--benchmark_enable_random_interleaving=true";
    char* arguments[] = {name, interleave, nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments);
    return true;
  }();
  (void)initialised;
}

}  // namespace

Times ns_per_item(const std::vector<Timed>& calls, const SpeedSettings& settings, Clock clock) {
  initialise_once();
  Progress progress(calls.size(), settings);
  for (const Timed& timed : calls) {
    auto* run = benchmark::RegisterBenchmark(timed.name.c_str(), [&timed, &progress](benchmark::State& state) {
      const auto start = Progress::Clock::now();
      for (auto _ : state) timed.call();
      progress.ran(Progress::Clock::now() - start);
      state.counters["items"] = timed.items;
    });
    run->MinTime(settings.seconds_per_run)->Repetitions(settings.repetitions);
    run->Unit(benchmark::kNanosecond);
    if (clock == Clock::wall) run->UseRealTime();
    else run->MeasureProcessCPUTime();
  }
  Collector collector(clock);
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.times;
}

}  // namespace refitlab
