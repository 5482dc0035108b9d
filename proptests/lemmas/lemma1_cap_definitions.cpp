#include "lemmas/lemma1_cap_definitions.hpp"

#include "proptests/counterexamples/lemma1_cap_definitions.hpp"
#include "proptests/gen/cap.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/surface.hpp"
#include "proptests/harness.hpp"
#include "proptests/oracles/nearest_on_surface.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests {
namespace {

using namespace refitlab;

// The plane touches the surface, passes through its center or through the point, or misses it on either side.
template <int D>
bool is_degenerate(const gen::SurfaceInHalfSpace<D>& c) {
  const Rational e = offset_from_center(c.surface, c.half_space);
  return c.surface.squared_radius == Rational(0) || e == Rational(0) ||
         dot(c.point, c.half_space.normal) == c.half_space.offset ||
         sq(e) >= c.surface.squared_radius * squared_norm(c.half_space.normal);
}

template <int D>
bool is_degenerate(const Cap<Rational, D>& cap) {
  return sq(cap.cos_angle) == Rational(1) || cap.cos_angle == Rational(0);
}

const auto meets_surface = [](const auto& surface, const auto& h) { return meets(surface, h); };
const auto agree_on = [](const auto& surface, const auto& h, const auto& scale, const auto& x) {
  return definitions_agree(h, cap_of_half_space(surface, h, scale).cap, x);
};

PROPTEST(lemma1_cap_definitions) {
  using namespace lemma1;
  t.example("a half-space that holds the whole surface, a negative scalar, and d = 0 refute the printed statement",
            {.form = "printed"}, [] {
              return half_space_is_cap_printed(unit_circle, holds_all, Q(1), right) == Verdict::fails &&
                     half_space_is_cap_printed(unit_circle, right_half, Q(-1), right) == Verdict::fails &&
                     half_space_is_cap_printed(unit_circle, whole_plane, Q(1), right) == Verdict::fails &&
                     half_space_is_cap_repaired(unit_circle, holds_all, Q(1), right) == Verdict::holds &&
                     cap_of_half_space(unit_circle, holds_all, Q(1)).cap.cos_angle == Q(-1);
            });

  t.refuted("every half-space that meets the surface cuts out the cap of an apex and an angle, by any non-zero scalar",
            {.form = "printed", .number_type = "rational"}, [] {
              gen::for_some_dimension<1, 4>([](auto d) {
                const auto c = *gen::surface_in_half_space<d>().as("case");
                const bool negative = *rc::gen::arbitrary<bool>().as("negative scalar");
                const Rational scalar = negative ? Rational(-c.scale) : c.scale;
                RC_ASSERT(half_space_is_cap_printed(c.surface, c.half_space, scalar, c.point) == Verdict::holds);
              });
            });

  t.holds("a half-space with d != 0 that meets the surface cuts out the cap of an apex and an angle",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.25}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto c = *gen::surface_in_half_space<d>().as("case");
              RC_PRE(cuts_cap(c.surface, c.half_space) == Verdict::holds);
              RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
              RC_ASSERT(is_cap_scale(c.surface, c.half_space, c.scale) == Verdict::holds);
              const auto made = cap_of_half_space(c.surface, c.half_space, c.scale);
              RC_ASSERT(made.verdict == Verdict::holds);
              RC_ASSERT(is_cap_of_half_space(c.surface, c.half_space, made) == Verdict::holds);
              RC_ASSERT(half_space_is_cap_repaired(c.surface, c.half_space, c.scale, c.point) == Verdict::holds);
              RC_ASSERT((contains(c.half_space, c.point) == contains(made.cap, c.point)));
              RC_ASSERT(contains(c.half_space, made.cap.apex) == Verdict::holds);
            });
          });
  t.holds("a cap with r > 0 is what its half-space cuts out of the surface",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.25}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto c = *gen::cap_point<d>().as("case");
              RC_PRE(c.cap.apex != c.cap.center);
              RC_CLASSIFY(is_degenerate<d>(c.cap), "degenerate");
              const auto made = half_space_of_cap(c.cap);
              RC_ASSERT(made.verdict == Verdict::holds);
              RC_ASSERT(is_half_space_of_cap(c.cap, made) == Verdict::holds);
              const gen::RationalVec<d> opposite = c.cap.center * Rational(2) - c.point;
              for (const auto& x : {c.point, opposite}) {
                RC_ASSERT(cap_is_half_space_repaired(c.cap, x) == Verdict::holds);
                RC_ASSERT((contains(c.cap, x) == contains(made.half_space, x)));
              }
              // And back: the same cap.
              const SquaredBall<Rational, d> surface{c.cap.center, squared_radius(c.cap)};
              const auto back = cap_of_half_space(surface, made.half_space, Rational(1));
              RC_ASSERT(back.cap.apex == c.cap.apex);
              RC_ASSERT(back.cap.cos_angle == c.cap.cos_angle);
            });
          });
  t.holds("the same for normals of any length, with a root",
          {.form = "repaired", .number_type = "exact root", .cases = 150}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              const auto surface = lift<ExactRoot>(SquaredBall<Rational, d>{
                  *gen::rational_vector<d>().as("center"), *gen::positive_rational().as("squared radius")});
              const auto h = lift<ExactRoot>(
                  HalfSpace<Rational, d>{*gen::nonzero_vector<d>().as("normal"), *gen::rational().as("offset")});
              // The surface meets the half-space if its foremost point is in it.
              const auto apex = point_towards<d>(surface, h.normal);
              RC_ASSERT((meets(surface, h) == contains(h, apex)));
              if (meets(surface, h) != Verdict::holds) return;
              RC_ASSERT(is_cap_of_half_space(surface, h, cap_of_half_space_by_root(surface, h)) == Verdict::holds);
            });
          });

  t.holds("intervals never contradict the exact verdict on half-spaces and points",
          {.number_type = "interval", .cases = 2000, .degenerate_at_least = 0.25}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::surface_in_half_space<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
              c.half_space.offset += *gen::nudge().as("nudge of the offset");
              decide_by_all(meets_surface, c.surface, c.half_space);
              if (cuts_cap(c.surface, c.half_space) == Verdict::holds)
                RC_ASSERT(decide_by_all(agree_on, c.surface, c.half_space, c.scale, c.point) == Verdict::holds);
            });
          });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.25}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto c = *gen::surface_in_half_space<d>().as("case");
      RC_PRE(cuts_cap(c.surface, c.half_space) == Verdict::holds);
      RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
      const Rational amount = *gen::positive_rational().as("amount");
      const auto shift = *gen::nonzero_vector<d>().as("shift");
      auto bad = cap_of_half_space(c.surface, c.half_space, c.scale);
      auto other = half_space_of_cap(bad.cap);
      switch (*rc::gen::inRange(0, 6).as("mutation")) {
        case 0: bad.cap.center += shift; break;
        case 1: bad.cap.apex += shift; break;
        case 2: bad.cap.apex = bad.cap.center * Rational(2) - bad.cap.apex; break;
        case 3: bad.cap.cos_angle += amount; break;
        case 4: bad.cap.cos_angle -= amount; break;
        default: bad.scale += amount;
      }
      RC_ASSERT(is_cap_of_half_space(c.surface, c.half_space, bad) == Verdict::fails);
      const auto cap = cap_of_half_space(c.surface, c.half_space, c.scale).cap;
      switch (*rc::gen::inRange(0, 3).as("mutation of the half-space")) {
        case 0: other.half_space.normal += shift; break;
        case 1: other.half_space.offset += amount; break;
        default: other.half_space.offset -= amount;
      }
      RC_ASSERT(is_half_space_of_cap(cap, other) == Verdict::fails);
    });
  });

  t.example("d = 0 has no apex", {.form = "repaired", .hypothesis = "d != 0"}, [] {
    return is_half_space(whole_plane) == Verdict::fails &&
           is_cap_of_half_space(unit_circle, whole_plane, cap_of_half_space(unit_circle, whole_plane, Q(1))) ==
               Verdict::fails;
  });
  t.example("a cap with r = 0 has no half-space", {.form = "repaired", .hypothesis = "r > 0"}, [] {
    return is_proper_cap(no_radius) == Verdict::fails && half_space_of_cap(no_radius).verdict == Verdict::fails &&
           is_cap_scale(single_point, right_half, Q(1)) == Verdict::fails;
  });
  t.example("a half-space that misses the surface has no angle", {.form = "repaired", .hypothesis = "they meet"}, [] {
    return cuts_cap(unit_circle, misses) == Verdict::fails &&
           cap_of_half_space(unit_circle, misses, Q(1)).verdict == Verdict::fails;
  });
  t.example("a negative scale turns the half-space round", {.form = "repaired", .hypothesis = "s > 0"}, [] {
    const auto made = cap_of_half_space(unit_circle, right_half, Q(-1));
    return is_cap_scale(unit_circle, right_half, Q(-1)) == Verdict::fails &&
           definitions_agree(right_half, made.cap, right) == Verdict::fails;
  });
  t.example("another scale puts the apex off the surface",
            {.form = "repaired", .hypothesis = "s d is as long as the radius"}, [] {
              const auto made = cap_of_half_space(unit_circle, beyond_a_half, Q(2));
              return is_cap_scale(unit_circle, beyond_a_half, Q(2)) == Verdict::fails &&
                     definitions_agree(beyond_a_half, made.cap, up_right) == Verdict::fails;
            });
  t.example("a cosine above 1 makes a half-space that misses the surface",
            {.form = "repaired", .hypothesis = "cos(alpha) <= 1"}, [] {
              return is_proper_cap(no_angle) == Verdict::fails && half_space_of_cap(no_angle).verdict == Verdict::fails;
            });
  t.example("off the surface the half-space holds points that the cap does not",
            {.form = "repaired", .hypothesis = "the point is on the surface"}, [] {
              const auto made = half_space_of_cap(Arc{Point(0, 0), Point(1, 0), Q(0)});
              const Point off(2, 0);
              return contains(made.half_space, off) == Verdict::holds &&
                     contains(Arc{Point(0, 0), Point(1, 0), Q(0)}, off) == Verdict::fails;
            });
}

}  // namespace
}  // namespace proptests
