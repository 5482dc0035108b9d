// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/procedural/procedural_skeleton.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "algorithms/runtime/mesh/quantize.hpp"

namespace refitlab {
namespace {

constexpr std::size_t most_influences = 4;
constexpr double sharpness = 2;  // the larger, the narrower the blends
constexpr double negligible_weight = 0.05;

double distance_to_bone(const Point3& p, const Bone& bone) {
  const Point3 along = bone.tip - bone.origin;
  const double t = std::clamp(dot(Point3(p - bone.origin), along) / squared_norm(along), 0., 1.);
  return norm(Point3(p - bone.origin - t * along));
}

// Keeps the largest weights, each lowered by the largest one that is left out. So a weight fades to zero before it is dropped,
// and the result is continuous.
std::vector<Influence> keep_largest(const Eigen::RowVectorXd& weights) {
  std::vector<double> sorted(weights.begin(), weights.end());
  std::sort(sorted.rbegin(), sorted.rend());
  const double floor = std::max(negligible_weight, sorted.size() > most_influences ? sorted[most_influences] : 0.);
  std::vector<std::pair<int, double>> kept;
  for (int j = 0; j < weights.size(); ++j)
    if (weights[j] > floor) kept.emplace_back(j, weights[j] - floor);
  std::vector<Influence> influences;
  for (const auto& [joint, weight] : quantize_weights(kept)) influences.push_back({joint, weight});
  return influences;
}

int index_of(const std::vector<Bone>& bones, const std::string& name) {
  for (std::size_t i = 0; i < bones.size(); ++i)
    if (bones[i].name == name) return int(i);
  return -1;
}

}  // namespace

std::vector<Joint> joints_of(const std::vector<Bone>& bones) {
  std::vector<Joint> joints;
  for (const Bone& bone : bones) joints.push_back({bone.name, index_of(bones, bone.parent), bone.origin});
  return joints;
}

void add_pair(std::vector<Bone>& bones, const std::vector<Bone>& left_side) {
  for (const std::string side : {"left_", "right_"})
    for (Bone bone : left_side) {
      bone.name = side + bone.name;
      if (index_of(bones, side + bone.parent) >= 0) bone.parent = side + bone.parent;
      if (side == "right_") bone.origin = mirrored(bone.origin), bone.tip = mirrored(bone.tip);
      bones.push_back(bone);
    }
}

std::vector<std::vector<Influence>> heat_weights(const SkinMesh& skin, const std::vector<Bone>& bones) {
  const int n = int(skin.vertices.size());
  // These are the Laplacian of the skin with cotangent coefficients, and the area that belongs to each vertex.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd area = Eigen::VectorXd::Zero(n);
  for (const Triangle& triangle : skin.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
      const Point3 ab = skin.vertices[b] - skin.vertices[a], ac = skin.vertices[c] - skin.vertices[a];
      const double twice_area = norm(cross(ab, ac));
      const double conductance = std::max(0.5 * dot(ab, ac) / twice_area, 0.);  // >= 0: no weight leaves [0, 1]
      area[a] += twice_area / 6;
      entries.insert(entries.end(), {{b, b, conductance}, {c, c, conductance}, {b, c, -conductance}, {c, b, -conductance}});
    }
  Eigen::MatrixXd heat = Eigen::MatrixXd::Zero(n, Eigen::Index(bones.size()));
  for (int v = 0; v < n; ++v) {
    const Point3& p = skin.vertices[v];
    const auto nearest = std::min_element(bones.begin(), bones.end(), [&](const Bone& x, const Bone& y) {
      return distance_to_bone(p, x) - x.thickness < distance_to_bone(p, y) - y.thickness;
    });
    const double conductance = sharpness * area[v] / sq(nearest->thickness);
    entries.emplace_back(v, v, conductance);
    heat(v, nearest - bones.begin()) = conductance;
  }
  Eigen::SparseMatrix<double> system(n, n);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd weights = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(system).solve(heat);

  std::vector<std::vector<Influence>> influences;
  for (int v = 0; v < n; ++v) influences.push_back(keep_largest(weights.row(v)));
  return influences;
}

}  // namespace refitlab
