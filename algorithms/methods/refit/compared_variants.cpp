// SPDX-License-Identifier: MIT
#include "algorithms/methods/refit/compared_variants.hpp"

#include <algorithm>

#include "algorithms/methods/refit/algorithm1_printed.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// This is flattened, because otherwise GCC at -O2 calls each product of two vectors.
template <class Policy, Signs signs>
[[gnu::flatten]] Ball3<double> printed(const RefitNode<double>& node) {
  const DefaultFloatEnvironment environment;
  thread_local RefitLists<double> reused;
  return refit_algorithm1_printed<Policy>(node, signs, reused);
}

template <class Policy, Signs signs>
RefitVariant variant(std::string name, std::string description) {
  return {std::move(name), std::move(description), Skinning::spherical,   false,
          Pieces::node,    printed<Policy, signs>, printed<Policy, signs>};
}

}  // namespace

const std::vector<RefitVariant>& compared_variants() {
  static const std::vector<RefitVariant> variants = [] {
    const RefitVariant printed_ones[] = {
        variant<MeanBalls, Signs::of_matrices>("spherical_printed", "Algorithm 1 as printed"),
        variant<MeanBalls, Signs::of_skinning>("spherical_printed_signed",
                                               "Algorithm 1 as printed, but with the skinning's quaternion signs"),
        variant<SmallestBalls, Signs::of_skinning>("spherical_printed_miniball", "the same with smallest balls in R4 and R3"),
    };
    std::vector<RefitVariant> all = refit_variants();
    const auto repaired =
        std::find_if(all.begin(), all.end(), [](const RefitVariant& v) { return v.name == "spherical_repaired"; });
    all.insert(repaired, std::begin(printed_ones), std::end(printed_ones));
    return all;
  }();
  return variants;
}

const RefitVariant& compared_variant(const std::string& name) { return variant_named(name, compared_variants()); }

}  // namespace refitlab
