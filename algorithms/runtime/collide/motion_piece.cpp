// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/motion_piece.hpp"

#include <algorithm>

#include "algorithms/runtime/collide/simplex_pieces.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "algorithms/runtime/skinning/rotation_center.hpp"

namespace refitlab {
namespace {

PieceWeights weights_of(const JointSets& sets, int joint_set, std::span<const int> vertices) {
  const auto joints = sets.joints(joint_set);
  PieceWeights out{std::vector<double>(joints.size(), 1), 0, 0};
  for (const int v : vertices) {
    const auto own = sets.joints(sets.of_vertex(v));
    const auto weights = sets.weights(v);
    std::vector<double> all(joints.size(), 0);
    for (std::size_t k = 0; k < own.size(); ++k)
      all[static_cast<std::size_t>(std::find(joints.begin(), joints.end(), own[k]) - joints.begin())] = weights[k];
    double products = 0, squares = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      out.least[k] = std::min(out.least[k], all[k]);
      for (std::size_t l = k + 1; l < all.size(); ++l) products += all[k] * all[l], squares += sq(all[k] * all[l]);
    }
    out.products = std::max(out.products, products);
    out.squared_products = std::max(out.squared_products, squares);
  }
  return out;
}

}  // namespace

MotionPiece motion_piece(const Character& c, int joint_set, std::span<const int> vertices) {
  const DefaultFloatEnvironment environment;
  std::vector<Point3> points;
  for (const int v : vertices) points.push_back(c.mesh.vertices[v]);
  MotionPiece out{joint_set, float_ball(points), box_around<double>(points), 0, 0, weights_of(c.sets, joint_set, vertices)};
  int last = -1;
  for (const int v : vertices) {
    const int set = c.sets.of_vertex(v);
    if (set == last) continue;
    last = set;
    const Point3 prior = center_prior(c.mesh, c.sets.joints(set), Skinning::spherical);
    out.to_prior = std::max(out.to_prior, (out.reference.center - prior).norm());
  }
  return out;
}

}  // namespace refitlab
