// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/methods/refit/deformed.hpp"

#include <random>

#include "algorithms/bake/build_tree.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/smallest_ball.hpp"

namespace proptests::suite_deformed {
namespace {

using namespace refitlab;

struct Refitted {
  SkinnedMesh mesh;
  SphereTree tree;
  NodeVertices vertices;
  std::vector<Point3> deformed;
  std::vector<Ball3<double>> optimal, bottom_up;
};

// Draws a mesh whose vertices have moved anywhere: to random points, to few points, or all to one.
Refitted draw() {
  const auto plan = *gen::mesh_plan();
  const int places = *rc::gen::element(1, 3, 1000, 1000);
  RC_CLASSIFY(gen::is_degenerate(plan) || places < 1000, "degenerate");
  const SkinnedMesh model = gen::make_mesh(plan);
  const auto tree = build_sphere_tree(model, JointSets(model), {.triangles_per_leaf = *rc::gen::element(1, 4)});
  std::mt19937 random(plan.seed + 1);
  std::normal_distribution<double> normal;
  std::vector<Point3> place, deformed;
  for (int k = 0; k < places; ++k) place.push_back({normal(random), normal(random), normal(random)});
  for (std::size_t v = 0; v < model.vertices.size(); ++v) deformed.push_back(place[random() % place.size()]);
  const NodeVertices vertices(tree, model);
  return {model, tree, vertices, deformed, optimal_balls(tree, vertices, deformed), refit_bottom_up(tree, deformed)};
}

Ball<Rational, 3> exact_and_larger(const Ball3<double>& ball) {
  return {convert<Rational>(ball.center), Rational(ball.radius) * Rational(1 + 1e-14)};
}

}  // namespace

PROPTEST(deformed) {
  t.holds("optimal and bottom-up balls hold the deformed vertices of their nodes, up to 1e-14 of the radius",
          {.number_type = "rational", .cases = 150, .degenerate_at_least = 0.4}, [] {
            const Refitted r = draw();
            RC_ASSERT(r.optimal.size() == r.tree.nodes.size() && r.bottom_up.size() == r.tree.nodes.size());
            for (std::size_t n = 0; n < r.tree.nodes.size(); ++n) {
              const auto optimal = exact_and_larger(r.optimal[n]), bottom_up = exact_and_larger(r.bottom_up[n]);
              for (const int v : r.vertices[static_cast<int>(n)]) {
                const auto p = convert<Rational>(r.deformed[v]);
                RC_ASSERT(encloses(optimal, p) == Verdict::holds);
                RC_ASSERT(encloses(bottom_up, p) == Verdict::holds);
              }
            }
          });
  t.holds("a node's optimal ball is no larger than its bottom-up ball, and the same at leaves",
          {.number_type = "double", .cases = 300, .degenerate_at_least = 0.4}, [] {
            const Refitted r = draw();
            for (std::size_t n = 0; n < r.tree.nodes.size(); ++n) {
              RC_ASSERT(r.optimal[n].radius <= r.bottom_up[n].radius * (1 + 1e-9));
              if (r.tree.nodes[n].child_count == 0) RC_ASSERT(r.optimal[n].radius == r.bottom_up[n].radius);
            }
          });
  t.holds("the optimal ball is what CGAL's exact solver finds, and the bottom-up ball what it finds around the children",
          {.number_type = "rational", .cases = 40, .degenerate_at_least = 0.4}, [] {
            const Refitted r = draw();
            const auto within = [](const oracle::RootNumber& optimum, double radius) {
              return optimum < Rational(radius * (1 + 1e-13) + 1e-300) && !(optimum < Rational(radius * (1 - 1e-9) - 1e-15));
            };
            for (std::size_t n = 0; n < r.tree.nodes.size(); ++n) {
              const TreeNode& node = r.tree.nodes[n];
              std::vector<Ball<Rational, 3>> points, children;
              for (const int v : r.vertices[static_cast<int>(n)])
                points.push_back({convert<Rational>(r.deformed[v]), Rational(0)});
              if (points.size() > 30) continue;
              RC_ASSERT(within(oracle::smallest_ball_by_cgal<3>(points).radius, r.optimal[n].radius));
              if (node.child_count == 0) continue;
              for (int c = 0; c < node.child_count; ++c) {
                const auto& ball = r.bottom_up[node.first_child + c];
                children.push_back({convert<Rational>(ball.center), Rational(ball.radius)});
              }
              RC_ASSERT(within(oracle::smallest_ball_by_cgal<3>(children).radius, r.bottom_up[n].radius));
            }
          });
}

}  // namespace proptests::suite_deformed
