// SPDX-License-Identifier: GPL-3.0-or-later
// Refits are scored on synthetic cases: does a ball in double hold the exactly skinned vertices, and how much larger is it than
// needed?
#pragma once

#include <optional>

#include "algorithms/runtime/refit/variants.hpp"
#include "algorithms/verification/synthetic_case.hpp"
#include "lemmas/exact/ladder.hpp"

namespace refitlab {

// CaseNodes is a synthetic case in double as the input of a refit, in each of the descriptions that variants ask for.
class CaseNodes {
 public:
  explicit CaseNodes(const SyntheticCase& synthetic);

  // Returns the case as a node. Pieces::joint_sets has a ball for each joint-set. Pieces::many has its weight box halved twice at
  // the widest weight.
  RefitNode<double> node(Pieces pieces) const {
    const Description& d = descriptions_[static_cast<int>(pieces)];
    return {reference_, d.pieces, d.weight_vertices.data(), palette_, d.references};
  }

 private:
  struct Description {
    std::vector<NodePiece> pieces;
    std::vector<Ball3<double>> references;  // empty: the node's
    std::vector<double> weight_vertices;
  };
  Ball3<double> reference_;
  SkinningPalette<double> palette_;
  Description descriptions_[4];
};

// Rounding explains a miss up to this, relative to the size of the coordinates.
inline constexpr double synthetic_tolerance = 1e-12;

struct CaseScore {
  bool undefined = false;  // not a number, or of negative radius: misses everything
  bool unbounded = false;  // all of space: what dual quaternions need where a blend may vanish
  bool misses = false;     // some vertex is outside, decided exactly
  double worst_miss = 0;   // how far, relative to the size of the coordinates; 1 if undefined
  bool misses_beyond_tolerance() const { return worst_miss > synthetic_tolerance; }
};

// A SkinnedCase is a synthetic case under one kind of skinning, at its sampled weights.
//
// In spherical and dual quaternion skinning the image of S_z is a ball, [image of its center, its radius]. A ball that holds it
// holds all vertices of S_z with these weights. In linear skinning the images of the center of S_z and of the six ends of its
// axes stand for it.
class SkinnedCase {
 public:
  // skinning is not Hejl's, which needs a skeleton. The case must outlive this.
  SkinnedCase(const SyntheticCase& synthetic, Skinning skinning);

  // Scores a ball, whose numbers are taken as they are. Each comparison is made in intervals of doubles, then of 60 digits, then
  // in rationals, until it is decided.
  CaseScore score(const Ball3<double>& ball);

  // Returns the radius of the smallest ball of all sampled images, up to rounding.
  double smallest_radius() const;

 private:
  struct Target {
    const SyntheticSet* set;
    const RationalWeights* weights;
    Vec<Rational, 3> vertex;
    Rational radius;
    Ball3<Interval> image;                                // skinned in intervals, at once
    std::optional<Ball3<MultiprecisionInterval>> closer;  // on demand
    std::optional<Ball3<Rational>> exact;
  };
  template <class S>
  Ball3<S> skinned(const Target& target) const;

  Skinning skinning_;
  std::vector<std::vector<RationalWeights>> weights_;  // by joint-set
  std::vector<Target> targets_;
  double size_ = 0;  // of the pose: the longest of the rotation centers and their images
};

}  // namespace refitlab
