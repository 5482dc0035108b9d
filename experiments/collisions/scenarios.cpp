// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/collisions/scenarios.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/runtime/balls/smallest_ball.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "experiments/collisions/detectors.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/speed/statistics.hpp"

namespace refitlab {
namespace {

Pose pose_at(const AnimatedCharacter& c, double share) {
  if (!c.clips.empty()) return c.clips[0].sample(share * c.clips[0].duration);
  return twist_pose(c.mesh, twist_joint(c.mesh), share * 170 * std::numbers::pi / 180);
}

// Returns the placement that puts a center at this place, turned about y.
RigidTransform<double> stand(const Point3& center, double turn, const Point3& at) {
  RigidTransform<double> out{{std::cos(turn / 2), 0, std::sin(turn / 2), 0}, Point3::Zero()};
  out.translation = at - rotate(out.rotation, center);
  return out;
}

Point3 deformed_center(const AnimatedCharacter& c, const Pose& pose) {
  const auto palette = make_skinning_palette(c.mesh, c.sets, pose, Skinning::spherical);
  return smallest_ball<double, 3>(skin(c.mesh, c.sets, palette, Skinning::spherical)).center;
}

class PairCounter {
 public:
  explicit PairCounter(const AnimatedCharacter& c) : detector_(detector_kind("skin_all_float").make(c)) {}

  // Returns the frames' numbers of touching pairs.
  std::vector<double> pairs(const std::vector<ScenarioFrame>& frames) {
    std::vector<double> counts;
    for (const auto& f : frames) counts.push_back(static_cast<double>(detector_->pairs(f, Query::full).size()));
    return counts;
  }

 private:
  std::unique_ptr<Detector> detector_;
};

constexpr int searched_frames = 12, bisections = 12;

bool is_any_touching(const std::vector<double>& pairs) { return *std::max_element(pairs.begin(), pairs.end()) > 0; }

// Returns the largest lateral distance up to high, within a share of 2^-bisections of it, at which holds(pairs) is true, or 0 if
// there is none.
template <class Predicate>
double largest_lateral(PairCounter& counter, const WalkPast& walk, double high, const Predicate& holds) {
  double low = 0;
  for (int i = 0; i < bisections; ++i) {
    const double middle = (low + high) / 2;
    (holds(counter.pairs(walk.at(middle))) ? low : high) = middle;
  }
  return low;
}

}  // namespace

WalkPast::WalkPast(const AnimatedCharacter& c, int frames) {
  for (int i = 0; i < frames; ++i) {
    const double share = frames > 1 ? i / (frames - 1.0) : 0.5;
    Step step{pose_at(c, share), pose_at(c, std::fmod(share + 0.5, 1.0)), {}, {}, 0};
    step.first_center = deformed_center(c, step.first);
    step.second_center = deformed_center(c, step.second);
    step.forward = (1 - 2 * share) * c.tree.nodes[0].reference.radius / 10;
    steps_.push_back(std::move(step));
  }
}

std::vector<ScenarioFrame> WalkPast::at(double lateral) const {
  std::vector<ScenarioFrame> out;
  for (const Step& s : steps_)
    out.push_back({s.first, s.second, stand(s.first_center, 0, {-lateral / 2, 0, -s.forward}),
                   stand(s.second_center, std::numbers::pi, {lateral / 2, 0, s.forward})});
  return out;
}

std::vector<ScenarioFrame> WalkPast::in_place() const {
  std::vector<ScenarioFrame> out;
  for (const Step& s : steps_)
    out.push_back(
        {s.first, s.second, stand(s.first_center, 0, Point3::Zero()), stand(s.second_center, std::numbers::pi, Point3::Zero())});
  return out;
}

std::vector<Scenario> scenarios(const AnimatedCharacter& c, int frames) {
  PairCounter counter(c);
  const WalkPast walk(c, frames), searched(c, searched_frames);
  const double reach = 2 * c.tree.nodes[0].reference.radius, step = 0.01 * reach;
  double near = largest_lateral(counter, searched, reach, is_any_touching) + step;
  while (is_any_touching(counter.pairs(walk.at(near)))) near += step;
  const double light = largest_lateral(counter, searched, reach, [&](const auto& pairs) { return median(pairs) >= 50; });
  const double heavy = largest_lateral(counter, searched, reach, [&](const auto& pairs) { return median(pairs) >= 850; });
  return {{"far", walk.at(2 * reach)},
          {"near", walk.at(near)},
          {"light", walk.at(light)},
          {"heavy", walk.at(heavy)},
          {"worst", walk.in_place()}};
}

}  // namespace refitlab
