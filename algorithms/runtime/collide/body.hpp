// SPDX-License-Identifier: MIT
// A Body is a character in one frame, as queries see it. It refits balls and skins vertices only where a query reaches them.
#pragma once

#include <optional>

#include "algorithms/runtime/batch/palette_packs.hpp"
#include "algorithms/runtime/collide/triangles_meet.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"

namespace refitlab {

class Body {
 public:
  // character and variant must outlive this.
  Body(const Character& character, const RefitVariant& variant, const FrameOptions& options = {})
      : character_(character),
        skinning_(variant.skinning),
        pieces_(variant.pieces),
        palette_packs_(character.mesh, character.sets, skinning_),
        balls_(character, variant, options),
        made_(character.mesh.vertices.size()),
        skinned_(character.mesh.vertices.size()) {}
  Body(const Body&) = delete;  // a copy would refit with the palette of this one

  // Starts a frame. Throws ModelError for a pose that make_skinning_palette refuses, and for a deformation that
  // check_deformation refuses. If it throws one of these, the body is still in the frame before. If memory runs out, it is in no
  // frame.
  void begin(const Pose& pose, const Deformation& deformation = {});
  // Starts a frame of affine joints, and of morph targets if there are weights. Linear skinning blends these transforms; other
  // skinning has two phases of them (split, in runtime/skinning/deformation.hpp). Throws the same.
  void begin(const AffinePose& pose, const std::vector<double>& weights = {});

  const Character& character() const { return character_; }
  // Returns the ball of a node, in model space of this frame. Throws std::logic_error before the first frame, as triangle() does.
  const Ball3<double>& ball(int node) { return balls_[node]; }
  // Returns the skinned vertices of a triangle, in model space of this frame. They are the very doubles that skin() yields.
  TrianglePoints triangle(int triangle);

  const FrameRefits& refits() const { return balls_; }
  // Returns how many vertices were skinned since begin.
  long vertices_skinned() const { return vertices_skinned_; }

 private:
  void deform(const Deformation& deformation);
  void start();
  void lose_frame();
  const Point3& vertex(int v);

  const Character& character_;
  const Skinning skinning_;
  const Pieces pieces_;
  const PalettePacks palette_packs_;
  FrameRefits balls_;
  std::optional<DeformedReference> reference_;  // made when a frame first needs it
  bool is_deformed_ = false;
  SkinningPalette<double> palette_;
  FrameStamps made_;  // by vertex
  std::vector<Point3> skinned_;
  long vertices_skinned_ = 0;
};

}  // namespace refitlab
