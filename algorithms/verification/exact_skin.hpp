// SPDX-License-Identifier: GPL-3.0-or-later
// ExactSkin has the vertices of one pose as exact arithmetic skins them, to check balls against.
//
// The numbers of a palette (quaternions, rotation centers, images of the centers, dual parts) are taken as they stand. Equation
// (1) and the dual quaternions' divide by the squared norm, so their rotations are exact although quaternions in double
// are not quite of unit length; in linear blending the slight stretch of such rotations is part of what is skinned. The numbers
// of affine joints and of a deformation are taken as they stand, too.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "algorithms/runtime/skinning/deformation.hpp"
#include "lemmas/exact/exact.hpp"
#include "lemmas/exact/interval.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

class ExactSkin {
 public:
  // model, sets and palette must outlive this.
  ExactSkin(const SkinnedMesh& mesh, const JointSets& sets, const SkinningPalette<double>& palette, Skinning skinning,
            const Deformation& deformation = {});

  // Returns the vertex in rationals, which is computed when it is first asked for.
  const Vec<Rational, 3>& exact(int vertex);

  // Returns whether the ball has the vertex. The ball's numbers are taken as they stand. It is decided in double if the vertex,
  // skinned in intervals, is in or out by more than its uncertainty, and in rationals otherwise. A ball that is not finite has
  // the vertex only if the radius is infinite.
  bool is_in(const Ball3<double>& ball, int vertex);
  // Returns whether the box has the vertex, decided in the same way.
  bool is_in(const Box<double>& box, int vertex);

 private:
  template <class S>
  Vec<S, 3> skinned(int vertex) const;

  const SkinnedMesh& mesh_;
  const JointSets& sets_;
  const SkinningPalette<double>& palette_;
  const Skinning skinning_;
  const std::vector<double> weights_;  // of morph targets
  const SkinningPalette<double> scales_;
  // The exact vertex is within `error` of `about`.
  struct Enclosure {
    Point3 about;
    double error;
  };
  const Enclosure& enclosure(int vertex);

  std::vector<std::optional<Enclosure>> quick_;  // by vertex
  std::vector<std::optional<Vec<Rational, 3>>> exact_;
};

}  // namespace refitlab
