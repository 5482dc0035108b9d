// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s44_joint_sets.hpp"

#include "proptests/counterexamples/s44_joint_sets.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_s44_joint_sets {
namespace {

using namespace refitlab;
using Point = Vec<Rational, 3>;
using JointSets = std::vector<PosedJointSet<Rational>>;

// Draws one to three joint-sets of as many joints each, a reference ball, and a vertex of one of them.
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
      sets.push_back({*rc::gen::container<std::vector<RigidTransform<Rational>>>(joints, gen::rigid_transform()),
                      *rc::gen::weightedOneOf<Point>({{1, rc::gen::just(reference.center)}, {5, gen::rational_vector<3>()}}),
                      limits.vertices});
    }
    set = *rc::gen::inRange<std::size_t>(0, count);
    weights = *gen::admissible_weights(bounds[set]);
    coefficients = weight_vertices_span(bounds[set], sets[set].weight_vertices, weights).coefficients;
  }
  const PosedJointSet<Rational>& own() const { return sets[set]; }
  bool is_degenerate() const {
    return reference.radius == 0 || own().rotation_center == reference.center || own().weight_vertices.size() == 1;
  }
};

// Returns the smallest ball about the mean of the centers, up to rational roots.
Ball3<Rational> ball_around(const std::vector<SquaredBall<Rational, 3>>& parts) {
  Point sum = Point::Zero();
  for (const auto& part : parts) sum += part.center;
  Ball3<Rational> ball{sum / Rational(static_cast<int>(parts.size())), 0};
  for (const auto& part : parts)
    ball.radius =
        max_of(ball.radius, Rational(upper_root(squared_distance(part.center, ball.center)) + upper_root(part.squared_radius)));
  return ball;
}

// Returns Im(q x q*) / ||q||^2 by products of quaternions.
Point turned_by(const Quaternion<Rational>& q, const Point& x) {
  return imaginary(multiply(multiply(q, Quaternion<Rational>(0, x[0], x[1], x[2])), conjugate(q))) / squared_norm(q);
}

Point vertex_of(const PosedJointSet<Rational>& set, const std::vector<Rational>& w, const Point& v) {
  return spherical_blend<Rational>(set.transforms, w, set.rotation_center, v);
}

bool is_vertex(const Node& n) {
  return is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients) == Verdict::holds;
}

// Judges the case of the theorem: the ball around the balls of all joint-sets.
Weakening of(const Node& n) {
  const auto ball = ball_around(joint_set_balls_repaired<Rational>(n.sets, n.reference.center));
  return {is_vertex_of<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients),
          joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex).verdict};
}

void formulas_are_those_of_the_paper(Suite& t) {
  t.holds("the blend, the vertex and the balls are the sums that they are said to be", {.number_type = "rational", .cases = 400},
          [] {
            const Node n;
            RC_PRE(is_vertex(n));
            const auto& set = n.own();
            Quaternion<Rational> q = Quaternion<Rational>::Zero();
            Point linear = Point::Zero();
            std::vector<Point> images;
            for (std::size_t i = 0; i < n.weights.size(); ++i) {
              images.push_back(turned_by(set.transforms[i].rotation, set.rotation_center) + set.transforms[i].translation);
              q += set.transforms[i].rotation * n.weights[i];
              linear += images[i] * n.weights[i];
            }
            RC_CLASSIFY(n.weights.size() > 2, "three joints");
            RC_ASSERT(blended_rotation<Rational>(set.transforms, n.weights) == q);
            const Point deformed = linear + turned_by(q, n.vertex - set.rotation_center);
            RC_ASSERT(vertex_of(set, n.weights, n.vertex) == deformed);
            const JointSets alone{set};
            const auto balls = joint_set_balls_repaired<Rational>(alone, n.reference.center);
            RC_ASSERT(balls.size() == set.weight_vertices.size());
            for (std::size_t k = 0; k < balls.size(); ++k) {
              Point center = Point::Zero();
              for (std::size_t i = 0; i < images.size(); ++i) center += images[i] * set.weight_vertices[k][i];
              RC_ASSERT(balls[k].center == center);
              RC_ASSERT(balls[k].squared_radius == squared_distance(n.reference.center, set.rotation_center));
            }
            // The balls of several joint-sets come one after the other.
            std::size_t count = 0;
            for (const auto& s : n.sets) count += s.weight_vertices.size();
            RC_ASSERT(joint_set_balls_repaired<Rational>(n.sets, n.reference.center).size() == count);
          });
  t.holds("the verdict on a vertex is whether the ball, larger by r, encloses it", {.number_type = "rational", .cases = 400}, [] {
    const Node n;
    RC_PRE(is_vertex(n));
    const Point deformed = vertex_of(n.own(), n.weights, n.vertex);
    const Rational radius = abs(*gen::rational().as("R")), amount = *gen::positive_rational().as("amount");
    const Point way = *gen::sphere_point<3>();
    const auto verdict = [&](const Rational& distance) {
      const Ball3<Rational> ball{deformed + way * distance, radius};
      return joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex).verdict;
    };
    RC_ASSERT(verdict(radius + n.reference.radius) == Verdict::holds);
    RC_ASSERT(verdict(radius + n.reference.radius + amount) == Verdict::fails);
  });
  t.holds("a ball encloses balls if it encloses each of them, to the farthest point", {.number_type = "rational"}, [] {
    const Ball3<Rational> ball{*gen::rational_vector<3>(), abs(*gen::rational().as("R"))};
    const Rational amount = *gen::positive_rational().as("amount");
    std::vector<SquaredBall<Rational, 3>> parts;
    const auto at = [&](const Rational& distance, const Rational& radius) {
      return SquaredBall<Rational, 3>{ball.center + *gen::sphere_point<3>() * distance, radius * radius};
    };
    for (int k = 0; k < 3; ++k) {
      const Rational share = *gen::unit_interval_rational().as("share");
      // They touch from inside.
      parts.push_back(at(ball.radius * share, ball.radius * (Rational(1) - share)));
    }
    RC_ASSERT(encloses_parts<Rational>(ball, parts) == Verdict::holds);
    const auto k = *rc::gen::inRange<std::size_t>(0, 3).as("which");
    for (const auto& wrong : {at(amount, ball.radius), at(ball.radius, amount), at(ball.radius + amount, Rational(0)),
                              at(Rational(0), ball.radius + amount)}) {
      auto others = parts;
      others[k] = wrong;
      RC_ASSERT(encloses_parts<Rational>(ball, others) == Verdict::fails);
    }
    RC_ASSERT(encloses_part<Rational>({ball.center, -amount}, at(Rational(0), Rational(0))) == Verdict::fails);
    RC_ASSERT(encloses_part<Rational>({ball.center, Rational(0)}, at(Rational(0), Rational(0))) == Verdict::holds);
  });
}

void hypotheses_need_each_part(Suite& t) {
  t.holds("a vertex on the surface of the reference ball is in it", {.number_type = "rational"}, [] {
    Node n;
    RC_PRE(is_vertex(n));
    n.vertex = n.reference.center + *gen::sphere_point<3>() * n.reference.radius;
    RC_ASSERT(of(n).hypothesis == Verdict::holds && of(n).conclusion == Verdict::holds);
  });
  needs_part(
      t, "the vertex is in the reference ball",
      [] {
        Node n;
        RC_PRE(is_vertex(n));
        n.vertex = n.reference.center + *gen::sphere_point<3>() * (n.reference.radius + *gen::positive_rational().as("amount"));
        return of(n);
      },
      150);
  needs_part(
      t, "the weights are the combination of the weight vertices",
      [] {
        Node n;
        RC_PRE(is_vertex(n));
        const Rational amount = *gen::positive_rational().as("amount");
        const auto i = *rc::gen::inRange<std::size_t>(0, n.weights.size()).as("which");
        n.weights[i] += amount;
        if (n.weights.size() > 1) n.weights[(i + 1) % n.weights.size()] -= amount;  // This keeps the sum.
        RC_PRE(minkowski_sum_hypotheses(blended_rotation<Rational>(n.own().transforms, n.weights)) == Verdict::holds);
        return of(n);
      },
      150);
  t.holds("a blend that is 0 is no rotation of a vertex", {.number_type = "rational"}, [] {
    const auto joint = *gen::rigid_transform();
    auto opposite = joint;
    opposite.rotation = -joint.rotation;
    const Point center = *gen::rational_vector<3>(), v = *gen::rational_vector<3>();
    const std::vector<Rational> halves{Rational(1, 2), Rational(1, 2)}, thirds{Rational(1, 3), Rational(2, 3)}, alone{1};
    const Ball3<Rational> reference{v, Rational(0)};
    const auto is_vertex = [&](const std::vector<Rational>& w) {
      return is_vertex_of<Rational>({{joint, opposite}, center, {w}}, reference, w, v, alone);
    };
    RC_ASSERT(is_vertex(halves) == Verdict::fails);
    RC_ASSERT(is_vertex(thirds) == Verdict::holds);
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("a part that is too long or not in its hull is rejected, with the right sum", {.number_type = "rational", .cases = 600},
          [] {
            Node n;
            n.vertex = n.reference.center;  // There is no offset.
            n.reference.radius = *gen::positive_rational().as("r");
            RC_PRE(is_vertex(n));
            const auto good = joint_set_vertex<Rational>({n.vertex, 1}, n.own(), n.reference, n.weights, n.vertex);
            const auto verdict = [&](const JointSetVertex<Rational>& w) {
              return is_joint_set_vertex<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients, w);
            };
            RC_ASSERT(verdict(good) == Verdict::holds);
            RC_ASSERT(good.offset == Point(Point::Zero()));
            const Rational length = squared_norm(good.spherical);
            RC_PRE(length > 0);
            auto hull = good, spherical = good, offset = good, sum = good;
            hull.linear += good.spherical * Rational(2), hull.spherical = -good.spherical;  // It is as long.
            RC_ASSERT(verdict(hull) == Verdict::fails);
            // It is longer, by at most r: ||s|| is at most ||s||^2 + 1.
            const Point more = good.spherical * (n.reference.radius / (length + Rational(1)));
            spherical.spherical += more, spherical.offset -= more;
            RC_ASSERT(squared_norm(spherical.offset) <= sq(n.reference.radius));
            RC_ASSERT(verdict(spherical) == Verdict::fails);
            sum.offset[*rc::gen::inRange(0, 3)] += *rc::gen::element(n.reference.radius, Rational(-n.reference.radius));
            RC_ASSERT(verdict(sum) == Verdict::fails);
            offset.spherical = Point::Zero(), offset.offset = good.spherical;
            RC_ASSERT(verdict(offset) == verdict_of(length <= sq(n.reference.radius)));
            n.reference.radius = length / (Rational(1) + length) / Rational(2);  // This is less than the length.
            RC_ASSERT(verdict(offset) == Verdict::fails);
          });
}

void balls_of_all_joint_sets_enclose_every_vertex(Suite& t) {
  t.refuted("a ball of the balls made with the weight vertices and rotation center of the first joint-set encloses every vertex",
            {.form = "implied", .number_type = "rational"}, [] {
              const Node n;
              RC_PRE(is_vertex(n));
              const auto ball = ball_around(joint_set_balls_printed<Rational>(n.sets, n.reference.center));
              RC_ASSERT(joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex).verdict == Verdict::holds);
            });
  t.holds("a ball of the balls of all joint-sets, each made with its own data, encloses every vertex",
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.3, .degenerate_at_most = 0.85},
          [] {
            const Node n;
            RC_PRE(is_vertex(n));
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
          {.form = "repaired", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.2, .degenerate_at_most = 0.85},
          [] {
            const Node n;
            RC_PRE(is_vertex(n));
            RC_CLASSIFY(n.is_degenerate(), "degenerate");
            const auto parts = joint_set_balls_repaired<Rational>(n.sets, n.reference.center);
            auto first = parts.begin();
            for (std::size_t z = 0; z < n.set; ++z) first += static_cast<std::ptrdiff_t>(n.sets[z].weight_vertices.size());
            const auto ball = ball_around({first, first + static_cast<std::ptrdiff_t>(n.own().weight_vertices.size())});
            RC_ASSERT(joint_set_vertex<Rational>(ball, n.own(), n.reference, n.weights, n.vertex).verdict == Verdict::holds);
          });
  const auto refutes = [&t](const std::string& sentence, const s44_joints::Case& c) {
    t.example(sentence, {.form = "printed"}, [&] {
      const auto printed = joint_set_balls_printed<Rational>(c.sets, c.reference.center);
      const auto repaired = joint_set_balls_repaired<Rational>(c.sets, c.reference.center);
      const auto& own = c.sets[1];
      return is_vertex_of<Rational>(own, c.reference, c.weights, c.vertex, {1}) == Verdict::holds &&
             vertex_of(own, c.weights, c.vertex) == c.deformed && encloses_parts<Rational>(c.ball, printed) == Verdict::holds &&
             joint_set_vertex<Rational>(c.ball, own, c.reference, c.weights, c.vertex).verdict == Verdict::fails &&
             joint_set_vertex<Rational>(ball_around(repaired), own, c.reference, c.weights, c.vertex).verdict == Verdict::holds;
    });
  };
  refutes("one rotation center for two joint-sets misses a vertex that the second one turns", s44_joints::rotation_center);
  refutes("one list of weight vertices for two joint-sets misses a vertex that the second one moves",
          s44_joints::weight_vertices);

  t.holds("a vertex of one joint moves rigidly, whatever its rotation center", {.number_type = "rational"}, [] {
    const auto joint = *gen::rigid_transform();
    const Point center = *gen::rational_vector<3>(), v = *gen::rational_vector<3>();
    const std::vector<Rational> w{1};
    RC_ASSERT(vertex_of({{joint}, center, {{1}}}, w, v) == apply(joint, v));
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("the comparison of a sum of roots is right where the roots are known", {.number_type = "rational"}, [] {
    const Rational a = abs(*gen::rational());
    const Rational b = *rc::gen::oneOf(rc::gen::just(a), gen::positive_rational());
    const Rational almost_one = *rc::gen::element(Rational(1, 2), Rational(19, 20), Rational(99, 100));
    const Rational c = *rc::gen::element(Rational(a + b), Rational((a + b) * almost_one), Rational(-a - b), Rational(a - b));
    RC_ASSERT(roots_sum_at_most(sq(a), sq(b), c) == verdict_of(a + b <= c));
  });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const Node n;
    RC_PRE(is_vertex(n));
    const bool as_printed = *rc::gen::arbitrary<bool>();
    const auto ball = ball_around(as_printed ? joint_set_balls_printed<Rational>(n.sets, n.reference.center)
                                             : joint_set_balls_repaired<Rational>(n.sets, n.reference.center));
    decide_by_all(
        []<class S>(const Ball3<S>& b, const std::vector<RigidTransform<S>>& joints, const Vec<S, 3>& center,
                    const WeightVertices<S>& weight_vertices, const Ball3<S>& reference, const std::vector<S>& w,
                    const Vec<S, 3>& v) {
          return joint_set_vertex<S>(b, {joints, center, weight_vertices}, reference, w, v).verdict;
        },
        ball, n.own().transforms, n.own().rotation_center, n.own().weight_vertices, n.reference, n.weights, n.vertex);
    decide_by_all(
        []<class S>(const Ball3<S>& b, const Vec<S, 3>& center, const S& squared_radius) {
          return encloses_part<S>(b, {center, squared_radius});
        },
        ball, n.reference.center, Rational(*gen::unit_interval_rational()));
  });

  t.holds("mutated parts are rejected", {.number_type = "rational", .cases = 300}, [] {
    const Node n;
    RC_PRE(is_vertex(n));
    const auto good = joint_set_vertex<Rational>({n.vertex, 1}, n.own(), n.reference, n.weights, n.vertex);
    const auto rejected = [&](const JointSetVertex<Rational>& w) {
      return is_joint_set_vertex<Rational>(n.own(), n.reference, n.weights, n.vertex, n.coefficients, w) == Verdict::fails;
    };
    auto linear = good, spherical = good, offset = good, shifted = good, longer = good;
    const Point bump = *gen::nonzero_vector<3>();
    linear.linear += bump;
    spherical.spherical += bump;
    offset.offset += bump;
    RC_ASSERT(rejected(linear) && rejected(spherical) && rejected(offset));
    // The wrong parts have the right sum.
    shifted.linear += bump, shifted.spherical -= bump;
    RC_ASSERT(rejected(shifted));
    const Point leap = Point(1, 0, 0) * (2 * n.reference.radius + 1);
    longer.offset += leap, longer.spherical -= leap;
    RC_ASSERT(rejected(longer));
  });
}

void pinned_cases(Suite& t) {
  t.example("a vertex outside the reference ball is missed",
            {.form = "repaired", .hypothesis = "the vertex is in the reference ball"}, [] {
              const auto& c = s44_joints::weight_vertices;
              const auto ball = ball_around(joint_set_balls_repaired<Rational>(c.sets, c.reference.center));
              const Point outside(6, 0, 0);
              return is_vertex_of<Rational>(c.sets[1], c.reference, c.weights, outside, {1}) == Verdict::fails &&
                     joint_set_vertex<Rational>(ball, c.sets[1], c.reference, c.weights, outside).verdict == Verdict::fails;
            });
  t.example("a vertex whose weights are no combination of the weight vertices is missed",
            {.form = "repaired", .hypothesis = "the weights are admissible"}, [] {
              const auto& c = s44_joints::weight_vertices;
              const auto ball = ball_around(joint_set_balls_repaired<Rational>(c.sets, c.reference.center));
              const std::vector<Rational> beyond{-1, 2};
              return is_vertex_of<Rational>(c.sets[1], c.reference, beyond, c.vertex, {1}) == Verdict::fails &&
                     joint_set_vertex<Rational>(ball, c.sets[1], c.reference, beyond, c.vertex).verdict == Verdict::fails;
            });
  t.example("a ball of the first joint-set alone misses a vertex of the second",
            {.form = "repaired", .hypothesis = "the ball encloses the balls of every joint-set"}, [] {
              const auto& c = s44_joints::weight_vertices;
              const JointSets first{c.sets[0]};
              const auto ball = ball_around(joint_set_balls_repaired<Rational>(first, c.reference.center));
              return encloses_parts<Rational>(ball, joint_set_balls_repaired<Rational>(c.sets, c.reference.center)) ==
                         Verdict::fails &&
                     joint_set_vertex<Rational>(ball, c.sets[1], c.reference, c.weights, c.vertex).verdict == Verdict::fails;
            });
}

PROPTEST(s44_joint_sets) {
  formulas_are_those_of_the_paper(t);
  hypotheses_need_each_part(t);
  checks_need_each_part(t);
  balls_of_all_joint_sets_enclose_every_vertex(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s44_joint_sets
