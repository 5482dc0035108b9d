// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/speed/latencies.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace refitlab {
namespace {

// Repeats an operation whose result the next one takes.
template <class Operation>
Timed chain_of(const std::string& name, const Operation& operation) {
  constexpr int length = 1000;
  return {name, length, [operation] {
            double x = 1, c = 1.7;
            benchmark::DoNotOptimize(c);
            for (int i = 0; i < length; ++i) x = operation(x, c);
            benchmark::DoNotOptimize(x);
          }};
}

}  // namespace

Latencies measure_latencies(const SpeedSettings& settings) {
  const auto times = ns_per_item({chain_of("sum", [](double x, double c) { return x + c; }),
                                  chain_of("product", [](double x, double c) { return x * (c - 0.7); }),
                                  chain_of("quotient", [](double x, double c) { return c / x; }),
                                  chain_of("root", [](double x, double c) { return std::sqrt(c * x); })},
                                 settings);
  Latencies out;
  const auto least = [&](const char* name) { return std::ranges::min(times.at(name)); };
  out.sum = least("sum"), out.product = least("product"), out.quotient = least("quotient");
  out.root = std::max(0., least("root") - out.product);
  return out;
}

}  // namespace refitlab
