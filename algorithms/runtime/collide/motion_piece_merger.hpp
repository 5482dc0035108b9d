// SPDX-License-Identifier: MIT
// Whatever is bounded by the joints of a joint-set is bounded by those of any joint-set that has them all, too. So where this hardly makes
// the bounds of a node larger, a MotionPieceMerger merges pieces of few joints into others, which takes less time in each frame.
#pragma once

#include <utility>

#include "algorithms/runtime/collide/motion_bound.hpp"

namespace refitlab {

// Returns the poses in which bounds are compared: each joint is turned about its own origin, a little or more, neighbours in the list
// about other axes.
std::vector<Pose> compared_poses(const SkinnedMesh& mesh);

class MotionPieceMerger {
 public:
  // The box of a node grows by no more than this share, in the mean of the compared poses.
  static constexpr double most_growth = 0.005;

  // character must outlive this.
  explicit MotionPieceMerger(const Character& character);

  // Returns the pieces of the vertices in each list, whose position is the target of its pieces. No list may be empty. Where no bound
  // is known of some piece, those of its list are not merged.
  std::vector<MotionPiece> pieces(std::span<const std::vector<int>> lists);

 private:
  using BoxesByPose = std::vector<Box<double>>;
  struct Part;
  struct Merge;

  std::vector<BoxesByPose> boxes_of(std::vector<MotionPiece> pieces);
  std::vector<Part> parts_of(std::span<const int> vertices) const;
  void add_merges(const std::vector<Part>& parts, std::span<const std::pair<std::size_t, std::size_t>> pairs,
                  std::vector<Merge>& merges);
  double size_with(const std::vector<Part>& parts, const Merge* merge) const;
  bool is_within(const Part& a, const Part& b) const;
  void merge(std::vector<Part>& parts);

  const Character& character_;
  std::vector<Pose> poses_;
  std::vector<MotionBound> bounds_;  // of each pose, which places its joints
};

}  // namespace refitlab
