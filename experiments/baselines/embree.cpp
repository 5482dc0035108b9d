// SPDX-License-Identifier: GPL-3.0-or-later
// This is Embree's rtcCollide on user geometry with the boxes of the placed triangles, which are refitted.
#include <embree3/rtcore.h>

#include <stdexcept>

#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/float_boxes.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

class Embree : public SkinningDetector {
 public:
  explicit Embree(const Character& character) : SkinningDetector(character, Placing::all), device_(rtcNewDevice("threads=1")) {
    for (int side = 0; side < 2; ++side) {
      bodies_[side] = {this, side};
      boxes_[side].resize(character.mesh.triangles.size());
      RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
      rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(character.mesh.triangles.size()));
      rtcSetGeometryUserData(geometry, &bodies_[side]);
      rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
      rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
      scenes_[side] = rtcNewScene(device_);
      rtcSetSceneFlags(scenes_[side], RTC_SCENE_FLAG_DYNAMIC);
      rtcSetSceneBuildQuality(scenes_[side], RTC_BUILD_QUALITY_LOW);  // the only one that refits
      rtcAttachGeometry(scenes_[side], geometry);
      geometries_[side] = geometry;
    }
  }
  ~Embree() override {
    for (int side = 0; side < 2; ++side) {
      rtcReleaseGeometry(geometries_[side]);
      rtcReleaseScene(scenes_[side]);
    }
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void refit() override {
    for (int side = 0; side < 2; ++side) {
      vertices_[side].set(placed(side));
      rtcCommitGeometry(geometries_[side]);
      rtcCommitScene(scenes_[side]);
    }
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree: cannot refit");
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    rtcCollide(scenes_[0], scenes_[1], add, this);
    return candidates_.found();
  }

 private:
  struct Body {
    Embree* self;
    int side;
  };

  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& [self, side] = *static_cast<const Body*>(arguments->geometryUserPtr);
    RowBox<float>& box = self->boxes_[side][arguments->primID];
    box = self->vertices_[side].box(self->model().triangles[arguments->primID]);
    *arguments->bounds_o = {box.low[0], box.low[1], box.low[2], 0, box.high[0], box.high[1], box.high[2], 0};
  }

  // Embree lists all pairs of two leaves, so their boxes are compared here. It cannot be stopped: after the first pair that
  // touches, the others are let through.
  static void add(void* user, RTCCollision* collisions, unsigned count) {
    Embree& self = *static_cast<Embree*>(user);
    for (unsigned i = 0; i < count && !self.candidates_.is_done(); ++i) {
      const unsigned first = collisions[i].primID0, second = collisions[i].primID1;
      if (do_meet(self.boxes_[0][first], self.boxes_[1][second]))
        self.candidates_.add(static_cast<int>(first), static_cast<int>(second));
    }
  }

  static bool do_meet(const RowBox<float>& a, const RowBox<float>& b) {
    const auto apart = (a.high < b.low) | (b.high < a.low);
    return (apart[0] | apart[1] | apart[2]) == 0;
  }

  RTCDevice device_;
  RTCScene scenes_[2];
  RTCGeometry geometries_[2];
  Body bodies_[2];
  RoundedVertices vertices_[2];
  std::vector<RowBox<float>> boxes_[2];  // by triangle, as Embree has them
};

}  // namespace

std::unique_ptr<Detector> make_embree(const Character& character) { return std::make_unique<Embree>(character); }

}  // namespace refitlab
