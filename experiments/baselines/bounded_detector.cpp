// SPDX-License-Identifier: GPL-3.0-or-later
// This is a detector behind the first test that engines have. It compares a box around each whole character, here the motion
// bound, which is made from its joints alone. Where the boxes are apart, the detector is not asked at all. So it shows what the
// detector costs as a narrow phase, and no broad phase is compared with one by mistake.
#include <utility>

#include "algorithms/runtime/collide/motion_bound.hpp"
#include "experiments/baselines/baselines.hpp"

namespace refitlab {
namespace {

class BoundedDetector : public Detector {
 public:
  BoundedDetector(const Character& character, std::unique_ptr<Detector> detector)
      : bound_(character.mesh, character.sets, Skinning::spherical),
        detector_(std::move(detector)) {}

  void palette(const ScenarioFrame& frame) override {
    ++tests_;
    is_asked_ = !are_apart(bound_.checked_box(frame.first, frame.first_at), bound_.checked_box(frame.second, frame.second_at));
    if (is_asked_) detector_->palette(frame);
  }
  void skin() override {
    if (is_asked_) detector_->skin();
  }
  void refit() override {
    if (is_asked_) detector_->refit();
  }
  std::vector<TrianglePair> query(Query query) override {
    if (!is_asked_) return {};
    return detector_->query(query);
  }
  DetectorCounts counts() const override {
    DetectorCounts all = detector_->counts();
    all.volume_tests += tests_;
    return all;
  }

 private:
  MotionBound bound_;
  const std::unique_ptr<Detector> detector_;
  bool is_asked_ = false;
  long tests_ = 0;
};

}  // namespace

DetectorKind bounded_kind(const DetectorKind& kind) {
  DetectorKind out = kind;
  out.name += "_bounded";
  out.description = kind.name + ", asked only where boxes around the whole characters, made from their joints alone, meet";
  out.origin = Origin::bounded;
  out.make = [make = kind.make](const Character& c) { return std::make_unique<BoundedDetector>(c, make(c)); };
  out.is_minor = kind.name != "skin_all_float" && kind.name != "embree";
  return out;
}

}  // namespace refitlab
