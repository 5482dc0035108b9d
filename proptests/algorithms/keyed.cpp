// SPDX-License-Identifier: GPL-3.0-or-later
// Tests sampled clips as key frames: the poses at the keys are the clip's own, and between two keys every joint turns about one
// axis.
#include "algorithms/model/keyed.hpp"

#include <cmath>

#include "experiments/procedural/procedural.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_keyed {
namespace {

using namespace refitlab;

// Returns the largest distance between the places to which two poses take the corners of a box of this size around each joint.
double apart(const SkinnedMesh& mesh, const Pose& a, const Pose& b) {
  double worst = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (const Point3& by : {Point3(0.1, 0, 0), Point3(0, 0.1, 0), Point3(0, 0, 0.1)})
      worst = std::max(
          worst, (apply(a[j], Point3(mesh.joints[j].origin + by)) - apply(b[j], Point3(mesh.joints[j].origin + by))).norm());
  return worst;
}

std::string refusal(const Model& model, double rate) {
  try {
    keyed(model, rate);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

PROPTEST(keyed) {
  t.example("the man's and the creature's poses at the keys are those of their clips, and between them nearly", {}, [] {
    double at_keys = 0, between = 0;
    long poses = 0;
    for (const Model& model : {make_man(), make_creature()}) {
      const Model k = keyed(model, 60);
      for (std::size_t c = 0; c < model.clips.size(); ++c) {
        const Clip &from = model.clips[c], &to = k.clips[c];
        if (to.name != from.name || to.duration != from.duration) return Checked(false, poses, "another clip");
        for (const double time : key_times(to.animation, 1000)) {
          at_keys = std::max(at_keys, apart(model, from.sample(time), to.sample(time)));
          const double later = std::min(time + 1 / 120.0, from.duration);
          between = std::max(between, apart(model, from.sample(later), to.sample(later)));
          poses += 2;
        }
      }
    }
    return Checked(at_keys < 1e-12 && between < 5e-3 && between > at_keys, poses, std::to_string(between));
  });
  t.example("there are as many keys as the rate says, and one at the end", {}, [] {
    const Model model = make_snake(3);
    const double duration = model.clips[0].duration;
    bool good = true;
    for (const double rate : {1 / duration, 2.5 / duration, 30.0}) {
      const Animation animation = keyed(model, rate).clips[0].animation;
      for (const NodeTrack& track : animation.tracks) {
        good = good && track.positions.keys.size() == std::size_t(std::ceil(duration * rate - 1e-9)) + 1 &&
               track.rotations.keys.size() == track.positions.keys.size() && track.rotations.keys.back().time == duration;
        good = good && track.positions.keys[1].time == std::min(1 / rate, duration);
      }
    }
    return Checked(good, 9);
  });
  t.example("a rate that is no rate is refused", {}, [] {
    const Model model = make_snake(1);
    bool good = true;
    for (const double rate : {0.0, -1.0, double(NAN), double(INFINITY), 1e9})
      good = good && refusal(model, rate).find("clip 'wave': cannot have ") != std::string::npos;
    return Checked(good, 5);
  });
}

}  // namespace proptests::suite_keyed
