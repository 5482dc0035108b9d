// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/synthetic/synthetic.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>

#include "algorithms/bake/parallel.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/verification/score.hpp"
#include "experiments/speed/statistics.hpp"

namespace refitlab {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int sample_count = 100;  // cases written as a file of cases
constexpr int timed_cases = 500, passes = 3;

struct Measured {
  CaseScore score;
  double looseness = std::numeric_limits<double>::quiet_NaN();  // not a number: no ball, or nothing to enclose
};

using MeasuredCase = std::vector<Measured>;  // by variant

MeasuredCase measure(const SyntheticSettings& settings, std::size_t number) {
  const SyntheticCase synthetic = make_synthetic_case(settings.seed, number);
  const CaseNodes nodes(synthetic);
  std::map<Skinning, std::pair<SkinnedCase, double>> skinned;  // with the radius of the smallest ball
  for (const Skinning s : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
    SkinnedCase images(synthetic, s);
    const double smallest = images.smallest_radius();
    skinned.emplace(s, std::pair(std::move(images), smallest));
  }
  MeasuredCase out;
  for (const RefitVariant& variant : compared_variants()) {
    auto& [images, smallest] = skinned.at(variant.skinning);
    const Ball3<double> ball = variant.refit(nodes.node(variant.pieces));
    Measured m{images.score(ball)};
    // Vertices that hardly move have a smallest ball of rounding errors, and a ratio to it would say nothing.
    if (!m.score.undefined && !m.score.unbounded && smallest > 1e-9) m.looseness = ball.radius / smallest;
    out.push_back(m);
  }
  return out;
}

SyntheticResult summary(const std::vector<MeasuredCase>& cases, std::size_t variant) {
  SyntheticResult out{compared_variants()[variant].name};
  std::vector<double> looseness;
  for (const MeasuredCase& q : cases) {
    const Measured& m = q[variant];
    ++out.cases;
    out.undefined += m.score.undefined;
    out.unbounded += m.score.unbounded;
    out.misses += m.score.misses;
    out.misses_beyond_tolerance += m.score.misses_beyond_tolerance();
    if (!m.score.undefined) out.worst_miss = std::max(out.worst_miss, m.score.worst_miss);
    if (!std::isnan(m.looseness)) looseness.push_back(m.looseness);
  }
  if (looseness.empty()) return out;
  std::sort(looseness.begin(), looseness.end());
  for (const double x : looseness) out.looseness_mean += x / static_cast<double>(looseness.size());
  out.looseness_median = median(looseness);
  out.looseness_max = looseness.back();
  return out;
}

// Returns rough times, which include the cost of the clock and of the call. They are the best of a few passes over all cases.
std::vector<double> nanoseconds(const SyntheticSettings& settings) {
  const int count = std::min(settings.count, timed_cases);
  std::vector<CaseNodes> nodes;
  for (int number = 0; number < count; ++number) nodes.emplace_back(make_synthetic_case(settings.seed, number));
  std::vector<double> out;
  double sink = 0;  // so that no refit is without effect
  for (const RefitVariant& variant : compared_variants()) {
    double best = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < passes; ++pass) {
      const auto start = Clock::now();
      for (const CaseNodes& n : nodes) sink += variant.refit(n.node(variant.pieces)).radius;
      best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count() / count);
    }
    out.push_back(best);
  }
  volatile double kept = sink;
  (void)kept;
  return out;
}

void print_table(const std::vector<SyntheticResult>& results) {
  std::printf("  %-30s %9s %9s %12s %9s | %8s %8s %8s | %9s\n", "all cases", "undefined", "missed", "> tolerance", "worst",
              "mean", "median", "max", "ns, rough");
  for (const SyntheticResult& r : results)
    std::printf("  %-30s %9ld %9ld %12ld %9.1e | %8.3f %8.3f %8.3g | %9.0f\n", r.variant.c_str(), r.undefined, r.misses,
                r.misses_beyond_tolerance, r.worst_miss, r.looseness_mean, r.looseness_median, r.looseness_max, r.ns_per_refit);
  std::printf(
      "  missed: cases with a vertex outside, decided exactly; beyond the tolerance of %.0e of the coordinates' size "
      "it is not "
      "by rounding. mean, median, max: radius / smallest ball of sampled true positions.\n",
      synthetic_tolerance);
}

}  // namespace

std::vector<SyntheticResult> run_synthetic(const SyntheticSettings& settings) {
  std::cout << "== " << settings.count << " synthetic cases, seed " << settings.seed << std::endl;
  std::vector<MeasuredCase> cases(static_cast<std::size_t>(settings.count));
  std::atomic<std::size_t> done{0};
  const std::size_t tenth = std::max<std::size_t>(1, cases.size() / 10);
  parallel_for(cases.size(), [&](std::size_t i) {
    cases[i] = measure(settings, i);
    if (const std::size_t n = ++done; n % tenth == 0)
      std::printf("[synthetic] %zu of %zu\n", n, cases.size()), std::fflush(stdout);
  });
  const std::vector<double> ns = nanoseconds(settings);
  std::vector<SyntheticResult> results;
  for (std::size_t v = 0; v < compared_variants().size(); ++v) {
    results.push_back(summary(cases, v));
    results.back().ns_per_refit = ns[v];
  }
  print_table(results);
  return results;
}

void write_synthetic(const std::vector<SyntheticResult>& results, const SyntheticSettings& settings, const std::string& path) {
  ResultFile file({"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit"});
  for (const SyntheticResult& r : results) {
    const auto add = [&](const char* quantity, double value, const char* unit) {
      file.add({"synthetic", "synthetic", "all", r.variant, "all", quantity, format_number(value), unit}, settings.seed);
    };
    add("cases", static_cast<double>(r.cases), "1");
    add("undefined", static_cast<double>(r.undefined), "1");
    add("unbounded", static_cast<double>(r.unbounded), "1");
    add("missed_cases", static_cast<double>(r.misses), "1");
    add("missed_cases_beyond_tolerance", static_cast<double>(r.misses_beyond_tolerance), "1");
    add("worst_miss", r.worst_miss, "size of the coordinates");
    if (r.looseness_max > 0) {
      add("looseness_mean", r.looseness_mean, "1");
      add("looseness_median", r.looseness_median, "1");
      add("looseness_max", r.looseness_max, "1");
    }
    if (r.ns_per_refit > 0) add("ns_per_refit", r.ns_per_refit, "ns");
  }
  file.write(path);
  write_whole((std::filesystem::path(path).parent_path() / "synthetic_sample.json").string(),
              synthetic_cases_as_case_file(settings.seed, std::min(settings.count, sample_count)));
}

}  // namespace refitlab
