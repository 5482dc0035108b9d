#include "lemmas/s43_distance_range.hpp"

#include "proptests/counterexamples/s43_distance_range.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/sphere_point.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;

// A center at a rational distance from 0, and a radius of which a third touch the unit sphere from inside or outside.
template <int D>
struct BallAndSphere {
  Rational length = *gen::positive_rational();
  Vec<Rational, D> center = *gen::sphere_point<D>() * length;
  Rational radius =
      *rc::gen::oneOf(rc::gen::just(Rational(abs(length - 1))), gen::unit_interval_rational(),
                      rc::gen::map(gen::unit_interval_rational(),
                                   [at = abs(length - 1)](const Rational& x) { return Rational(at + x); }));

  bool touches() const { return radius == abs(length - 1); }
};

PROPTEST(s43_distance_range) {
  t.refuted("r < 1 and ||c|| + r >= 1 give a distance in [0, 1]", {.form = "printed", .number_type = "rational"}, [] {
    const BallAndSphere<2> b;
    RC_ASSERT(distance_range_printed(b.center, b.radius) == Verdict::holds);
  });
  t.example("a ball outside the unit circle refutes the printed range", {.form = "printed"}, [] {
    const auto& [center, radius, distance] = s43_range::outside;
    return distance_range_hypotheses_printed(center, radius) == Verdict::holds &&
           distance_range_printed(center, radius) == Verdict::fails &&
           distance_range_repaired(center, radius) == Verdict::holds &&
           scaled_distance(center, sq(radius)) / 6 == distance;
  });
  t.holds("| ||c|| - 1 | <= r and r^2 <= 1 + ||c||^2 give a distance in [0, 1]",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const BallAndSphere<d()> b;
              RC_PRE(distance_range_hypotheses_repaired(b.center, b.radius) == Verdict::holds);
              RC_CLASSIFY(b.touches() || b.radius == 0 || b.length == 1, "degenerate");
              const auto range = distance_range(b.center, b.radius);
              RC_ASSERT(range.verdict == Verdict::holds);
              RC_ASSERT(is_distance_range(b.center, b.radius, range) == Verdict::holds);
              // The norm is known here, so that the distance itself is.
              const Rational distance = scaled_distance(b.center, sq(b.radius)) / (2 * b.length);
              RC_ASSERT(Rational(0) <= distance && distance <= Rational(1));
            });
          });
  t.holds("a distance in [0, 1] needs both conditions",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            const BallAndSphere<3> b;
            RC_CLASSIFY(b.touches() || b.radius == 0 || b.length == 1, "degenerate");
            RC_ASSERT(distance_is_in_range(b.center, sq(b.radius)) ==
                      distance_range_hypotheses_repaired(b.center, b.radius));
          });
  t.holds("a ball that holds a unit vector and at most half of the sphere has a distance in [0, 1]",
          {.form = "repaired", .number_type = "rational", .degenerate_at_least = 0.2}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const Vec<Rational, d()> center = *gen::nonzero_vector<d()>(), x = *gen::sphere_point<d()>();
              const Rational more = *rc::gen::oneOf(rc::gen::just(Rational(0)), gen::unit_interval_rational());
              const Rational squared_radius = squared_distance(x, center) + more;
              RC_PRE(distance_range_hypotheses_by_point(center, squared_radius, x) == Verdict::holds);
              RC_CLASSIFY(more == 0 || center == x, "degenerate");
              RC_ASSERT(distance_range_by_point(center, squared_radius, x) == Verdict::holds);
            });
          });

  t.holds("the conditions on the norm, decided without it, are right where it is known", {.number_type = "rational"},
          [] {
            const BallAndSphere<3> b;
            const Rational radius = *rc::gen::oneOf(rc::gen::just(b.radius), gen::positive_rational());
            RC_ASSERT(reaches_surface_from_inside(b.center, radius) == verdict_of(b.length + radius >= 1));
            RC_ASSERT(reaches_surface_from_outside(b.center, radius) == verdict_of(b.length - radius <= 1));
          });

  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 500}, [] {
    const BallAndSphere<4> b;
    decide_by_all([]<class S>(const Vec<S, 4>& c, const S& r) { return distance_range_repaired<S, 4>(c, r); }, b.center,
                  b.radius);
    decide_by_all([]<class S>(const Vec<S, 4>& c, const S& r) { return distance_range_printed<S, 4>(c, r); }, b.center,
                  b.radius);
    // The range check that arccos relies on.
    decide_by_all([]<class S>(const Vec<S, 4>& c, const S& r) { return distance_is_in_range<S, 4>(c, sq(r)); },
                  b.center, b.radius);
  });

  t.holds("a mutated factor of Heron's formula is rejected", {.number_type = "rational", .cases = 500}, [] {
    const BallAndSphere<3> b;
    RC_PRE(distance_range_hypotheses_repaired(b.center, b.radius) == Verdict::holds);
    const auto good = distance_range(b.center, b.radius);
    auto from_inside = good, from_outside = good, both = good;
    from_inside.from_inside += *gen::positive_rational();
    from_outside.from_outside += *gen::positive_rational();
    both.from_inside = -both.from_inside;
    both.from_outside = -both.from_outside;
    if (good.from_outside != 0) RC_ASSERT(is_distance_range(b.center, b.radius, from_inside) == Verdict::fails);
    if (good.from_inside != 0) RC_ASSERT(is_distance_range(b.center, b.radius, from_outside) == Verdict::fails);
    if (good.from_outside != 0 || good.from_inside != 0)
      RC_ASSERT(is_distance_range(b.center, b.radius, both) == Verdict::fails);
  });

  const auto fails_without = [&t](const std::string& hypothesis, const std::string& sentence,
                                  const s43_range::Case& c) {
    t.example(sentence, {.form = "repaired", .hypothesis = hypothesis}, [&] {
      return distance_range_hypotheses_repaired(c.center, c.radius) == Verdict::fails &&
             distance_range(c.center, c.radius).verdict == Verdict::fails &&
             is_distance_range(c.center, c.radius, distance_range(c.center, c.radius)) == Verdict::fails &&
             scaled_distance(c.center, sq(c.radius)) == 2 * c.distance * c.center[0];
    });
  };
  fails_without("||c|| - r <= 1", "a ball outside the sphere has a distance above 1", s43_range::outside);
  fails_without("||c|| + r >= 1", "a ball strictly inside the sphere has a distance above 1", s43_range::inside);
  fails_without("r^2 <= 1 + ||c||^2", "a ball that holds more than half of the sphere has a negative distance",
                s43_range::past_half);
  fails_without("c is not 0", "a ball about 0 has no distance", s43_range::about_zero);
  const Options unit{.form = "repaired", .hypothesis = "the point is a unit vector"};
  t.example("a ball of exactly half of the sphere meets every hypothesis, and its distance is 0", {.form = "repaired"}, [] {
    const Vec<Rational, 2> center{Rational(3, 4), Rational(0)}, x{Rational(0), Rational(1)};
    const Rational radius(5, 4);  // r^2 = 1 + ||c||^2
    return distance_range_hypotheses_repaired(center, radius) == Verdict::holds &&
           distance_range_hypotheses_by_point(center, sq(radius), x) == Verdict::holds &&
           distance_range(center, radius).verdict == Verdict::holds && scaled_distance(center, sq(radius)) == 0;
  });
  t.example("a ball that holds a vector which is no unit vector may miss the sphere", unit, [] {
    const auto& x = s43_range::not_unit;
    return less_equal(squared_distance(x, x), Rational(0)) == Verdict::holds &&
           distance_range_hypotheses_by_point(x, Rational(0), x) == Verdict::fails &&
           distance_range_by_point(x, Rational(0), x) == Verdict::fails;
  });
}

}  // namespace
}  // namespace proptests
