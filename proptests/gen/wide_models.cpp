// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/wide_models.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/runtime/mesh/quantize.hpp"

namespace proptests::gen {

using namespace refitlab;

namespace {

constexpr int least_exponent = -1074, greatest_exponent = 132;  // of 1e40

class Drawing {
 public:
  explicit Drawing(std::mt19937& random) : random_(random) {}

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double normal() { return normal_(random_); }
  Point3 point() { return {normal(), normal(), normal()}; }
  Quaternion<double> rotation() { return Quaternion<double>(normal(), normal(), normal(), normal()).normalized(); }

  // Draws an exponent from the least denormal to the largest coordinate; half of them are in the range of refits in single
  // precision.
  int exponent() { return least_exponent + below((below(2) ? 50 : greatest_exponent) - least_exponent + 1); }

 private:
  std::mt19937& random_;
  std::normal_distribution<double> normal_;
};

Point3 in_range(const Point3& p, int exponent) {
  Point3 out;
  for (int i = 0; i < 3; ++i) out[i] = std::clamp(std::ldexp(p[i], exponent), -largest_coordinate, largest_coordinate);
  return out;
}

constexpr int shape_kinds = 7;
Point3 position(Drawing& d, int shape, int v, const std::vector<Point3>& before) {
  Point3 p = d.point();
  switch (shape) {
    case 1: return v > 0 && d.below(3) ? before[d.below(v)] : p;
    case 2: return Point3(1, 2, -0.5) * (0.1 * d.below(7));
    case 3: return Point3(d.below(3), d.below(3), d.below(3));
    case 4: return p.normalized();
    case 5: return Point3::Unit(v / 2 % 3) * (v % 2 ? 1 : -1);
    case 6: return {1, 2, 3};
    default: return p;
  }
}

constexpr int turn_kinds = 6;
Quaternion<double> turn(Drawing& d, int kind, const Quaternion<double>& common) {
  switch (kind) {
    case 0: return identity_quaternion<double>();
    case 1: return common;
    case 2: return (common + d.rotation() * std::ldexp(1., -d.below(40))).normalized();
    case 3: return Quaternion<double>::Unit(1 + d.below(3));
    // It is nearly a half-turn one way or the other.
    case 4: {
      const double near = std::ldexp(1., -d.below(30)), side = d.below(2) ? 1 : -1;
      return Quaternion<double>(near, side, 0.1 * near * d.normal(), 0.1 * near * d.normal()).normalized();
    }
    default: return d.rotation();
  }
}

constexpr int defect_kinds = 5;
Quaternion<double> with_defect(Drawing& d, int kind, const Quaternion<double>& q) {
  switch (kind) {
    case 0: return q;
    case 1: return q.cast<float>().cast<double>();
    case 2: return of_defect(q, 1e-6);
    case 3: return of_defect(q, -1e-6);
    default: return of_defect(q, 1e-6 * (2 * d.below(2) - 1) * std::ldexp(1., -d.below(20)));
  }
}

std::vector<std::pair<int, double>> weights(Drawing& d, const std::vector<int>& joints) {
  const int kind = d.below(3), heavy = d.below(static_cast<int>(joints.size()));
  std::vector<std::pair<int, double>> out;
  for (std::size_t i = 0; i < joints.size(); ++i)
    out.emplace_back(joints[i], kind == 0                      ? 1.
                                : kind == 1                    ? 0.02 + std::pow(std::abs(d.normal()), 3)
                                : static_cast<int>(i) == heavy ? 1.
                                                               : 0x1p-24);
  return out;
}

}  // namespace

Quaternion<double> of_defect(const Quaternion<double>& unit, double defect) {
  for (;; defect *= 1 - 1e-12) {
    const Quaternion<double> q = unit * std::sqrt(1 + defect);
    if (std::abs(squared_norm(q) - 1) <= 1e-6) return q;
  }
}

WideModel wide_model(std::mt19937& random, int most_joints) {
  Drawing d(random);
  WideModel out;
  SkinnedMesh& m = out.mesh;
  m.name = "wide";
  const int joint_counts[] = {1, 2, 3, 4, 5, 6, 9, 33, 90};
  const int joints = std::min(most_joints, joint_counts[d.below(9)]);
  const int sizes = d.below(4), common = sizes == 0 ? 0 : d.exponent(), shape = d.below(shape_kinds);
  const auto exponent = [&] { return sizes < 2 ? common : sizes == 2 ? d.exponent() : d.below(2) ? 0 : common; };
  for (int j = 0; j < joints; ++j) m.joints.push_back({"joint " + std::to_string(j), j - 1, in_range(d.point(), exponent())});

  std::vector<std::vector<int>> sets(1 + d.below(4));
  for (auto& set : sets) {
    const int kind = d.below(3), size = kind == 0 ? 1 : kind == 1 ? joints : 1 + d.below(joints);
    for (int j = 0; j < joints; ++j) set.push_back(j);
    std::shuffle(set.begin(), set.end(), random);
    set.resize(size);
  }
  const int vertices = shape == 5 ? 6 : 3 + d.below(joints > 30 ? 10 : 22);
  std::vector<Point3> before;
  for (int v = 0; v < vertices; ++v) {
    before.push_back(position(d, shape, v, before));
    m.vertices.push_back(in_range(before.back(), exponent()));
    m.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights(d, sets[d.below(static_cast<int>(sets.size()))])))
      m.influences.back().push_back({joint, weight});
  }
  const int triangles = 1 + d.below(30), leaves[] = {1, 1, 2, 8, 1000};
  for (int t = 0; t < triangles; ++t) m.triangles.push_back({d.below(vertices), d.below(vertices), d.below(vertices)});
  // It is an octahedron, all of whose vertices are in one node.
  if (shape == 5)
    for (int v = 0; v < 6; v += 3) m.triangles.push_back({v, v + 1, v + 2});
  out.triangles_per_leaf = leaves[d.below(5)];
  validate(m);

  const int turns = d.below(turn_kinds), defects = d.below(defect_kinds), moves = d.below(4);
  const Quaternion<double> about = d.below(2) ? d.rotation() : Quaternion<double>::Unit(1 + d.below(3));
  out.pose = reference_pose(m);
  for (auto& t : out.pose) {
    t.rotation = with_defect(d, defects, turn(d, turns, about));
    if (moves > 0) t.translation = in_range(d.point(), moves == 1 ? common : moves == 2 ? 0 : d.exponent());
  }
  out.largest_length = 0, out.least_coordinate = largest_coordinate;
  for (const Point3& v : m.vertices)
    for (const double x : v)
      if (x != 0) out.least_coordinate = std::min(out.least_coordinate, std::abs(x));
  for (const Point3& v : m.vertices) out.largest_length = std::max(out.largest_length, v.stableNorm());
  for (const Joint& j : m.joints) out.largest_length = std::max(out.largest_length, j.origin.stableNorm());
  for (const auto& t : out.pose) out.largest_length = std::max(out.largest_length, t.translation.stableNorm());
  out.what = std::to_string(joints) + " joints, " + std::to_string(vertices) + " vertices of shape " + std::to_string(shape) +
             ", sizes " + std::to_string(sizes) + " by 2^" + std::to_string(common) + ", turns " + std::to_string(turns) +
             ", defects " + std::to_string(defects) + ", moves " + std::to_string(moves) + ", leaves of " +
             std::to_string(out.triangles_per_leaf);
  return out;
}

}  // namespace proptests::gen
