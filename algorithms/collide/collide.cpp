#include "algorithms/collide/collide.hpp"

#include "algorithms/collide/placement.hpp"

namespace refitlab {
namespace {

// What rounding may do to balls and vertices, relative to the size of the coordinates at hand: a refit is off by some
// 1e-15 of them, but where a blend is nearly zero, or corners of a piece nearly opposite, by more.
constexpr double rounding_slack = 1e-11;

double size_of(const PlacedBody& b) {
  const Ball3<double>& root = b.body.character().tree.nodes[0].reference;
  return norm(root.center) + root.radius + norm(b.placement.translation);
}

class Traversal {
 public:
  Traversal(const PlacedBody& first, const PlacedBody& second, Query query, QueryCounts& counts)
      : first_(first), second_(second), query_(query), counts_(counts),
        to_first_(compose(inverse(first.placement), second.placement)),
        slack_(rounding_slack * (size_of(first) + size_of(second))) {}

  std::vector<TrianglePair> run() {
    pending_.push_back({0, 0});
    while (!pending_.empty() && !(query_ == Query::yes_no && !found_.empty())) {
      const auto [a, b] = pending_.back();
      pending_.pop_back();
      if (are_apart(a, b)) continue;
      descend(a, b);
    }
    return std::move(found_);
  }

 private:
  static const TreeNode& node(const PlacedBody& b, int n) { return b.body.character().tree.nodes[n]; }

  // False also where a ball is undefined: nothing is known about what it bounds.
  bool are_apart(int a, int b) {
    ++counts_.ball_tests;
    const Ball3<double>&p = first_.body.ball(a), &q = second_.body.ball(b);
    const double reach = p.radius + q.radius + slack_;
    return squared_distance<double, 3>(p.center, apply(to_first_, q.center)) > reach * reach;
  }

  // Goes down on the side of the larger ball.
  void descend(int a, int b) {
    const TreeNode &p = node(first_, a), &q = node(second_, b);
    if (p.child_count == 0 && q.child_count == 0) return test_triangles(p, q);
    const bool down_first =
        q.child_count == 0 || (p.child_count > 0 && first_.body.ball(a).radius >= second_.body.ball(b).radius);
    if (down_first)
      for (int c = p.first_child; c < p.first_child + p.child_count; ++c) pending_.push_back({c, b});
    else
      for (int c = q.first_child; c < q.first_child + q.child_count; ++c) pending_.push_back({a, c});
  }

  void test_triangles(const TreeNode& p, const TreeNode& q) {
    const auto &first_order = first_.body.character().tree.triangle_order,
               &second_order = second_.body.character().tree.triangle_order;
    for (int i = p.first_triangle; i < p.first_triangle + p.triangle_count; ++i) {
      const TrianglePoints a = place(first_.placement, first_.body.triangle(first_order[i]));
      for (int j = q.first_triangle; j < q.first_triangle + q.triangle_count; ++j) {
        ++counts_.triangle_tests;
        if (!triangles_meet(a, place(second_.placement, second_.body.triangle(second_order[j])))) continue;
        found_.push_back({first_order[i], second_order[j]});
        if (query_ == Query::yes_no) return;
      }
    }
  }

  const PlacedBody &first_, &second_;
  const Query query_;
  QueryCounts& counts_;
  const RigidTransform<double> to_first_;  // from the second body's model space to the first's
  const double slack_;
  std::vector<std::pair<int, int>> pending_;
  std::vector<TrianglePair> found_;
};

}  // namespace

TrianglePoints place(const RigidTransform<double>& placement, const TrianglePoints& t) {
  return {apply(placement, t[0]), apply(placement, t[1]), apply(placement, t[2])};
}

std::vector<TrianglePair> collide(const PlacedBody& first, const PlacedBody& second, Query query, QueryCounts& counts) {
  check_placement(first.placement, "collide: the placement of the first body");
  check_placement(second.placement, "collide: the placement of the second body");
  return Traversal(first, second, query, counts).run();
}

}  // namespace refitlab
