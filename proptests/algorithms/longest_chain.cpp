// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the number type that knows the chains of operations, and the chains of refits that are known by hand.
#include "experiments/speed/longest_chain.hpp"

#include "algorithms/bake/build_tree.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_longest_chain {
namespace {

using namespace refitlab;

// Returns the longest chains of a triangle's refits, which one joint moves: of linear skinning, and of spherical skinning.
std::pair<double, double> chains(const Latencies& latencies) {
  SkinnedMesh model;
  model.name = "a triangle of one joint";
  model.joints = {{"a", -1, Point3::Zero()}};
  model.vertices = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
  model.triangles = {{0, 1, 2}};
  model.influences.assign(3, {{0, 1.0}});
  const JointSets sets(model);
  const SphereTree tree = build_sphere_tree(model, sets);
  const Pose pose = {{{0.6, 0.8, 0, 0}, {1, 2, 3}}};
  return {longest_chain(tree, make_skinning_palette(model, sets, pose, Skinning::linear), true, latencies),
          longest_chain(tree, make_skinning_palette(model, sets, pose, Skinning::spherical), false, latencies)};
}

}  // namespace

PROPTEST(longest_chain) {
  t.example("each operation begins when the later of its operands is there, and takes its latency", {}, [] {
    Chained::latencies = {.sum = 3, .product = 4, .quotient = 13, .root = 20};
    const Chained a(5, 100), b(4, 7);
    return (a + b).ready == 103 && (b - a).ready == 103 && (a * b).ready == 104 && (b / a).ready == 113 && sqrt(b).ready == 27 &&
           (-a).ready == 100 && (a + b * b).ready == 103 && (b + a * a).ready == 107 && max_of(a, b).ready == 100 &&
           min_of(a, b).ready == 7 && (a + b).value == 9 && (b - a).value == -1 && (a * b).value == 20 && (b / a).value == 0.8 &&
           sqrt(b).value == 2;
  });
  t.example(
      "of one weight vertex, a linear refit has one root, that of a distance, and a spherical one has three in a row: of the "
      "blend's length, of the direction's, and of a distance or of the cap's ball",
      {}, [] {
        const auto [linear, spherical] = chains({.root = 1});
        return Checked(linear == 1 && spherical == 3, 2, std::to_string(linear) + " and " + std::to_string(spherical));
      });
  t.example("chains add up: those of all operations are at least those of each kind, and at most their sum", {}, [] {
    const Latencies all{.sum = 3, .product = 4, .quotient = 13, .root = 20};
    const auto whole = chains(all);
    const std::pair<double, double> parts[] = {chains({.sum = all.sum}), chains({.product = all.product}),
                                               chains({.quotient = all.quotient}), chains({.root = all.root})};
    std::pair<double, double> sum{0, 0};
    bool is_least = true;
    for (const auto& part : parts) {
      sum.first += part.first, sum.second += part.second;
      is_least = is_least && whole.first > part.first && whole.second > part.second;
    }
    return Checked(is_least && whole.first <= sum.first && whole.second <= sum.second && whole.first < whole.second, 4,
                   std::to_string(whole.first) + " and " + std::to_string(whole.second));
  });
}

}  // namespace proptests::suite_longest_chain
