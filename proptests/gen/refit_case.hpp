// SPDX-License-Identifier: GPL-3.0-or-later
// Draws refits in exact rationals: a reference ball, and joint-sets in a pose with weight bounds, made to be awkward.
#pragma once

#include "algorithms/runtime/tree/refit_node.hpp"
#include "lemmas/exact/lift.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/weight_bounds.hpp"

namespace proptests::gen {

struct SetCase {
  refitlab::OwnedPaletteEntry<Rational> palette;
  WeightPolytope weights;
};

struct RefitCase {
  refitlab::Ball3<Rational> reference;  // S = [p, r]
  std::vector<SetCase> sets;
};

enum class Turns {
  // There are also equal and antipodal quaternions, half-turns, blends that vanish, and signs of either kind.
  any,
  // Any two joints of a set differ by at most 90 degrees, with consistent signs.
  moderate
};

// Draws 1 to 3 joint-sets of 1 to 5 joints, weight bounds from one to four vertices, a rotation center anywhere, at p or at a
// common joint, and r = 0 in a quarter of the cases; all of this in about a third of them. The others are generic: none of the
// degeneracies below, and 1 or 2 joint-sets of 2 to 4 joints.
rc::Gen<RefitCase> refit_case(Turns turns);

// Returns how a case is degenerate, a word each; nothing if it is not.
std::vector<std::string> degeneracies(const RefitCase& c);

// Returns the same case in doubles, which are then taken as exact numbers, as a program in double is given them. The rotations
// are of unit length only nearly, the images of the rotation centers and the dual parts are those that double computes, and the
// weights are multiples of 2^-24 with all their weight vertices.
RefitCase rounded_to_double(const RefitCase& c);

void showValue(const RefitCase& c, std::ostream& out);

// Holds a case over the number type T as the refit's input, with its storage.
template <class T>
class NodeOf {
 public:
  explicit NodeOf(const RefitCase& c) : reference_(refitlab::lift<T>(c.reference)) {
    for (const SetCase& set : c.sets) {
      const int first = static_cast<int>(weights_.size());
      for (const auto& weight_vertex : set.weights.vertices)
        for (const Rational& w : weight_vertex) weights_.push_back(refitlab::lift<T>(w));
      sets_.push_back(
          {static_cast<int>(sets_.size()), first, static_cast<int>(set.weights.vertices.size()), static_cast<int>(sets_.size())});
      palette_.push_back(refitlab::OwnedPaletteEntry<T>{
          refitlab::lift<T>(set.palette.transforms), refitlab::lift<T>(set.palette.rotation_center),
          refitlab::lift<T>(set.palette.center_images), refitlab::lift<T>(set.palette.duals)});
    }
  }
  refitlab::RefitNode<T> node() const { return {reference_, sets_, weights_.data(), palette_}; }

 private:
  refitlab::Ball3<T> reference_;
  std::vector<refitlab::NodePiece> sets_;
  std::vector<T> weights_;
  refitlab::SkinningPalette<T> palette_;
};

}  // namespace proptests::gen
