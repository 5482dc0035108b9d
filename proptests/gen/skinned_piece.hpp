// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one piece of a node in doubles, from all that a certificate can be about: joints off unit length, any signs, poses whose
// weight vertices have no axis that they are all ahead of, one weight vertex or many.
#pragma once

#include <random>
#include <vector>

#include "algorithms/runtime/tree/refit_node.hpp"

namespace proptests::gen {

class SkinnedPiece {
 public:
  SkinnedPiece(std::mt19937& random, refitlab::Skinning skinning, int most_weight_vertices);
  // Makes a piece of given joints.
  SkinnedPiece(refitlab::Skinning skinning, refitlab::OwnedPaletteEntry<double> palette,
               std::vector<std::vector<double>> weight_vertices, const refitlab::Ball3<double>& reference);

  refitlab::RefitNode<double> node() const { return {reference, sets_, weights_.data(), palette_}; }

  refitlab::Skinning skinning;
  refitlab::OwnedPaletteEntry<double> palette;
  std::vector<std::vector<double>> weight_vertices;  // multiples of 1/64 whose sum is 1
  refitlab::Ball3<double> reference;
  // Two joints are exactly opposite or a half-turn apart: there are blends of length 0, and edges that are equally wide.
  bool has_relation = false;

 private:
  void store();
  std::vector<refitlab::NodePiece> sets_;
  std::vector<double> weights_;
  refitlab::SkinningPalette<double> palette_;
};

}  // namespace proptests::gen
