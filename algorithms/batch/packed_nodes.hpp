// PackedNodes: a tree's nodes laid out for the kernels of the batch refit (refit_kernel.hpp).
//
// Most nodes are moved by one to a few joint-sets, which many other nodes are moved by as well: those are refitted whole,
// a node a lane. The others, near the root, are taken apart: their pieces of one joint-set with those of other nodes, the
// balls of the corners merged afterwards.
#pragma once

#include "algorithms/batch/refit_kernel.hpp"
#include "algorithms/tree/sphere_tree.hpp"

namespace refitlab {

class PackedNodes {
 public:
  PackedNodes(const SphereTree& tree, const JointSets& sets);

  NodeBlocks nodes() const { return nodes_.view(); }
  NodeBlocks pieces() const { return pieces_.view(); }
  std::span<const MergedNode> merged() const { return merged_; }
  std::span<const CornerPlace> merged_corners() const { return merged_corners_; }
  int most_merged_corners() const { return most_merged_corners_; }

  // How many Lanes the kernels write, and where in those of the balls a node's x is; y, z and radius are in the next Lanes.
  int ball_lanes() const { return ball_lanes_; }
  int piece_lanes() const { return piece_lanes_; }
  std::span<const int> places() const { return places_; }
  float largest_reference() const { return largest_reference_; }  // of the ||p||, rounded upwards

 private:
  struct Blocks {
    NodeBlocks view() const;
    std::vector<NodeBlock> blocks;
    std::vector<BlockSet> sets;
    std::vector<Lanes<float>> data;
    int most_corners = 0;
  };
  // A node, or a piece of it, in one lane.
  struct Item {
    const TreeNode* node;
    std::span<const NodeJointSet> sets;
    int target;  // the node, or the first of the piece's merged corners
  };

  // Appends blocks of items of the same joint-sets, and tells where each item is: its block and lane.
  template <class Found>
  static void add(const SphereTree& tree, const JointSets& sets, std::vector<Item> items, Blocks& to, Found&& found);
  static void add_block(const SphereTree& tree, const JointSets& sets, std::span<const Item> items, Blocks& to);

  Blocks nodes_, pieces_;
  std::vector<MergedNode> merged_;
  std::vector<CornerPlace> merged_corners_;
  std::vector<int> places_;
  int ball_lanes_ = 0, piece_lanes_ = 0, most_merged_corners_ = 0;
  float largest_reference_ = 0;
};

}  // namespace refitlab
