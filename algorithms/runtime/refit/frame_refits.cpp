// SPDX-License-Identifier: MIT
#include "algorithms/runtime/refit/frame_refits.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/balls/round_up.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {
namespace {

// Returns the cut of a node that has children.
std::vector<int> cut_of(const SphereTree& tree, const FrameOptions& options, int node) {
  const auto fewer_to_gain = [&](int a, int b) {
    const auto gain = [&](int n) { return tree.nodes[n].child_count ? tree.nodes[n].piece_count : 0; };
    return std::pair(gain(a), -a) < std::pair(gain(b), -b);
  };
  std::vector<int> cut;  // a heap
  const auto open = [&](int n) {
    for (int child = tree.nodes[n].first_child; child < tree.nodes[n].first_child + tree.nodes[n].child_count; ++child) {
      cut.push_back(child);
      std::push_heap(cut.begin(), cut.end(), fewer_to_gain);
    }
  };
  for (open(node);;) {
    const TreeNode& most = tree.nodes[cut.front()];
    const auto opened = static_cast<int>(cut.size()) - 1 + most.child_count;
    if (most.piece_count <= options.most_joint_sets || most.child_count == 0 || opened > options.most_in_cut) return cut;
    const int n = cut.front();
    std::pop_heap(cut.begin(), cut.end(), fewer_to_gain);
    cut.pop_back();
    open(n);
  }
}

std::vector<std::vector<int>> cuts(const SphereTree& tree, const FrameOptions& options) {
  std::vector<std::vector<int>> cut(tree.nodes.size());
  if (options.most_joint_sets == 0) return cut;
  for (std::size_t n = 0; n < cut.size(); ++n)
    if (tree.nodes[n].piece_count > options.most_joint_sets && tree.nodes[n].child_count > 0)
      cut[n] = cut_of(tree, options, static_cast<int>(n));
  return cut;
}

// Returns a ball around the balls. It is all of space if one of them is.
Ball3<double> ball_around(std::span<const Ball3<double>> balls) {
  for (const Ball3<double>& ball : balls)
    if (ball.radius == std::numeric_limits<double>::infinity()) return ball;
  return rounded_up(few_balls_enclosing(balls));
}

}  // namespace

FrameRefits::FrameRefits(const Character& character, const RefitVariant& variant, const FrameOptions& options)
    : character_(character),
      variant_(variant),
      options_(options),
      made_(character.tree.nodes.size()),
      balls_(character.tree.nodes.size()),
      cut_(cuts(character.tree, options)),
      refitted_(character.tree.level_count()) {
  if (!character.has(variant.pieces))
    throw std::invalid_argument(character.mesh.name + ": baked without the pieces of the refit " + variant.name);
}

void FrameRefits::begin(const SkinningPalette<double>& palette, DeformedReference* reference) {
  check_palette(palette, variant_);
  palette_ = &palette;
  reference_ = reference;
  std::fill(refitted_.begin(), refitted_.end(), 0);
  made_.begin();
}

void FrameRefits::end() {
  palette_ = nullptr;
  made_.begin();
}

void FrameRefits::require_frame() const {
  if (!palette_) throw std::logic_error(character_.mesh.name + ": no frame was begun");
}

const Ball3<double>& FrameRefits::operator[](int node) {
  if (!is_refitted(node)) refit(node);
  return balls_[node];
}

void FrameRefits::refit_all() {
  for (std::size_t n = balls_.size(); n-- > 0;) (*this)[static_cast<int>(n)];
}

void FrameRefits::refit(int n) {
  const DefaultFloatEnvironment environment;
  require_frame();
  const TreeNode& node = character_.tree.nodes[n];
  if (!cut_[n].empty()) balls_[n] = through_descendants(n);
  else if (reference_) balls_[n] = variant_.refit(reference_->refit_node(n, *palette_));
  else balls_[n] = variant_.refit(character_.refit_node(n, *palette_, variant_.pieces));
  if (options_.children_first && are_children_refitted(node)) {
    const Ball3<double> merged = ball_around({balls_.data() + node.first_child, static_cast<std::size_t>(node.child_count)});
    if (merged.radius < balls_[n].radius) balls_[n] = merged;
  }
  made_.mark(n);
  ++refitted_[node.level - 1];
}

bool FrameRefits::are_children_refitted(const TreeNode& node) const {
  for (int child = node.first_child; child < node.first_child + node.child_count; ++child)
    if (!is_refitted(child)) return false;
  return node.child_count > 0;
}

Ball3<double> FrameRefits::through_descendants(int node) {
  for (const int below : cut_[node]) (*this)[below];  // may come here again, and uses the list
  cut_balls_.clear();
  for (const int below : cut_[node]) cut_balls_.push_back(balls_[below]);
  return ball_around(cut_balls_);
}

}  // namespace refitlab
