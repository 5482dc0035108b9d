// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/mesh/quantize.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "lemmas/exact/exact.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_quantize {
namespace {

using namespace refitlab;
using Weights = std::vector<std::pair<int, double>>;

// Draws zeros, shares of a few digits as files have them, and any magnitude that a double can have.
rc::Gen<double> weight() {
  return rc::gen::weightedOneOf<double>(
      {{1, rc::gen::element(0.0, 5e-324, std::numeric_limits<double>::max(), 0x1p-24, 0x1p-25, 1.0)},
       {3, rc::gen::map(gen::between(0, 256), [](int k) { return k / 255.0; })},
       {2, rc::gen::map(gen::between(0, 1 << 24), [](int k) { return k * 0x1p-24; })},
       {1, rc::gen::apply([](int m, int e) { return std::ldexp(m, e); }, gen::between(1, 1 << 30), gen::between(-1100, 990))}});
}

// Draws a list of weights. Half of the lists are plain: up to four joints, each once, with weights of 8 bits.
Weights draw() {
  if (*rc::gen::arbitrary<bool>()) {
    Weights list = *rc::gen::mapcat(rc::gen::inRange(1, 5), [](int n) {
      return rc::gen::container<Weights>(n,
                                         rc::gen::map(rc::gen::inRange(1, 256), [](int k) { return std::pair(0, k / 255.0); }));
    });
    for (std::size_t i = 0; i < list.size(); ++i) list[i].first = static_cast<int>(7 * i % 5);
    return list;
  }
  const int joints = *rc::gen::inRange(1, 9);
  const auto list = *rc::gen::nonEmpty(rc::gen::container<Weights>(rc::gen::pair(rc::gen::inRange(0, joints), weight())));
  bool positive = false;
  for (const auto& [joint, w] : list) positive = positive || w > 0;
  RC_PRE(positive);
  return list;
}

// Returns the share of each joint, exactly.
std::map<int, Rational> shares_of(const Weights& weights) {
  std::map<int, Rational> by_joint;
  Rational sum(0);
  for (const auto& [joint, w] : weights) by_joint[joint] += Rational(w), sum += Rational(w);
  for (auto& [joint, share] : by_joint) share /= sum;
  return by_joint;
}

void classify(const Weights& weights) {
  std::map<int, int> count;
  bool extreme = false, repeated = false;
  for (const auto& [joint, w] : weights) {
    repeated = repeated || ++count[joint] > 1;
    extreme = extreme || w == 0 || w < 1e-30 || w > 1e30;
  }
  RC_CLASSIFY(repeated || extreme || weights.size() == 1, "degenerate");
  RC_CLASSIFY(repeated, "repeated joint");
}

}  // namespace

PROPTEST(quantize) {
  t.holds("the weights are positive multiples of 2^-24 of distinct joints in order, and sum to exactly 1",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.3}, [] {
            const Weights in = draw();
            classify(in);
            const auto shares = shares_of(in);
            Rational sum(0);
            int last = -1;
            for (const auto& [joint, w] : quantize_weights(in)) {
              RC_ASSERT(joint > last && shares.count(joint) == 1u);
              last = joint;
              RC_ASSERT(w > 0 && std::ldexp(w, 24) == std::floor(std::ldexp(w, 24)));
              sum += Rational(w);
            }
            RC_ASSERT(sum == Rational(1));
          });
  t.holds("no weight is 2^-24 (1 + 1e-7) or more from its joint's share of the sum, dropped ones included",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.3}, [] {
            const Weights in = draw();
            classify(in);
            auto error = shares_of(in);
            for (const auto& [joint, w] : quantize_weights(in)) error[joint] -= Rational(w);
            for (const auto& [joint, e] : error) RC_ASSERT(abs(e) < Rational(0x1p-24 * (1 + 1e-7)));
          });
  t.holds("each joint with a weight is either kept or lost, and what is lost has its share of the sum, which is below 2^-24",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.3, .tags_at_least = {{"lost", 0.1}}}, [] {
            const Weights in = draw();
            classify(in);
            auto left = shares_of(in);
            // This was there before, and is replaced.
            Weights lost = {{-1, 1.0}};
            const Weights kept = quantize_weights(in, &lost);
            RC_ASSERT(kept == quantize_weights(in));
            for (const auto& [joint, weight] : kept) RC_ASSERT(left.erase(joint) == 1u);
            int last = -1;
            for (const auto& [joint, share] : lost) {
              RC_ASSERT(joint > last && share > 0 && share < 0x1p-24 && left.count(joint) == 1u);
              RC_ASSERT(abs(left[joint] - Rational(share)) <= left[joint] * Rational(1e-14) + Rational(5e-324));
              left.erase(last = joint);
            }
            // The other joints have no share, or one that is 0 beside the greatest in double.
            for (const auto& [joint, share] : left) RC_ASSERT(share < Rational(std::numeric_limits<double>::min()));
            if (!lost.empty()) RC_TAG("lost");
          });
  t.holds("the order of the shares stays where they differ by more than rounding",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.3}, [] {
            const Weights in = draw();
            classify(in);
            std::map<int, double> out;
            for (const auto& [joint, w] : quantize_weights(in)) out[joint] = w;
            const auto shares = shares_of(in);
            for (const auto& [a, share_a] : shares)
              for (const auto& [b, share_b] : shares)
                if (share_a > share_b + Rational(1e-13)) RC_ASSERT(out[a] >= out[b]);
          });
  t.holds("weights that are exact already do not change", {.cases = 2000, .degenerate_at_least = 0.3}, [] {
    const Weights in = draw();
    classify(in);
    const Weights once = quantize_weights(in);
    RC_ASSERT(quantize_weights(once) == once);
  });
  t.holds("a common factor that is a power of two does not matter", {.cases = 2000}, [] {
    Weights in = *rc::gen::nonEmpty(rc::gen::container<Weights>(
        rc::gen::pair(rc::gen::inRange(0, 9), rc::gen::map(rc::gen::inRange(1, 1000), [](int k) { return k / 1000.0; }))));
    const Weights plain = quantize_weights(in);
    const int exponent = *gen::between(-900, 1000);
    for (auto& [joint, w] : in) w = std::ldexp(w, exponent);
    RC_ASSERT(quantize_weights(in) == plain);
  });
  t.example("repeated joints merge, zeros and tiny weights vanish, a third is a third", {}, [] {
    const double third = 5592405 * 0x1p-24, more = 5592406 * 0x1p-24;
    return quantize_weights({{4, 0.25}, {1, 0.5}, {4, 0.25}}) == Weights{{1, 0.5}, {4, 0.5}} &&
           quantize_weights({{0, 1.0}, {1, 1e-9}, {2, 0.0}}) == Weights{{0, 1.0}} &&
           quantize_weights({{0, 1e308}, {1, 1e308}}) == Weights{{0, 0.5}, {1, 0.5}} &&
           quantize_weights({{0, 5e-324}, {1, 5e-324}}) == Weights{{0, 0.5}, {1, 0.5}} &&
           quantize_weights({{2, 1.0}, {1, 1.0}, {0, 1.0}}) == Weights{{0, more}, {1, third}, {2, third}};
  });
}

}  // namespace proptests::suite_quantize
