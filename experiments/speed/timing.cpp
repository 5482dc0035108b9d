#include "experiments/speed/timing.hpp"

#include <benchmark/benchmark.h>

namespace refitlab {
namespace {

using Times = std::map<std::string, std::vector<double>>;

// Collects nanoseconds per item by name, one entry a repetition.
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
  for (const Timed& timed : calls) {
    auto* run = benchmark::RegisterBenchmark(timed.name.c_str(), [&timed](benchmark::State& state) {
      for (auto _ : state) timed.call();
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
