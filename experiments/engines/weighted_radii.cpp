// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/weighted_radii.hpp"

#include <algorithm>

#include "lemmas/a4_joint_volumes.hpp"

namespace refitlab {
namespace {

constexpr int radius_passes = 12;
using Inequality = std::vector<WeightedDistance>;

double lack_of(const Inequality& inequality, const std::vector<double>& radii) {
  double lack = 0;
  for (const WeightedDistance& t : inequality) lack += lack_of_growth<double>(t.weight, t.distance, radii[t.joint]);
  return lack;
}

// Raises radii, in the proportion of weights, until the inequality holds.
void satisfy(const Inequality& inequality, std::vector<double>& radii) {
  const double lack = lack_of(inequality, radii);
  if (lack <= 0) return;
  double sum = 0;
  for (const WeightedDistance& t : inequality) sum += t.weight * t.weight;
  for (const WeightedDistance& t : inequality) radii[t.joint] += lack * t.weight / sum;
}

}  // namespace

std::vector<double> weighted_radii(const std::vector<Inequality>& inequalities, std::vector<double> radii) {
  struct Use {
    const Inequality* inequality;
    double weight;
  };
  std::vector<std::vector<Use>> uses(radii.size());
  const std::vector<double> none(radii.size());
  for (const Inequality& i : inequalities) {
    satisfy(i, radii);
    if (lack_of(i, none) <= 0) continue;
    for (const WeightedDistance& t : i) uses[t.joint].push_back({&i, t.weight});
  }
  // At first they go half-way, so that all joints give way, and not some before others.
  for (int pass = 0; pass < radius_passes; ++pass)
    for (std::size_t j = 0; j < radii.size(); ++j) {
      double least = 0;
      for (const Use& use : uses[j]) least = std::max(least, radii[j] + lack_of(*use.inequality, radii) / use.weight);
      radii[j] = pass < radius_passes / 2 ? (radii[j] + least) / 2 : least;
    }
  return radii;
}

std::vector<std::vector<Point3>> own_vertices(const SkinnedMesh& mesh, double least_weight) {
  std::vector<std::vector<Point3>> own(mesh.joints.size()), moved_most(mesh.joints.size());
  std::vector<double> most(mesh.joints.size());
  std::vector<Point3> of_most(mesh.joints.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto& influences = mesh.influences[v];
    const auto by_weight = [](const Influence& a, const Influence& b) { return a.weight < b.weight; };
    moved_most[std::max_element(influences.begin(), influences.end(), by_weight)->joint].push_back(mesh.vertices[v]);
    for (const Influence& i : influences) {
      if (i.weight >= least_weight) own[i.joint].push_back(mesh.vertices[v]);
      if (i.weight > most[i.joint]) most[i.joint] = i.weight, of_most[i.joint] = mesh.vertices[v];
    }
  }
  for (std::size_t j = 0; j < own.size(); ++j) {
    if (own[j].empty()) own[j] = moved_most[j];
    if (own[j].empty() && most[j] > 0) own[j].push_back(of_most[j]);
  }
  return own;
}

}  // namespace refitlab
