// SPDX-License-Identifier: MIT
// PackedNodes has a tree's nodes laid out for the kernels of the batch refit (refit_kernel.hpp).
//
// Most nodes are moved by one to a few joint-sets, by which many other nodes are moved as well. These are refitted whole, a node
// a lane. The others, near the root, are taken apart. Their pieces of one joint-set are refitted together with those of other
// nodes, and the balls of the weight vertices are merged afterwards.
#pragma once

#include <limits>

#include "algorithms/runtime/batch/refit_kernel.hpp"
#include "algorithms/runtime/tree/sphere_tree.hpp"

namespace refitlab {

class PackedNodes {
 public:
  PackedNodes(const SphereTree& tree, const JointSets& sets);

  NodeBlocks nodes() const { return nodes_.view(); }
  NodeBlocks pieces() const { return pieces_.view(); }
  std::span<const MergedNode> merged() const { return merged_; }
  // Returns all records of the merged nodes as they are before the first frame.
  std::vector<Row<float, 4>> empty_records() const { return std::vector<Row<float, 4>>(record_count_, no_ball); }

  // ball_lanes() is the number of Lanes of balls. places() says by node where its x is among their numbers; y, z and the radius
  // are in the next Lanes.
  int ball_lanes() const { return ball_lanes_; }
  std::span<const int> places() const { return places_; }
  float largest_reference() const { return largest_reference_; }  // of the ||p||, rounded upwards

 private:
  struct Blocks {
    NodeBlocks view() const;
    std::vector<NodeBlock> blocks;
    std::vector<BlockSet> sets;
    std::vector<Lanes<float>> data;
    std::vector<PieceTarget> targets;
    int most_weight_vertices = 0;
  };
  // An Item is a node, or a piece of it, in one lane.
  struct Item {
    const TreeNode* node;
    std::span<const NodePiece> sets;
    int target;  // the node, or the first of the piece's records
  };

  // Appends blocks of items in this order. All items have the same joint-sets.
  static void add(const SphereTree& tree, const JointSets& sets, std::span<const Item> items, Blocks& to);
  static void add_block(const SphereTree& tree, const JointSets& sets, std::span<const Item> items, Blocks& to);
  void place(std::span<const int> nodes);

  static constexpr Row<float, 4> no_ball = {0, 0, 0, -std::numeric_limits<float>::infinity()};

  Blocks nodes_, pieces_;
  std::vector<MergedNode> merged_;
  std::vector<int> places_;
  int ball_lanes_ = 0, record_count_ = 0;
  float largest_reference_ = 0;
};

}  // namespace refitlab
