#include "algorithms/refit/frame_refits.hpp"

#include <algorithm>

#include "algorithms/balls/smallest_ball_of_balls.hpp"

namespace refitlab {
namespace {

bool is_from_below(const Character& c, const RefitVariant& variant, const FrameOptions& options, int node) {
  if (options.most_pieces == 0 || c.tree.nodes[node].child_count == 0) return false;
  return static_cast<int>(c.refit_node(node, {}, variant.pieces).joint_sets.size()) > options.most_pieces;
}

// By node: empty for one that is refitted by itself.
std::vector<std::vector<int>> fronts(const Character& c, const RefitVariant& variant, const FrameOptions& options) {
  std::vector<std::vector<int>> front(c.tree.nodes.size());
  for (std::size_t n = c.tree.nodes.size(); n-- > 0;) {  // children come after their parent
    if (!is_from_below(c, variant, options, static_cast<int>(n))) continue;
    const TreeNode& node = c.tree.nodes[n];
    for (int child = node.first_child; child < node.first_child + node.child_count; ++child)
      if (front[child].empty())
        front[n].push_back(child);
      else
        front[n].insert(front[n].end(), front[child].begin(), front[child].end());
  }
  return front;
}

}  // namespace

FrameRefits::FrameRefits(const Character& character, const RefitVariant& variant, const FrameOptions& options)
    : character_(character),
      variant_(variant),
      options_(options),
      frame_of_(character.tree.nodes.size()),
      balls_(character.tree.nodes.size()),
      front_(fronts(character, variant, options)),
      refitted_(character.tree.level_count()) {}

void FrameRefits::begin(const SkinningPose<double>& pose) {
  pose_ = &pose;
  std::fill(refitted_.begin(), refitted_.end(), 0);
  if (++frame_ == 0) {  // the counter went round: no ball may pass for one of this frame
    std::fill(frame_of_.begin(), frame_of_.end(), 0);
    frame_ = 1;
  }
}

const Ball3<double>& FrameRefits::operator[](int node) {
  if (!is_refitted(node)) refit(node);
  return balls_[node];
}

void FrameRefits::refit_all() {
  for (std::size_t n = balls_.size(); n-- > 0;) (*this)[static_cast<int>(n)];
}

void FrameRefits::refit(int n) {
  const TreeNode& node = character_.tree.nodes[n];
  if (front_[n].empty())
    balls_[n] = variant_.refit(character_.refit_node(n, *pose_, variant_.pieces));
  else
    balls_[n] = from_below(n);
  if (options_.children_first && are_children_refitted(node)) {
    const Ball3<double> merged = smallest_ball_of_balls(
        {balls_.data() + node.first_child, static_cast<std::size_t>(node.child_count)});
    if (merged.radius < balls_[n].radius) balls_[n] = merged;
  }
  frame_of_[n] = frame_;
  ++refitted_[node.level - 1];
}

bool FrameRefits::are_children_refitted(const TreeNode& node) const {
  for (int child = node.first_child; child < node.first_child + node.child_count; ++child)
    if (!is_refitted(child)) return false;
  return node.child_count > 0;
}

Ball3<double> FrameRefits::from_below(int node) {
  for (const int below : front_[node]) (*this)[below];  // none of these is bounded from below itself
  front_balls_.clear();
  for (const int below : front_[node]) front_balls_.push_back(balls_[below]);
  return smallest_ball_of_balls(front_balls_);
}

}  // namespace refitlab
