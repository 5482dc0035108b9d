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
    query_ = query;
    found_.clear();
    rtcCollide(scenes_[0], scenes_[1], decide, this);
    return found_;
  }

 private:
  struct Body {
    const Embree* self;
    int side;
  };

  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& [self, side] = *static_cast<const Body*>(arguments->geometryUserPtr);
    const RowBox<float> box = self->vertices_[side].box(self->model().triangles[arguments->primID]);
    *arguments->bounds_o = {box.low[0], box.low[1], box.low[2], 0, box.high[0], box.high[1], box.high[2], 0};
  }

  // Embree cannot be stopped. After the first pair the others are let through undecided.
  static void decide(void* user, RTCCollision* collisions, unsigned count) {
    Embree& self = *static_cast<Embree*>(user);
    for (unsigned i = 0; i < count; ++i) {
      if (self.query_ == Query::yes_no && !self.found_.empty()) return;
      const int first = static_cast<int>(collisions[i].primID0), second = static_cast<int>(collisions[i].primID1);
      if (self.touch(first, second)) self.found_.push_back({first, second});
    }
  }

  RTCDevice device_;
  RTCScene scenes_[2];
  RTCGeometry geometries_[2];
  Body bodies_[2];
  RoundedVertices vertices_[2];
  Query query_ = Query::full;
  std::vector<TrianglePair> found_;
};

}  // namespace

std::unique_ptr<Detector> make_embree(const Character& character) { return std::make_unique<Embree>(character); }

}  // namespace refitlab
