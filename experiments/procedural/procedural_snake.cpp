// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "experiments/procedural/procedural.hpp"

namespace refitlab {
namespace {

constexpr double length = 10, radius = 0.15;  // metres
constexpr int sides = 8, rings = 1250;

std::vector<Joint> spine(int joints) {
  std::vector<Joint> out;
  for (int j = 0; j < joints; ++j) out.push_back({"spine_" + std::to_string(j), j - 1, {0, radius, length * j / joints}});
  return out;
}

// Returns influences that are linear between the two joints whose bones' middles are next to this place along the body.
std::vector<Influence> influences_at(double along, int joints) {
  const double place = along / length * joints - 0.5;
  const double share = place - std::floor(place);
  const int before = static_cast<int>(std::floor(place));
  std::vector<std::pair<int, double>> weights;
  for (const auto& [joint, weight] : {std::pair(before, 1 - share), std::pair(before + 1, share)})
    weights.emplace_back(std::min(std::max(joint, 0), joints - 1), weight);
  std::vector<Influence> out;
  for (const auto& [joint, weight] : quantize_weights(weights)) out.push_back({joint, weight});
  return out;
}

// Each joint turns against its parent, left and right in a wave that runs down the body. A period is twice its length. All turns
// together are no more than a radian each way.
Pose wave(const std::vector<Joint>& joints, double phase) {
  const double n = static_cast<double>(joints.size());
  Pose c;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double angle = std::numbers::pi / n * std::cos(2 * std::numbers::pi * (phase + 2 * static_cast<double>(j) / n));
    RigidTransform<double> local{{std::cos(angle / 2), 0, std::sin(angle / 2), 0}, Point3::Zero()};
    local.translation = joints[j].origin - rotate(local.rotation, joints[j].origin);
    c.push_back(j == 0 ? local : compose(c.back(), local));
    c.back().rotation /= norm(c.back().rotation);
  }
  return c;
}

}  // namespace

Model make_snake(int joints) {
  const DefaultFloatEnvironment environment;
  if (joints < 1) throw ModelError("generated snake", "joints", "there has to be one at least");
  Model m;
  m.name = "snake of " + std::to_string(joints) + " joints";
  m.joints = spine(joints);
  const auto add_vertex = [&](const Point3& at) {
    m.vertices.push_back(at);
    m.influences.push_back(influences_at(at[2], joints));
    return static_cast<int>(m.vertices.size()) - 1;
  };
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sides; ++s) {
      const double angle = 2 * std::numbers::pi * s / sides;
      add_vertex({radius * std::cos(angle), radius * (1 + std::sin(angle)), length * r / (rings - 1)});
    }
  const auto vertex = [](int ring, int side) { return ring * sides + side % sides; };
  for (int r = 0; r + 1 < rings; ++r)
    for (int s = 0; s < sides; ++s) {
      m.triangles.push_back({vertex(r, s), vertex(r, s + 1), vertex(r + 1, s + 1)});
      m.triangles.push_back({vertex(r, s), vertex(r + 1, s + 1), vertex(r + 1, s)});
    }
  const int tail = add_vertex({0, radius, 0}), nose = add_vertex({0, radius, length});
  for (int s = 0; s < sides; ++s) {
    m.triangles.push_back({tail, vertex(0, s + 1), vertex(0, s)});
    m.triangles.push_back({nose, vertex(rings - 1, s), vertex(rings - 1, s + 1)});
  }
  m.clips.push_back({"wave", 1, [joints = m.joints](double time) {
                       const DefaultFloatEnvironment environment;
                       return wave(joints, time);
                     }});
  validate(m);
  return m;
}

}  // namespace refitlab
