// SPDX-License-Identifier: GPL-3.0-or-later
// All baselines pose and skin both bodies whole, in SIMD packs, before any volume is refitted.
#pragma once

#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/refit/frame_stamps.hpp"
#include "experiments/baselines/detector.hpp"

namespace refitlab {

// Triangle pairs are decided on vertices in the world. These are placed when first asked for, or all at once.
enum class Placing { when_asked, all };

// This bounds the rounding errors of volumes and vertices in double, relative to the size of the coordinates.
inline constexpr double double_rounding_slack = 1e-11;

class SkinningDetector : public Detector {
 public:
  void palette(const ScenarioFrame& frame) override;
  void skin() override;
  DetectorCounts counts() const override { return counts_; }

 protected:
  SkinningDetector(const Character& character, Placing placing);

  // side is 0 or 1 for one of the two bodies.
  const std::vector<Point3>& skinned(int side) const { return sides_[side].skinned; }  // model space, by vertex
  const std::vector<Point3>& placed(int side) const { return sides_[side].placed; }    // world; Placing::all
  const SkinnedMesh& model() const { return character_.mesh; }
  const Character& character() const { return character_; }
  const RigidTransform<double>& placement(int side) const { return sides_[side].placement; }
  // Returns the transform from the second body's model space to the first's.
  RigidTransform<double> to_first() const { return compose(inverse(placement(0)), placement(1)); }

  // Returns whether two triangles, one of each body, have a point in common.
  bool touch(int first, int second);

  DetectorCounts counts_;

 private:
  struct Side {
    SkinningPalette<double> palette;
    RigidTransform<double> placement;
    std::vector<Point3> skinned, placed;
    FrameStamps is_placed;
  };
  TrianglePoints in_world(Side& side, int triangle);

  const Character& character_;
  const Placing placing_;
  const PalettePacks palette_packs_;
  const PackedVertices packed_;
  Side sides_[2];
};

}  // namespace refitlab
