// SPDX-License-Identifier: MIT
// NodeRefit: Algorithm 1 repaired, of one node at a time, in float: a quaternion or a point is one Row. For a query that
// touches few nodes, where BatchRefit would make all of them.
#pragma once

#include "algorithms/runtime/packs/row.hpp"
#include "algorithms/runtime/tree/sphere_tree.hpp"

namespace refitlab {

class NodeRefit {
 public:
  // tree and sets are of one model. Throws std::range_error, as begin does, for lengths that single precision cannot
  // square (single_precision.hpp).
  NodeRefit(const SphereTree& tree, const JointSets& sets);

  // Starts a frame. palette need not outlive the call.
  void begin(const SkinningPalette<double>& palette);

  // What refit_algorithm1_repaired<MeanBalls> finds, with the slack of refit_kernel.hpp for rounding in the radius: encloses
  // the node's vertices, deformed by spherical blending with exactly the frame's palette.
  Ball3<float> operator()(int node);

 private:
  struct Joint {
    Row<float, 4> rotation, center_image;
  };
  struct Set {
    Row<float, 4> rotation_center;
    float size;  // of the coordinates, for the slack
    int first_joint, joint_count;
  };
  struct Node {
    Row<float, 4> center;
    float radius;
    int first_piece, piece_count;
  };
  struct WeightVertex {
    Row<float, 4> unit, center;
  };

  // Writes the piece's weight vertices and returns the radius of their balls, without r.
  float place_weight_vertices(const NodePiece& piece, const Row<float, 4>& p, WeightVertex* out) const;

  std::vector<Node> nodes_;
  std::vector<NodePiece> pieces_;
  std::vector<float> weights_;
  std::vector<Set> sets_;
  std::vector<Joint> joints_;
  std::vector<WeightVertex> weight_vertices_;  // of the node in work, in all of its pieces
  std::vector<float> radii_;                   // by piece
};

}  // namespace refitlab
