// SPDX-License-Identifier: GPL-3.0-or-later
// Tests lane bits through a kernel that keeps what some lanes have, so that every target's own way is tried.
#include "algorithms/runtime/packs/lane_bits.hpp"

#include <random>

#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_lane_bits {
namespace {

using namespace refitlab;

// Says whether the boxes at 0 are listed, in order. The boxes marked true are at 0, and the others at 1.
bool are_listed(const std::vector<bool>& at_zero, Target target) {
  const int count = static_cast<int>(at_zero.size());
  Candidates candidates;
  candidates.reserve(count, 0);
  const CandidateArrays arrays = candidates.arrays();
  std::vector<int> expected;
  for (int k = 0; k < count; ++k) {
    for (float* side : arrays.box) side[k] = at_zero[k] ? 0.f : 1.f;
    arrays.triangle[k] = k;
    if (at_zero[k]) expected.push_back(k);
  }
  const Box<float> zero{{0, 0, 0}, {0, 0, 0}};
  const int found = cluster_pair_kernels(target).keep(count, zero, arrays);
  return std::vector<int>(arrays.triangle, arrays.triangle + found) == expected;
}

}  // namespace

PROPTEST(lane_bits) {
  t.example("every lane has its own bit, on every target, and lanes behind the last have none", {}, [] {
    std::mt19937 random(1);
    long wrong = 0, tried = 0;
    for (const Target target : available_targets())
      for (int count = 1; count <= 70; ++count)
        for (int times = 0; times < 8; ++times, ++tried) {
          std::vector<bool> at_zero(count);
          for (int k = 0; k < count; ++k) at_zero[k] = times == 0 || (times > 1 && random() % 2);
          wrong += !are_listed(at_zero, target);
        }
    return Checked(wrong == 0, tried);
  });
  t.example("in the baseline's width too", {}, [] {
    using S = Pack<float>;
    bool ok = true;
    for (std::uint32_t bits = 0; bits < 1u << S::size(); ++bits) {
      const S lanes([&](auto lane) { return static_cast<float>(bits >> lane & 1); });
      ok = ok && lane_bits(lanes > S(0.5f)) == bits;
    }
    return Checked(ok, 1 << S::size());
  });
}

}  // namespace proptests::suite_lane_bits
