// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/s42_linear_part_hull.hpp"

#include "proptests/counterexamples/s42_linear_part_hull.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_s42_linear_part_hull {
namespace {

using namespace refitlab;
using Weights = std::vector<Rational>;

// Draws weight bounds, their weight vertices, and a point for each weight.
template <int D>
struct LinearPart {
  gen::WeightPolytope weights;
  std::vector<Vec<Rational, D>> points;

  explicit LinearPart(int most)
      : weights(*gen::any_bounds_of_vertices(most)),
        points(*rc::gen::container<std::vector<Vec<Rational, D>>>(weights.bounds.low.size(), gen::rational_vector<D>())) {
    bool coincident = false;
    for (std::size_t i = 1; i < points.size(); ++i) coincident = coincident || points[i] == points[0];
    RC_CLASSIFY(coincident || weights.vertices.size() == 1, "degenerate");
  }
  auto in_hull(const Weights& w) const { return linear_part_in_hull<Rational, D>(weights.bounds, weights.vertices, points, w); }
  auto from_hull(const Weights& u) const { return hull_in_linear_part<Rational, D>(weights.bounds, weights.vertices, points, u); }
  Weights coefficients() const { return *gen::convex_weights(static_cast<int>(weights.vertices.size())); }
};

// Draws a linear part of free weights of three or four points. It has as many weight vertices, so that there is one between the
// first and the last.
struct SeveralWeightVertices {
  gen::WeightPolytope weights;
  std::vector<Vec<Rational, 3>> points =
      *rc::gen::oneOf(rc::gen::container<std::vector<Vec<Rational, 3>>>(3, gen::rational_vector<3>()),
                      rc::gen::container<std::vector<Vec<Rational, 3>>>(4, gen::rational_vector<3>()));

  SeveralWeightVertices() {
    const std::size_t n = points.size();
    weights.bounds = {Weights(n, Rational(0)), Weights(n, Rational(1))};
    weights.vertices.assign(n, Weights(n, Rational(0)));
    for (std::size_t k = 0; k < n; ++k) weights.vertices[k][k] = 1;
  }
  auto in_hull(const Weights& w) const { return linear_part_in_hull<Rational, 3>(weights.bounds, weights.vertices, points, w); }
  auto from_hull(const Weights& u) const { return hull_in_linear_part<Rational, 3>(weights.bounds, weights.vertices, points, u); }
  Weights coefficients() const { return *gen::convex_weights(static_cast<int>(weights.vertices.size())); }
  Verdict hypotheses() const { return linear_part_hull_hypotheses<Rational, 3>(weights.bounds, weights.vertices, points); }
  std::size_t some_weight_vertex() const {
    return *rc::gen::inRange<std::size_t>(0, weights.vertices.size()).as("which weight vertex");
  }
};

void hypotheses_need_each_part(Suite& t) {
  needs_part(t, "one of the weight vertices is not listed", [] {
    SeveralWeightVertices part;
    const auto k = static_cast<std::ptrdiff_t>(part.some_weight_vertex());
    const Weights missing = part.weights.vertices[static_cast<std::size_t>(k)];
    part.weights.vertices.erase(part.weights.vertices.begin() + k);
    return Weakening{part.hypotheses(), part.in_hull(missing).verdict};
  });
  needs_part(t, "one of the listed weight vertices is not admissible", [] {
    SeveralWeightVertices part;
    const auto k = part.some_weight_vertex();
    auto& weight_vertices = part.weights.vertices;
    Weights outside = weight_vertices[k], only(weight_vertices.size() + 1, Rational(0));
    outside[0] -= Rational(2), outside[1] += Rational(2);
    weight_vertices.insert(weight_vertices.begin() + static_cast<std::ptrdiff_t>(k), outside);
    only[k] = 1;
    return Weakening{part.hypotheses(), part.from_hull(only).verdict};
  });
  t.holds("a point more or less than there are weights is refused", {.number_type = "rational"}, [] {
    SeveralWeightVertices part;
    RC_ASSERT(part.hypotheses() == Verdict::holds);
    auto fewer = part, more = part;
    fewer.points.pop_back();
    more.points.push_back(part.points[0]);
    RC_ASSERT(fewer.hypotheses() == Verdict::fails && more.hypotheses() == Verdict::fails);
  });
  needs_part(t, "the weights are admissible", [] {
    SeveralWeightVertices part;
    const bool at_one_place = *rc::gen::arbitrary<bool>().as("all points at one place");
    if (at_one_place) part.points.assign(part.points.size(), part.points[0]);  // then the blend is in the hull all the same
    Weights w = *gen::admissible_weights(part.weights.bounds);
    const auto i = *rc::gen::inRange<std::size_t>(0, w.size()).as("which weight");
    const Rational way = part.weights.bounds.high[i] - w[i] + *gen::positive_rational().as("amount");
    w[i] += way, w[(i + 1) % w.size()] -= way;
    RC_ASSERT(part.in_hull(w).verdict == Verdict::fails);
    return Weakening{admits<Rational>(part.weights.bounds, w), part.in_hull(w).verdict};
  });
}

// Checks statements with intervals that cannot decide one part alone. In exact numbers a true statement could lose that part
// unseen.
void undecided_parts_are_not_lost(Suite& t) {
  t.example("a blend of points that intervals only enclose is decided for its weights, not for its place", {}, [] {
    const WeightBounds<Interval> free{{Interval(0), Interval(0)}, {Interval(1), Interval(1)}};
    const WeightVertices<Interval> weight_vertices{{Interval(1), Interval(0)}, {Interval(0), Interval(1)}};
    const std::vector<Interval> halves{Interval(0.5), Interval(0.5)};
    const Interval third = lift<Interval>(Rational(1, 3)), zero(0);
    const std::vector<Vec<Interval, 3>> points{{third, zero, zero}, {zero, third, zero}};
    return weight_vertices_span(free, weight_vertices, halves).verdict == Verdict::holds &&
           linear_part_in_hull<Interval, 3>(free, weight_vertices, points, halves).verdict == Verdict::undecided &&
           hull_in_linear_part<Interval, 3>(free, weight_vertices, points, halves).verdict == Verdict::undecided;
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("a point of the hull or a blend that is wrong in one coordinate, in either direction, is rejected",
          {.number_type = "rational"}, [] {
            const SeveralWeightVertices part;
            const auto images = weight_vertex_images<Rational, 3>(part.weights.vertices, part.points);
            const auto forward = part.in_hull(*gen::admissible_weights(part.weights.bounds));
            const auto backward = part.from_hull(part.coefficients());
            const Rational amount = *gen::positive_rational().as("amount");
            const Rational change = *rc::gen::element(amount, Rational(-amount)).as("change");
            const int i = *rc::gen::inRange(0, 3).as("coordinate");
            auto moved = forward.point, other = backward.point;
            moved[i] += change, other[i] += change;
            RC_ASSERT((is_hull_point<Rational, 3>(images, moved, forward.coefficients) == Verdict::fails));
            RC_ASSERT((is_admissible_blend<Rational, 3>(part.weights.bounds, part.points, other, backward.coefficients) ==
                       Verdict::fails));
          });
  t.holds("a coefficient or a weight too many or too few is rejected", {.number_type = "rational"}, [] {
    const SeveralWeightVertices part;
    auto images = weight_vertex_images<Rational, 3>(part.weights.vertices, part.points);
    const auto forward = part.in_hull(*gen::admissible_weights(part.weights.bounds));
    auto longer = forward.coefficients;
    longer.push_back(Rational(0));
    RC_ASSERT((is_hull_point<Rational, 3>(images, forward.point, longer) == Verdict::fails));
    images.push_back(images[0]);
    RC_ASSERT((is_hull_point<Rational, 3>(images, forward.point, forward.coefficients) == Verdict::fails));
    RC_ASSERT((is_hull_point<Rational, 3>({}, forward.point, {}) == Verdict::fails));
    const auto backward = part.from_hull(part.coefficients());
    auto points = part.points;
    points.push_back(Vec<Rational, 3>::Zero());
    RC_ASSERT(
        (is_admissible_blend<Rational, 3>(part.weights.bounds, points, backward.point, backward.coefficients) == Verdict::fails));
    points.resize(part.points.size() - 1);
    RC_ASSERT(
        (is_admissible_blend<Rational, 3>(part.weights.bounds, points, backward.point, backward.coefficients) == Verdict::fails));
  });
  t.holds("the images are the weight vertices' sums, coordinate by coordinate", {.number_type = "rational"}, [] {
    const SeveralWeightVertices part;
    const auto images = weight_vertex_images<Rational, 3>(part.weights.vertices, part.points);
    RC_ASSERT(images.size() == part.weights.vertices.size());
    for (std::size_t k = 0; k < images.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        Rational sum(0);
        for (std::size_t j = 0; j < part.points.size(); ++j) sum += part.weights.vertices[k][j] * part.points[j][i];
        RC_ASSERT(images[k][i] == sum);
      }
  });
  t.holds("a normal separates a point from others only if it is strictly beyond each of them", {.number_type = "rational"}, [] {
    const auto points = *rc::gen::container<std::vector<Vec<Rational, 3>>>(3, gen::rational_vector<3>()).as("points");
    const Vec<Rational, 3> normal = *gen::rational_vector<3>().as("normal");
    const Vec<Rational, 3> x = *rc::gen::oneOf(rc::gen::elementOf(points), gen::rational_vector<3>()).as("point");
    bool beyond = true;
    for (const auto& p : points) beyond = beyond && dot(normal, p) < dot(normal, x);
    RC_CLASSIFY(beyond, "separated");
    RC_ASSERT((separates<Rational, 3>(normal, x, points) == verdict_of(beyond)));
  });
}

void blends_are_the_hull_of_the_images(Suite& t) {
  t.holds("the blend of the points with admissible weights is in the hull of the weight vertex images",
          {.form = "printed", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.15, .degenerate_at_most = 0.85},
          [] {
            gen::for_some_dimension<3, 4>([](auto d) {
              const LinearPart<d()> part(4);
              const Weights w = *gen::admissible_weights(part.weights.bounds);
              RC_ASSERT((linear_part_hull_hypotheses<Rational, d()>(part.weights.bounds, part.weights.vertices, part.points) ==
                         Verdict::holds));
              const auto found = part.in_hull(w);
              RC_ASSERT(found.verdict == Verdict::holds);
              const auto images = weight_vertex_images<Rational, d()>(part.weights.vertices, part.points);
              RC_ASSERT((is_hull_point<Rational, d()>(images, found.point, found.coefficients) == Verdict::holds));
            });
          });

  t.holds("every point of the hull of the weight vertex images is a blend of the points with admissible weights",
          {.form = "printed", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.15, .degenerate_at_most = 0.85},
          [] {
            gen::for_some_dimension<3, 4>([](auto d) {
              const LinearPart<d()> part(4);
              const auto found = part.from_hull(part.coefficients());
              RC_ASSERT(found.verdict == Verdict::holds);
              RC_ASSERT((is_admissible_blend<Rational, d()>(part.weights.bounds, part.points, found.point, found.coefficients) ==
                         Verdict::holds));
            });
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const LinearPart<3> part(3);
    const Weights w = *gen::admissible_weights(part.weights.bounds);
    decide_by_all([]<class S>(const WeightBounds<S>& l, const WeightVertices<S>& c, const std::vector<Vec<S, 3>>& p,
                              const std::vector<S>& x) { return linear_part_in_hull<S, 3>(l, c, p, x).verdict; },
                  part.weights.bounds, part.weights.vertices, part.points, w);
    decide_by_all([]<class S>(const WeightBounds<S>& l, const WeightVertices<S>& c, const std::vector<Vec<S, 3>>& p,
                              const std::vector<S>& u) { return hull_in_linear_part<S, 3>(l, c, p, u).verdict; },
                  part.weights.bounds, part.weights.vertices, part.points, part.coefficients());
  });

  t.holds("a mutated witness of either inclusion is rejected", {.number_type = "rational", .cases = 300}, [] {
    const LinearPart<3> part(4);
    const auto& [bounds, weight_vertices] = part.weights;
    const auto images = weight_vertex_images<Rational, 3>(weight_vertices, part.points);
    const Weights w = *gen::admissible_weights(bounds);
    const auto forward = part.in_hull(w);
    const auto backward = part.from_hull(part.coefficients());
    const Rational bump = *gen::positive_rational();
    Vec<Rational, 3> moved = forward.point, other = backward.point;
    moved[*rc::gen::inRange(0, 3)] += bump;
    other[*rc::gen::inRange(0, 3)] -= bump;
    RC_ASSERT((is_hull_point<Rational, 3>(images, moved, forward.coefficients) == Verdict::fails));
    RC_ASSERT((is_admissible_blend<Rational, 3>(bounds, part.points, other, backward.coefficients) == Verdict::fails));
    Weights u = forward.coefficients, x = backward.coefficients;
    u[0] -= bump;
    x[0] += bump;
    RC_ASSERT((is_hull_point<Rational, 3>(images, forward.point, u) == Verdict::fails));
    RC_ASSERT((is_admissible_blend<Rational, 3>(bounds, part.points, backward.point, x) == Verdict::fails));
  });

  t.example("a blend with convex weights that the bounds do not admit is rejected", {}, [] {
    return is_admissible_blend<Rational, 3>(s42::segment, s42::points, s42::points[1], s42::second) == Verdict::holds &&
           is_admissible_blend<Rational, 3>(s42::halves, s42::points, s42::points[1], s42::second) == Verdict::fails;
  });
}

void pinned_cases(Suite& t) {
  t.example("without one of the weight vertices a blend is outside the hull",
            {.form = "printed", .hypothesis = "the list has every weight vertex"}, [] {
              const auto images = weight_vertex_images<Rational, 3>(s42::first_only, s42::points);
              const auto found = linear_part_in_hull<Rational, 3>(s42::segment, s42::first_only, s42::points, s42::second);
              return weight_vertices_are_admissible(s42::segment, s42::first_only) == Verdict::holds &&
                     found.verdict == Verdict::fails &&
                     separates<Rational, 3>(s42::along_the_points, found.point, images) == Verdict::holds;
            });
  t.example("with a weight vertex outside the bounds the hull has points that are no blends",
            {.form = "printed", .hypothesis = "the listed weight vertices are admissible"}, [] {
              const auto found = hull_in_linear_part<Rational, 3>(s42::segment, s42::too_far, s42::points, s42::only_the_first);
              return weight_vertices_are_complete(s42::segment, s42::too_far) == Verdict::holds &&
                     found.verdict == Verdict::fails &&
                     separates<Rational, 3>(-s42::along_the_points, found.point, s42::points) == Verdict::holds &&
                     // Coefficients that make it of the points are not convex.
                     is_hull_point<Rational, 3>(s42::points, found.point, std::vector<Rational>{2, -1}) == Verdict::fails;
            });
}

PROPTEST(s42_linear_part_hull) {
  undecided_parts_are_not_lost(t);
  hypotheses_need_each_part(t);
  checks_need_each_part(t);
  blends_are_the_hull_of_the_images(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_s42_linear_part_hull
