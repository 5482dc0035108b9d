// SPDX-License-Identifier: MIT
// FrameRefits has the balls of one character in one frame. Each is refitted once, when it is first asked for.
//
// Beyond the paper's on-demand refit (5), a node can use what the frame knows already, in two ways:
// - Nodes of many joint-sets are refitted through a BVH cut. The cost of their own refit grows with the number of
// joint-sets, and other nodes cannot share any of it. Instead, such a node gets the smallest ball around the balls of its
// cut. The members of a cut are descendants with few joint-sets, or descendants that have a cut themselves. They are
// refitted once a frame for all of their ancestors, and asking for them later costs nothing. A cut has a limited number of
// members, so the cost of a ball does not grow with the number of joints of the character (the paper's future work:
// sublinear in joints).
// - Children come first. If all children of a node are refitted, their smallest enclosing ball is a bound too, and the
// smaller of the two is taken. Queries go top-down, so this helps in frames whose balls are made bottom-up, all or many of
// them.
#pragma once

#include "algorithms/runtime/refit/deformed_reference.hpp"
#include "algorithms/runtime/refit/variants.hpp"

namespace refitlab {

struct FrameOptions {
  // A node that is not a leaf and has more joint-sets than this is bounded through its cut. 0 means that no node is.
  int most_joint_sets = 0;
  // This is the largest size of a cut. While the cut stays within this size, its member of most joint-sets is replaced by the
  // member's children. A node of more children has all of them as its cut.
  int most_in_cut = 64;
  bool children_first = false;
};

class FrameRefits {
 public:
  // character and variant must outlive this. Throws std::invalid_argument for a character without the variant's pieces.
  FrameRefits(const Character& character, const RefitVariant& variant, const FrameOptions& options = {});

  // Starts a frame, and forgets all balls. palette must be made for variant.skinning and must outlive the frame. So must
  // reference, which has the pieces of the variant, if the frame's reference pose is deformed. Throws std::invalid_argument if
  // the palette is not measured, or if it is one of affine joints and the skinning is not linear.
  void begin(const SkinningPalette<double>& palette, DeformedReference* reference = nullptr);

  // Ends the frame. Another one is to be begun before anything is asked for.
  void end();

  // Throws std::logic_error before the first frame, or after a frame has ended.
  void require_frame() const;

  // Returns a ball that encloses all vertices of the node in this frame's pose, if the variant is sound. The reference is
  // valid until begin. Throws what require_frame does.
  const Ball3<double>& operator[](int node);

  // Makes all balls, children before parents.
  void refit_all();

  bool is_refitted(int node) const { return made_.is_made(node); }
  // Returns the cut that a node is bounded through. It is empty for a node that is refitted by itself.
  const std::vector<int>& cut(int node) const { return cut_[node]; }
  // Returns how many balls were made since begin, by level - 1.
  const std::vector<long>& refitted_by_level() const { return refitted_; }

 private:
  void refit(int node);
  bool are_children_refitted(const TreeNode& node) const;
  Ball3<double> through_descendants(int node);

  const Character& character_;
  const RefitVariant& variant_;
  const FrameOptions options_;
  const SkinningPalette<double>* palette_ = nullptr;
  DeformedReference* reference_ = nullptr;
  FrameStamps made_;  // by node
  std::vector<Ball3<double>> balls_;
  std::vector<std::vector<int>> cut_;  // by node; empty where a node is refitted by itself
  std::vector<long> refitted_;
  std::vector<Ball3<double>> cut_balls_;
};

}  // namespace refitlab
