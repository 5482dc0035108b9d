// SPDX-License-Identifier: MIT
#include "algorithms/runtime/packs/targets.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "algorithms/runtime/packs/limit_targets.hpp"

namespace refitlab {
namespace {

std::vector<Target>& targets() {
  static std::vector<Target> targets = [] {
    std::vector<Target> out{Target::baseline};
#ifdef REFITLAB_X86_TARGETS
    // These are the features that x86-64-v3 adds to v2, and v4 to v3, as far as a compiler may use them unasked for arithmetic.
    __builtin_cpu_init();
    const bool is_v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                       __builtin_cpu_supports("bmi2");
    const bool is_v4 = is_v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                       __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                       __builtin_cpu_supports("avx512vl");
    if (is_v3) out.push_back(Target::avx2);
    if (is_v4) out.push_back(Target::avx512);
#endif
    return out;
  }();
  return targets;
}

}  // namespace

const char* name_of(Target target) {
  switch (target) {
    case Target::avx2: return "avx2";
    case Target::avx512: return "avx512";
    default: return "baseline";
  }
}

const std::vector<Target>& available_targets() { return targets(); }

void limit_targets(Target widest) {
  const auto at = std::find(targets().begin(), targets().end(), widest);
  if (at == targets().end())
    throw std::invalid_argument(std::string("targets: this program or this processor has no ") + name_of(widest));
  targets().erase(at + 1, targets().end());
}

}  // namespace refitlab
