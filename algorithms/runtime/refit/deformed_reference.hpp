// SPDX-License-Identifier: MIT
// DeformedReference is what refits use of a character in the reference pose, after a deformation by morph targets and by the
// scales of joints in skinning in two phases (runtime/skinning/deformation.hpp).
//
// The refit of a deformed character is that of a rigid one with other reference balls. These are made when a node is first asked
// for, without its vertices. Displacements move a reference ball and add to its radius (a3_morph_displacement). Scales are
// linear skinning by affine joints, and so the ball behind them is the linear refit of that ball
// (a1_affine_image, a2_two_phase_skinning). They stay as long as the deformation does, which is often a whole clip.
#pragma once

#include "algorithms/runtime/refit/frame_stamps.hpp"
#include "algorithms/runtime/skinning/deformation.hpp"
#include "algorithms/runtime/tree/character.hpp"
#include "lemmas/vocabulary/slab.hpp"

namespace refitlab {

class DeformedReference {
 public:
  // character must outlive this. Throws std::invalid_argument for a character without these pieces.
  DeformedReference(const Character& character, Pieces kind);

  // Takes a deformation. Taking the last one again costs nothing. Throws ModelError as check_deformation does.
  void begin(const Deformation& deformation);
  // Takes all weights in these intervals, by target, at once. Refits then hold for each of them, and vertex() must not be called.
  // Throws ModelError as check_deformation does, for the weights farthest from 0, and for an interval that ends before it begins.
  void begin(std::span<const Slab<double>> weights, const AffinePose& scales);

  // Returns what a variant uses to refit a node: its balls enclose the vertices of deformed(), in double or exactly. The result
  // is valid until begin.
  RefitNode<double> refit_node(int node, const SkinningPalette<double>& palette);

  // Returns the vertex as deformed() has it in double.
  Point3 vertex(int vertex) const;

 private:
  void start(const Deformation& deformation);
  Ball3<double> displaced(const Ball3<double>& ball, std::span<const TargetBall> displacements) const;
  Ball3<double> scaled(const Ball3<double>& ball, std::span<const NodePiece> pieces, const double* weight_vertices) const;
  void make_reference(const NodePiece& piece);

  const Character& character_;
  const Pieces kind_;
  std::vector<Slab<double>> ranges_;  // by target; empty where none moves
  Deformation deformation_;           // for weights in intervals, with their low ends
  SkinningPalette<double> scales_;
  bool is_begun_ = false;
  FrameStamps nodes_made_, references_made_;
  std::vector<Ball3<double>> nodes_, references_;  // a node's encloses its pieces' balls
};

// Returns the character whose reference pose is that of the deformation, in double, for everything that takes a character. All
// of it is made at once. It has no morph targets. Throws ModelError for a deformation that check_deformation refuses, and where a
// deformed vertex is beyond largest_coordinate.
Character deformed_character(const Character& character, const Deformation& deformation);

}  // namespace refitlab
