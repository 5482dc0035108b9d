// SPDX-License-Identifier: MIT
// BatchRefit computes the balls of all nodes of a tree in one go, in float and with mean balls. It does what
// refit_algorithm1_repaired<MeanBalls> and refit_linear<MeanBalls> do node by node.
#pragma once

#include "algorithms/runtime/batch/packed_nodes.hpp"

namespace refitlab {

// Returns the factor of r that is added to a radius r which affine joints stretch by at most this, with what float loses of it.
float added_stretch(double stretch);

// PackedBalls holds the balls of all nodes where the kernels left them.
class PackedBalls {
 public:
  PackedBalls(std::span<const int> places, int lanes) : places_(places), balls_(lanes) {}
  Ball3<float> operator[](int node) const {
    const float* x = numbers() + places_[node];
    constexpr int next = Lanes<float>::count;
    return {{x[0], x[next], x[2 * next]}, x[3 * next]};
  }
  Lanes<float>* data() { return balls_.data(); }
  float* numbers() { return balls_.data()->lane.data(); }
  const float* numbers() const { return balls_.data()->lane.data(); }

 private:
  std::span<const int> places_;  // by node
  std::vector<Lanes<float>> balls_;
};

class BatchRefit {
 public:
  // tree and sets are of one model.
  BatchRefit(const SphereTree& tree, const JointSets& sets)
      : packed_(tree, sets),
        balls_(packed_.places(), packed_.ball_lanes()),
        records_(packed_.empty_records()) {}

  BatchRefit(const BatchRefit&) = delete;  // the balls refer to the nodes
  BatchRefit& operator=(const BatchRefit&) = delete;

  // Returns the balls by node, which are valid until the next call. Each ball encloses the node's vertices, deformed by spherical
  // blending with exactly this palette. Its radius includes the slack for all rounding (refit_kernel.hpp). Throws
  // std::range_error for lengths that single precision cannot square (single_precision.hpp), and std::invalid_argument for a
  // palette of affine joints.
  const PackedBalls& spherical(const SkinningPalette<double>& palette, Target target = best_target());
  // Does the same for linear blending, by rigid or affine joints.
  const PackedBalls& linear(const SkinningPalette<double>& palette, Target target = best_target());

 private:
  const PackedBalls& refit(RefitNodes nodes, RefitPieces pieces, MergeNodes merge);

  PackedNodes packed_;
  PackedBalls balls_;
  std::vector<Row<float, 4>> records_;
  std::vector<float> numbers_;     // of the frame
  std::vector<int> first_number_;  // by joint-set
};

}  // namespace refitlab
