// SPDX-License-Identifier: GPL-3.0-or-later
// All baselines pose and skin both bodies whole, in SIMD packs, before any volume is refitted. What their volumes cannot tell
// apart is decided as the library decides it (candidate_pairs.hpp).
#pragma once

#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/batch/palette_packs.hpp"
#include "experiments/baselines/candidate_pairs.hpp"
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
  DetectorCounts counts() const override;

 protected:
  SkinningDetector(const Character& character, Placing placing);

  // side is 0 or 1 for one of the two bodies.
  const std::vector<Point3>& skinned(int side) const { return sides_[side].skinned; }  // model space, by vertex; when_asked
  const std::vector<Point3>& placed(int side) const { return sides_[side].placed; }    // world, by vertex; Placing::all
  const SkinnedMesh& model() const { return character_.mesh; }
  const Character& character() const { return character_; }
  const RigidTransform<double>& placement(int side) const { return sides_[side].placement; }
  // Returns the transform from the second body's model space to the first's.
  RigidTransform<double> to_first() const { return compose(inverse(placement(0)), placement(1)); }

  CandidatePairs candidates_;  // asked, added to and emptied in each query
  DetectorCounts counts_;      // but for the triangle tests, which are counted there

 private:
  struct Side {
    SkinningPalette<double> palette;
    RigidTransform<double> placement;
    std::vector<Point3> skinned, placed;
    std::vector<PaddedVertex> in_world;
    FrameStamps is_placed;  // of in_world, when_asked
  };
  void skin_and_place(Side& side);
  const PaddedVertex& vertex_in_world(int side, int vertex);

  const Character& character_;
  const Placing placing_;
  const PalettePacks palette_packs_;
  const PackedVertices packed_;
  const std::vector<int> place_of_;  // by vertex: one of its places in packed_
  SkinnedVertices skinned_lanes_;
  Side sides_[2];
};

}  // namespace refitlab
