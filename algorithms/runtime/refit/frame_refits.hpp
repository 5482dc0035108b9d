// SPDX-License-Identifier: MIT
// FrameRefits: the balls of one character in one frame, each refitted when it is first asked for, and once.
//
// Beyond the paper's on-demand refit (5), two ways in which a node uses what the frame knows already:
// - Nodes of many joint-sets, from below. Their own refit grows with the joint-sets and none of it is shared with other
//   nodes. Instead such a node gets the smallest ball around the balls of its cut: descendants of few joint-sets,
//   or bounded from below in their turn. They are refitted once a frame, for all of their ancestors, and asking for
//   them later costs nothing. As a cut has at most so many members, a ball costs no more however many joints the
//   character has (the paper's future work: sublinear in joints).
// - Children first. If all children of a node are refitted, their smallest enclosing ball is a bound too: the smaller
//   one is taken. Queries go top-down, so this is for frames whose balls are made bottom-up, all or many of them.
#pragma once

#include "algorithms/runtime/refit/frame_stamps.hpp"
#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

struct FrameOptions {
  // A node with more joint-sets than this that is not a leaf is bounded from below; 0: none is.
  int most_joint_sets = 0;
  // Of a cut: its member of most joint-sets is replaced by its children as long as they are no more than this. A node of
  // more children has all of them as its cut.
  int most_in_cut = 64;
  bool children_first = false;
};

class FrameRefits {
 public:
  // character and variant outlive this. Throws std::invalid_argument for a character without the variant's pieces.
  FrameRefits(const Character& character, const RefitVariant& variant, const FrameOptions& options = {});

  // Starts a frame: all balls are forgotten. palette, made for variant.skinning, outlives the frame. Throws
  // std::invalid_argument if it is not measured.
  void begin(const SkinningPalette<double>& palette);

  // Encloses all vertices of the node in this frame's pose, if the variant is sound. The reference holds until begin.
  const Ball3<double>& operator[](int node);

  // Makes all balls, children before parents.
  void refit_all();

  bool is_refitted(int node) const { return made_.is_made(node); }
  // The nodes that a node is bounded from below by; empty for one that is refitted by itself.
  const std::vector<int>& cut(int node) const { return cut_[node]; }
  // How many balls were made since begin, by level - 1.
  const std::vector<long>& refitted_by_level() const { return refitted_; }

 private:
  void refit(int node);
  bool are_children_refitted(const TreeNode& node) const;
  Ball3<double> through_descendants(int node);

  const Character& character_;
  const RefitVariant& variant_;
  const FrameOptions options_;
  const SkinningPalette<double>* palette_ = nullptr;
  FrameStamps made_;  // by node
  std::vector<Ball3<double>> balls_;
  std::vector<std::vector<int>> cut_;  // by node; empty where a node is refitted by itself
  std::vector<long> refitted_;
  std::vector<Ball3<double>> cut_balls_;
};

}  // namespace refitlab
