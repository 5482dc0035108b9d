// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/vibration.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Springs along edges have stiffness 1. These are the stiffness of the springs that pull back, and the share of its speed that a
// vertex loses in a unit of time.
constexpr double stiffness_to_place = 0.02, damping = 0.003;
constexpr double time_of_frame = 4, largest_share = 0.05;

struct Spring {
  std::size_t a, b;
  Point3 direction;
};

std::vector<Spring> springs_of(const SkinnedMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles)
    for (const auto& [a, b] : {std::pair(t[0], t[1]), std::pair(t[1], t[2]), std::pair(t[2], t[0])})
      edges.insert({std::min(a, b), std::max(a, b)});
  std::vector<Spring> out;
  for (const auto& [a, b] : edges) {
    const Point3 along = mesh.vertices[static_cast<std::size_t>(b)] - mesh.vertices[static_cast<std::size_t>(a)];
    if (const double length = along.norm(); length > 0)
      out.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), along / length});
  }
  return out;
}

// Returns the speed at a place x of the model, whose longest side is 1. It goes downwards, as when the heels touch, and to the
// side.
Point3 jolt(const Point3& x) { return {0.5 * std::sin(3 * x[1]), -1 - 0.5 * std::sin(5 * x[1]), 0.4 * std::cos(4 * x[0])}; }

class Simulation {
 public:
  explicit Simulation(const SkinnedMesh& mesh) : springs_(springs_of(mesh)), places_(mesh.vertices.size(), Point3::Zero()) {
    const auto box = box_around<double>(mesh.vertices);
    size_ = box.edges().maxCoeff();
    for (const Point3& v : mesh.vertices) speeds_.push_back(jolt((v - box.center()) / size_));
    std::vector<double> springs_at(places_.size(), 0);
    for (const Spring& s : springs_) ++springs_at[s.a], ++springs_at[s.b];
    // A vertex with n springs is pulled back by at most 2 n times its displacement, so steps of this length are stable.
    const double stiffest = 2 * *std::max_element(springs_at.begin(), springs_at.end()) + stiffness_to_place;
    steps_of_frame_ = static_cast<int>(std::ceil(time_of_frame * std::sqrt(stiffest)));
  }

  double size() const { return size_; }

  // Goes on to the next frame, by symplectic steps of Euler's.
  const std::vector<Point3>& next() {
    const double step = time_of_frame / steps_of_frame_;
    for (int i = 0; i < steps_of_frame_; ++i) {
      for (std::size_t v = 0; v < places_.size(); ++v)
        speeds_[v] -= step * (stiffness_to_place * places_[v] + damping * speeds_[v]);
      for (const Spring& s : springs_) {
        const Point3 pull = s.direction * (step * s.direction.dot(places_[s.b] - places_[s.a]));
        speeds_[s.a] += pull, speeds_[s.b] -= pull;
      }
      for (std::size_t v = 0; v < places_.size(); ++v) places_[v] += step * speeds_[v];
    }
    return places_;
  }

 private:
  const std::vector<Spring> springs_;
  std::vector<Point3> places_, speeds_;  // places: displacements
  double size_ = 0;
  int steps_of_frame_ = 0;
};

}  // namespace

std::vector<std::vector<Point3>> vibration(const SkinnedMesh& mesh, int frames) {
  const DefaultFloatEnvironment environment;
  Simulation simulation(mesh);
  std::vector<std::vector<Point3>> out;
  double largest = 0;
  for (int i = 0; i < frames; ++i) {
    out.push_back(simulation.next());
    for (const Point3& d : out.back()) largest = std::max(largest, d.norm());
  }
  for (auto& frame : out)
    for (Point3& d : frame) d *= largest_share * simulation.size() / largest;
  return out;
}

}  // namespace refitlab
