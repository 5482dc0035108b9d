// SPDX-License-Identifier: MIT
#include "algorithms/runtime/collide/collide.hpp"

#include <cmath>
#include <limits>

#include "algorithms/runtime/collide/placement.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/vocabulary/vector.hpp"

namespace refitlab {
namespace {

// Balls enclose the vertices of their bodies as these are skinned (rounding.hpp), but triangles are tested as they come out
// of apply(placement, v). In units of u = epsilon / 2 and of the coordinates' size, that is off by 26. to_first of another ball's
// center is off by 80: the product of the quaternions by 8, which turns by 16, two rotations by 24 each, and sums. And with
// ||q||^2 = 1 + e a placement is (1 + e) R - e, which stretches by at most 2 |e|, and whose inverse differs from that of the
// conjugate by 4 |e|. For both bodies that is less than 160 u + 8 (|e_1| + |e_2|).
double slack_of(const PlacedBody& first, const PlacedBody& second) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  double defect = 16 * u;
  for (const PlacedBody* b : {&first, &second}) defect += std::abs(squared_norm(b->placement.rotation) - 1);
  return lost_of_placements + 4 * error_of_rotate(defect);
}

class Traversal {
 public:
  Traversal(const PlacedBody& first, const PlacedBody& second, Query query, QueryCounts& counts)
      : first_(first),
        second_(second),
        query_(query),
        counts_(counts),
        to_first_(compose(inverse(first.placement), second.placement)),
        slack_(slack_of(first, second)),
        way_(upper_norm(first.placement.translation) + upper_norm(second.placement.translation)) {}

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

  // Returns false also where a ball is undefined, because nothing is known about its vertices.
  bool are_apart(int a, int b) {
    ++counts_.ball_tests;
    const Ball3<double>&p = first_.body.ball(a), &q = second_.body.ball(b);
    const double radii = p.radius + q.radius, size = upper_norm(p.center) + upper_norm(q.center) + radii + way_;
    const double reach = radii + slack_ * size;  // by far more than the rounding here
    constexpr double least = 1e-300;             // of what is less, squares lose digits by underflow
    return squared_distance<double, 3>(p.center, apply(to_first_, q.center)) > reach * reach + least;
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
  const double slack_, way_;               // relative to the coordinates' size, and what the placements add to that
  std::vector<std::pair<int, int>> pending_;
  std::vector<TrianglePair> found_;
};

}  // namespace

TrianglePoints place(const RigidTransform<double>& placement, const TrianglePoints& t) {
  const DefaultFloatEnvironment environment;
  return {apply(placement, t[0]), apply(placement, t[1]), apply(placement, t[2])};
}

std::vector<TrianglePair> collide(const PlacedBody& first, const PlacedBody& second, Query query, QueryCounts& counts) {
  const DefaultFloatEnvironment environment;
  check_placement(first.placement, first.body.character().mesh.name, "the placement of the first body");
  check_placement(second.placement, second.body.character().mesh.name, "the placement of the second body");
  return Traversal(first, second, query, counts).run();
}

}  // namespace refitlab
