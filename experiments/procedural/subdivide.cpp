// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/procedural/subdivide.hpp"

#include <algorithm>
#include <map>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

constexpr std::size_t most_influences = 4;

std::vector<Influence> mean(const std::vector<Influence>& a, const std::vector<Influence>& b) {
  std::map<int, double> sums;
  for (const auto* ends : {&a, &b})
    for (const Influence& i : *ends) sums[i.joint] += i.weight;
  std::vector<std::pair<int, double>> weights(sums.begin(), sums.end());
  std::stable_sort(weights.begin(), weights.end(), [](const auto& x, const auto& y) { return x.second > y.second; });
  weights.resize(std::min(weights.size(), most_influences));
  std::vector<Influence> out;
  for (const auto& [joint, weight] : quantize_weights(weights)) out.push_back({joint, weight});
  return out;
}

}  // namespace

Model subdivide(const Model& model) {
  const DefaultFloatEnvironment environment;
  Model out = model;
  std::map<std::pair<int, int>, int> middles;  // by edge
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(out.vertices.size()));
    if (is_new) {
      out.vertices.push_back((model.vertices[a] + model.vertices[b]) / 2);
      out.influences.push_back(mean(model.influences[a], model.influences[b]));
    }
    return place->second;
  };
  out.triangles.clear();
  out.sources.clear();  // of the coarser triangles
  for (const auto& [a, b, c] : model.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    out.triangles.insert(out.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  validate(out);
  return out;
}

}  // namespace refitlab
