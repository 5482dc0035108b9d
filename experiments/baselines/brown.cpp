// SPDX-License-Identifier: GPL-3.0-or-later
// Skins everything and refits the character's sphere tree bottom-up [Brown et al. 2001].
#include "experiments/baselines/baselines.hpp"
#include "experiments/baselines/skinning_detector.hpp"

namespace refitlab {
namespace {

// Returns the smallest ball around two balls.
Ball3<double> join(const Ball3<double>& a, const Ball3<double>& b) {
  const Point3 between = b.center - a.center;
  const double distance = norm(between);
  if (distance + b.radius <= a.radius) return a;
  if (distance + a.radius <= b.radius) return b;
  const double radius = (distance + a.radius + b.radius) / 2;
  return {a.center + between * ((radius - a.radius) / distance), radius};
}

class Brown : public SkinningDetector {
 public:
  explicit Brown(const Character& character) : SkinningDetector(character, Placing::when_asked), tree_(character.tree) {
    for (auto& balls : balls_) balls.resize(tree_.nodes.size());
  }

  void refit() override {
    for (int side = 0; side < 2; ++side)
      for (std::size_t n = tree_.nodes.size(); n-- > 0;)
        balls_[side][n] = refitted(side, tree_.nodes[n]);  // children come after parents
    counts_.nodes_refitted += 2 * static_cast<long>(tree_.nodes.size());
    to_first_ = to_first();
    slack_ = double_rounding_slack * (norm(placement(0).translation) + norm(placement(1).translation) + size(0) + size(1));
  }

  std::vector<TrianglePair> query(Query query) override {
    candidates_.ask(query);
    pending_.assign(1, {0, 0});
    while (!pending_.empty() && !candidates_.is_done()) {
      const auto [a, b] = pending_.back();
      pending_.pop_back();
      if (are_apart(a, b)) continue;
      const TreeNode &p = tree_.nodes[a], &q = tree_.nodes[b];
      if (p.child_count == 0 && q.child_count == 0) {
        add_triangles(p, q);
      } else if (q.child_count == 0 || (p.child_count > 0 && balls_[0][a].radius >= balls_[1][b].radius)) {
        for (int c = p.first_child; c < p.first_child + p.child_count; ++c) pending_.emplace_back(c, b);
      } else {
        for (int c = q.first_child; c < q.first_child + q.child_count; ++c) pending_.emplace_back(a, c);
      }
    }
    return candidates_.found();
  }

 private:
  Ball3<double> refitted(int side, const TreeNode& node) const {
    if (node.child_count == 0) {
      Ball3<double> ball{skinned(side)[tree_.leaf_vertices[node.first_vertex]], 0};
      for (int i = 1; i < node.vertex_count; ++i)
        ball = join(ball, {skinned(side)[tree_.leaf_vertices[node.first_vertex + i]], 0});
      return ball;
    }
    Ball3<double> ball = balls_[side][node.first_child];
    for (int c = 1; c < node.child_count; ++c) ball = join(ball, balls_[side][node.first_child + c]);
    return ball;
  }

  double size(int side) const { return norm(balls_[side][0].center) + balls_[side][0].radius; }

  bool are_apart(int a, int b) {
    ++counts_.volume_tests;
    const Ball3<double>&p = balls_[0][a], &q = balls_[1][b];
    const double reach = p.radius + q.radius + slack_;
    return squared_distance<double, 3>(p.center, apply(to_first_, q.center)) > reach * reach;
  }

  void add_triangles(const TreeNode& p, const TreeNode& q) {
    for (int i = p.first_triangle; i < p.first_triangle + p.triangle_count; ++i)
      for (int j = q.first_triangle; j < q.first_triangle + q.triangle_count; ++j)
        candidates_.add(tree_.triangle_order[i], tree_.triangle_order[j]);
  }

  const SphereTree& tree_;
  std::vector<Ball3<double>> balls_[2];  // by node, in model space
  RigidTransform<double> to_first_;
  double slack_ = 0;
  std::vector<std::pair<int, int>> pending_;
};

}  // namespace

std::unique_ptr<Detector> make_brown(const Character& character) { return std::make_unique<Brown>(character); }

}  // namespace refitlab
