#include "experiments/speed/speed.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>

#include "algorithms/results/result_file.hpp"

namespace refitlab {
namespace {

// Collects nanoseconds per sphere by variant, one entry a repetition.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        times[run.run_name.function_name].push_back(run.GetAdjustedRealTime() / run.counters.at("spheres"));
  }
  std::map<std::string, std::vector<double>> times;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<SpeedResult> run_speed(const Character& c, const NamedPosture& posture, const SpeedSettings& settings) {
  std::cout << "[speed] " << c.model.name << ", " << posture.name << ": " << settings.repetitions << " repetitions" << std::endl;
  static const bool initialised = [] {
    char name[] = "experiments", interleave[] = "--benchmark_enable_random_interleaving=true";
    char* arguments[] = {name, interleave, nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments);
    return true;
  }();
  (void)initialised;
  for (const RefitVariant& variant : refit_variants()) {
    if (!variant.sound) continue;
    const auto pose = make_skinning_pose(c.model, c.sets, posture.posture, variant.skinning);
    benchmark::RegisterBenchmark(variant.name.c_str(), [&c, &variant, pose](benchmark::State& state) {
      const int count = static_cast<int>(c.tree.nodes.size());
      for (auto _ : state)
        for (int n = 0; n < count; ++n) benchmark::DoNotOptimize(variant.refit(c.refit_node(n, pose, variant.pieces)));
      state.counters["spheres"] = count;
    })->MinTime(settings.seconds_per_run)->Repetitions(settings.repetitions)->Unit(benchmark::kNanosecond)->UseRealTime();
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();

  std::vector<SpeedResult> results;
  const auto& repaired = collector.times.at("spherical_repaired");
  for (const RefitVariant& variant : refit_variants()) {
    const auto entry = collector.times.find(variant.name);
    if (entry == collector.times.end()) continue;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < entry->second.size(); ++i) ratios.push_back(entry->second[i] / repaired[i]);
    results.push_back({c.model.name, posture.name, variant.name, median(entry->second), median(ratios)});
    std::printf("  %-26s %8.1f ns per sphere, %6.2f times spherical_repaired\n", variant.name.c_str(), results.back().ns_per_sphere,
                results.back().ratio_to_repaired);
  }
  return results;
}

void write_speed(const std::vector<SpeedResult>& results, const std::string& path) {
  ResultFile file({"experiment", "model", "posture", "variant", "level", "quantity", "value", "unit"});
  for (const SpeedResult& r : results) {
    file.add({"speed", r.model, r.posture, r.variant, "all", "ns_per_sphere", format_number(r.ns_per_sphere), "ns"});
    file.add({"speed", r.model, r.posture, r.variant, "all", "ratio_to_repaired", format_number(r.ratio_to_repaired), "1"});
  }
  file.write(path);
}

}  // namespace refitlab
