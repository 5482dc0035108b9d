#include "lemmas/s42_linear_part_hull.hpp"

#include "proptests/counterexamples/s42_linear_part_hull.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weight_bounds.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using Weights = std::vector<Rational>;

// Weight bounds, their corners, and a point for each weight.
template <int D>
struct LinearPart {
  gen::BoundsWithCorners weights;
  std::vector<Vec<Rational, D>> points;

  explicit LinearPart(int most)
      : weights(*gen::any_bounds_of_vertices(most)),
        points(
            *rc::gen::container<std::vector<Vec<Rational, D>>>(weights.bounds.low.size(), gen::rational_vector<D>())) {
    bool coincident = false;
    for (std::size_t i = 1; i < points.size(); ++i) coincident = coincident || points[i] == points[0];
    RC_CLASSIFY(coincident || weights.corners.size() == 1, "degenerate");
  }
  auto in_hull(const Weights& w) const {
    return linear_part_in_hull<Rational, D>(weights.bounds, weights.corners, points, w);
  }
  auto from_hull(const Weights& u) const {
    return hull_in_linear_part<Rational, D>(weights.bounds, weights.corners, points, u);
  }
  Weights coefficients() const { return *gen::convex_weights(static_cast<int>(weights.corners.size())); }
};

PROPTEST(s42_linear_part_hull) {
  t.holds("the blend of the points with admissible weights is in the hull of the corner images",
          {.form = "printed", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.15}, [] {
            gen::for_some_dimension<3, 4>([](auto d) {
              const LinearPart<d()> part(4);
              const Weights w = *gen::admissible_weights(part.weights.bounds);
              RC_ASSERT((linear_part_hull_hypotheses<Rational, d()>(part.weights.bounds, part.weights.corners,
                                                                    part.points) == Verdict::holds));
              const auto found = part.in_hull(w);
              RC_ASSERT(found.verdict == Verdict::holds);
              const auto images = corner_images<Rational, d()>(part.weights.corners, part.points);
              RC_ASSERT((is_hull_point<Rational, d()>(images, found.point, found.coefficients) == Verdict::holds));
            });
          });

  t.holds("every point of the hull of the corner images is a blend of the points with admissible weights",
          {.form = "printed", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.15}, [] {
            gen::for_some_dimension<3, 4>([](auto d) {
              const LinearPart<d()> part(4);
              const auto found = part.from_hull(part.coefficients());
              RC_ASSERT(found.verdict == Verdict::holds);
              RC_ASSERT((is_admissible_blend<Rational, d()>(part.weights.bounds, part.points, found.point,
                                                            found.coefficients) == Verdict::holds));
            });
          });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const LinearPart<3> part(3);
    const Weights w = *gen::admissible_weights(part.weights.bounds);
    decide_by_all([]<class S>(const WeightBounds<S>& l, const Corners<S>& c, const std::vector<Vec<S, 3>>& p,
                              const std::vector<S>& x) { return linear_part_in_hull<S, 3>(l, c, p, x).verdict; },
                  part.weights.bounds, part.weights.corners, part.points, w);
    decide_by_all([]<class S>(const WeightBounds<S>& l, const Corners<S>& c, const std::vector<Vec<S, 3>>& p,
                              const std::vector<S>& u) { return hull_in_linear_part<S, 3>(l, c, p, u).verdict; },
                  part.weights.bounds, part.weights.corners, part.points, part.coefficients());
  });

  t.holds("a mutated witness of either inclusion is rejected", {.number_type = "rational", .cases = 300}, [] {
    const LinearPart<3> part(4);
    const auto& [bounds, corners] = part.weights;
    const auto images = corner_images<Rational, 3>(corners, part.points);
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

  const Options completeness{.form = "printed", .hypothesis = "the list has every corner"};
  t.example("without one of the corners a blend is outside the hull", completeness, [] {
    const auto images = corner_images<Rational, 3>(s42::first_only, s42::points);
    const auto found = linear_part_in_hull<Rational, 3>(s42::segment, s42::first_only, s42::points, s42::second);
    return corners_are_admissible(s42::segment, s42::first_only) == Verdict::holds && found.verdict == Verdict::fails &&
           separates<Rational, 3>(s42::along_the_points, found.point, images) == Verdict::holds;
  });
  const Options admissible{.form = "printed", .hypothesis = "the listed corners are admissible"};
  t.example("with a corner outside the bounds the hull has points that are no blends", admissible, [] {
    const auto found = hull_in_linear_part<Rational, 3>(s42::segment, s42::too_far, s42::points, s42::only_the_first);
    return corners_are_complete(s42::segment, s42::too_far) == Verdict::holds && found.verdict == Verdict::fails &&
           separates<Rational, 3>(-s42::along_the_points, found.point, s42::points) == Verdict::holds &&
           // Coefficients that make it of the points are not convex.
           is_hull_point<Rational, 3>(s42::points, found.point, std::vector<Rational>{2, -1}) == Verdict::fails;
  });
}

}  // namespace
}  // namespace proptests
