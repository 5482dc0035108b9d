#include "lemmas/s44_joint_sets.hpp"

#include "proptests/counterexamples/s44_joint_sets.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using Point = Vec<Rational, 3>;
using JointSets = std::vector<PosedJointSet<Rational>>;

// One to three joint-sets of as many joints each, a reference ball, and a vertex of one of them.
struct Node {
  JointSets sets;
  Ball3<Rational> reference{*gen::rational_vector<3>(), *gen::unit_interval_rational()};
  std::size_t set = 0;  // of the vertex
  std::vector<Rational> weights, coefficients;
  Point vertex = reference.center + *gen::sphere_point<3>() * (reference.radius * *gen::unit_interval_rational());

  Node() {
    const int count = *rc::gen::inRange(1, 4), joints = *rc::gen::inRange(1, 4);
    std::vector<gen::RationalBounds> bounds;
    for (int z = 0; z < count; ++z) {
      auto limits = *gen::bounds_of_vertices(joints);
      bounds.push_back(limits.bounds);
      sets.push_back(
          {*rc::gen::container<std::vector<RigidTransform<Rational>>>(joints, gen::rigid_transform()),
           *rc::gen::weightedOneOf<Point>({{1, rc::gen::just(reference.center)}, {5, gen::rational_vector<3>()}}),
           limits.corners});
    }
    set = *rc::gen::inRange<std::size_t>(0, count);
    weights = *gen::admissible_weights(bounds[set]);
    coefficients = corners_span(bounds[set], sets[set].corners, weights).coefficients;
  }
  const PosedJointSet<Rational>& own() const { return sets[set]; }
  bool is_degenerate() const {
    return reference.radius == 0 || own().rotation_center == reference.center || own().corners.size() == 1;
  }
};

// As small as a ball about the mean of the centers can be.
Ball3<Rational> ball_around(const std::vector<SquaredBall<Rational, 3>>& parts) {
  Point sum = Point::Zero();
  for (const auto& part : parts) sum += part.center;
  Ball3<Rational> ball{sum / Rational(static_cast<int>(parts.size())), 0};
  for (const auto& part : parts)
    ball.radius = max_of(ball.radius, Rational(upper_root(squared_distance(part.center, ball.center)) +
                                               upper_root(part.squared_radius)));
  return ball;
}

PROPTEST(s44_joint_sets) {
  t.refuted(
      "a ball of the balls made with the corners and rotation center of the first joint-set encloses every vertex",
      {.form = "printed", .number_type = "rational"}, [] {
        const Node n;
        RC_PRE(is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients) == Verdict::holds);
        const auto ball = ball_around(joint_set_balls_printed<Rational>(n.sets, n.reference.center));
        RC_ASSERT(joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex).verdict ==
                  Verdict::holds);
      });
  t.holds("a ball of the balls of all joint-sets, each made with its own data, encloses every vertex",
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.3}, [] {
            const Node n;
            RC_PRE(is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients) == Verdict::holds);
            RC_CLASSIFY(n.is_degenerate(), "degenerate");
            const auto parts = joint_set_balls_repaired<Rational>(n.sets, n.reference.center);
            const auto ball = ball_around(parts);
            RC_ASSERT(encloses_parts<Rational>(ball, parts) == Verdict::holds);
            const auto found = joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_joint_set_vertex<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients, found) ==
                      Verdict::holds);
          });
  t.holds("the balls of a joint-set, among those of all, already enclose its own vertices",
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2}, [] {
            const Node n;
            RC_PRE(is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients) == Verdict::holds);
            RC_CLASSIFY(n.is_degenerate(), "degenerate");
            const auto parts = joint_set_balls_repaired<Rational>(n.sets, n.reference.center);
            auto first = parts.begin();
            for (std::size_t z = 0; z < n.set; ++z) first += static_cast<std::ptrdiff_t>(n.sets[z].corners.size());
            const auto ball = ball_around({first, first + static_cast<std::ptrdiff_t>(n.own().corners.size())});
            RC_ASSERT(joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex).verdict ==
                      Verdict::holds);
          });
  const auto refutes = [&t](const std::string& sentence, const s44_joints::Case& c) {
    t.example(sentence, {.form = "printed"}, [&] {
      const auto printed = joint_set_balls_printed<Rational>(c.sets, c.reference.center);
      const auto repaired = joint_set_balls_repaired<Rational>(c.sets, c.reference.center);
      const auto& own = c.sets[1];
      return is_vertex_of<Rational>(own, c.reference, c.weights, c.vertex, {1}) == Verdict::holds &&
             blend_vertex<Rational>(own, c.weights, c.vertex) == c.deformed &&
             encloses_parts<Rational>(c.ball, printed) == Verdict::holds &&
             joint_set_vertex<Rational>(c.ball, own, c.reference, c.weights, c.vertex).verdict == Verdict::fails &&
             joint_set_vertex<Rational>(ball_around(repaired), own, c.reference, c.weights, c.vertex).verdict ==
                 Verdict::holds;
    });
  };
  refutes("one rotation center for two joint-sets misses a vertex that the second one turns",
          s44_joints::rotation_center);
  refutes("one list of corners for two joint-sets misses a vertex that the second one moves", s44_joints::corners);

  t.holds("a vertex of one joint moves rigidly, whatever its rotation center", {.number_type = "rational"}, [] {
    const auto joint = *gen::rigid_transform();
    const Point center = *gen::rational_vector<3>(), v = *gen::rational_vector<3>();
    const std::vector<Rational> w{1};
    RC_ASSERT(blend_vertex<Rational>({{joint}, center, {{1}}}, w, v) == apply(joint, v));
  });
  t.holds("the comparison of a sum of roots is right where the roots are known", {.number_type = "rational"}, [] {
    const Rational a = abs(*gen::rational());
    const Rational b = *rc::gen::oneOf(rc::gen::just(a), gen::positive_rational());
    const Rational almost_one = *rc::gen::element(Rational(1, 2), Rational(19, 20), Rational(99, 100));
    const Rational c =
        *rc::gen::element(Rational(a + b), Rational((a + b) * almost_one), Rational(-a - b), Rational(a - b));
    RC_ASSERT(roots_sum_at_most(sq(a), sq(b), c) == verdict_of(a + b <= c));
  });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const Node n;
    RC_PRE(is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients) == Verdict::holds);
    const bool as_printed = *rc::gen::arbitrary<bool>();
    const auto ball = ball_around(as_printed ? joint_set_balls_printed<Rational>(n.sets, n.reference.center)
                                             : joint_set_balls_repaired<Rational>(n.sets, n.reference.center));
    decide_by_all(
        []<class S>(const Ball3<S>& b, const std::vector<RigidTransform<S>>& joints, const Vec<S, 3>& center,
                    const Corners<S>& corners, const Ball3<S>& reference, const std::vector<S>& w, const Vec<S, 3>& v) {
          return joint_set_vertex<S>(b, {joints, center, corners}, reference, w, v).verdict;
        },
        ball, n.own().transforms, n.own().rotation_center, n.own().corners, n.reference, n.weights, n.vertex);
    decide_by_all(
        []<class S>(const Ball3<S>& b, const Vec<S, 3>& center, const S& squared_radius) {
          return encloses_part<S>(b, {center, squared_radius});
        },
        ball, n.reference.center, Rational(*gen::unit_interval_rational()));
  });

  t.holds("mutated parts are rejected", {.number_type = "rational", .cases = 300}, [] {
    const Node n;
    RC_PRE(is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients) == Verdict::holds);
    const auto good = joint_set_vertex<Rational>({n.vertex, 1}, n.own(), n.reference, n.weights, n.vertex);
    const auto rejected = [&](const JointSetVertex<Rational>& w) {
      return is_joint_set_vertex<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients, w) ==
             Verdict::fails;
    };
    auto linear = good, spherical = good, offset = good, shifted = good, longer = good;
    const Point bump = *gen::nonzero_vector<3>();
    linear.linear += bump;
    spherical.spherical += bump;
    offset.offset += bump;
    RC_ASSERT(rejected(linear) && rejected(spherical) && rejected(offset));
    // The right sum of wrong parts.
    shifted.linear += bump, shifted.spherical -= bump;
    RC_ASSERT(rejected(shifted));
    const Point leap = Point(1, 0, 0) * (2 * n.reference.radius + 1);
    longer.offset += leap, longer.spherical -= leap;
    RC_ASSERT(rejected(longer));
  });

  const Options in_ball{.form = "repaired", .hypothesis = "the vertex is in the reference ball"};
  t.example("a vertex outside the reference ball is missed", in_ball, [] {
    const auto& c = s44_joints::corners;
    const auto ball = ball_around(joint_set_balls_repaired<Rational>(c.sets, c.reference.center));
    const Point outside(6, 0, 0);
    return is_vertex_of<Rational>(c.sets[1], c.reference, c.weights, outside, {1}) == Verdict::fails &&
           joint_set_vertex<Rational>(ball, c.sets[1], c.reference, c.weights, outside).verdict == Verdict::fails;
  });
  const Options admissible{.form = "repaired", .hypothesis = "the weights are admissible"};
  t.example("a vertex whose weights are no combination of the corners is missed", admissible, [] {
    const auto& c = s44_joints::corners;
    const auto ball = ball_around(joint_set_balls_repaired<Rational>(c.sets, c.reference.center));
    const std::vector<Rational> beyond{-1, 2};
    return is_vertex_of<Rational>(c.sets[1], c.reference, beyond, c.vertex, {1}) == Verdict::fails &&
           joint_set_vertex<Rational>(ball, c.sets[1], c.reference, beyond, c.vertex).verdict == Verdict::fails;
  });
  const Options all_sets{.form = "repaired", .hypothesis = "the ball encloses the balls of every joint-set"};
  t.example("a ball of the first joint-set alone misses a vertex of the second", all_sets, [] {
    const auto& c = s44_joints::corners;
    const JointSets first{c.sets[0]};
    const auto ball = ball_around(joint_set_balls_repaired<Rational>(first, c.reference.center));
    return encloses_parts<Rational>(ball, joint_set_balls_repaired<Rational>(c.sets, c.reference.center)) ==
               Verdict::fails &&
           joint_set_vertex<Rational>(ball, c.sets[1], c.reference, c.weights, c.vertex).verdict == Verdict::fails;
  });
}

}  // namespace
}  // namespace proptests
