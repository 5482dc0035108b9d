// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/lemma1_cap_definitions.hpp"

#include "proptests/counterexamples/lemma1_cap_definitions.hpp"
#include "proptests/gen/cap.hpp"
#include "proptests/gen/dimension.hpp"
#include "proptests/gen/surface.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/nearest_on_surface.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_lemma1_cap_definitions {
namespace {

using namespace refitlab;

// Says whether the plane touches the surface, passes through its center or through the point, or misses it on either side.
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

// Draws a surface that a half-space cuts a cap out of, with r > 0, d != 0 and a rational r ||d||.
template <int D>
gen::SurfaceInHalfSpace<D> cut_surface() {
  const auto c = *gen::surface_in_half_space<D>().as("case");
  RC_PRE(c.surface.squared_radius > Rational(0) && squared_norm(c.half_space.normal) > Rational(0));
  return c;
}

// Returns r ||d||, which is what D - (c, d) may be at most.
template <int D>
Rational farthest_offset(const gen::SurfaceInHalfSpace<D>& c) {
  return c.scale * squared_norm(c.half_space.normal);
}

// Returns the same surface with a half-space at a given D - (c, d).
template <int D>
gen::SurfaceInHalfSpace<D> at_offset(gen::SurfaceInHalfSpace<D> c, const Rational& from_center) {
  c.half_space.offset = from_center + dot(c.surface.center, c.half_space.normal);
  return c;
}

void half_space_hypotheses_need_each_part(Suite& t) {
  t.holds("the surface meets a half-space up to the offset c + r ||d|| and no further", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto c = cut_surface<d>();
      const Rational most = farthest_offset<d>(c), amount = *gen::positive_rational().as("amount");
      for (const Rational& e : {most, Rational(most - amount), Rational(-most), Rational(-most - amount), Rational(0)})
        RC_ASSERT(meets(c.surface, at_offset<d>(c, e).half_space) == verdict_of(e <= most) &&
                  cuts_cap(c.surface, at_offset<d>(c, e).half_space) == verdict_of(e <= most));
      const auto beyond = at_offset<d>(c, most + amount);
      RC_ASSERT(meets(beyond.surface, beyond.half_space) == Verdict::fails);
      // At the rim the cosine is at its ends, 1 and -1.
      RC_ASSERT(cap_of_half_space(c.surface, at_offset<d>(c, most).half_space, c.scale).cap.cos_angle == Rational(1));
      RC_ASSERT(cap_of_half_space(c.surface, at_offset<d>(c, -most).half_space, c.scale).cap.cos_angle == Rational(-1));
    });
  });
  needs_part_in<1, 4>(t, "they meet", [](auto d) {
    auto c = cut_surface<d>();
    c = at_offset<d>(c, farthest_offset<d>(c) + *gen::positive_rational().as("amount"));
    RC_ASSERT(half_space_is_cap_repaired(c.surface, c.half_space, c.scale, c.point) == Verdict::holds);
    return Weakening{cuts_cap(c.surface, c.half_space), cap_of_half_space(c.surface, c.half_space, c.scale).verdict};
  });
  needs_part_in<1, 4>(t, "d != 0", [](auto d) {
    auto c = cut_surface<d>();
    c.half_space.normal = gen::RationalVec<d>::Zero();
    c.half_space.offset = -abs(*gen::rational().as("offset"));
    RC_ASSERT(meets(c.surface, c.half_space) == Verdict::holds);
    RC_ASSERT(is_half_space(c.half_space) == Verdict::fails);
    return Weakening{cuts_cap(c.surface, c.half_space),
                     is_cap_of_half_space(c.surface, c.half_space, cap_of_half_space(c.surface, c.half_space, c.scale))};
  });
  needs_part_in<1, 4>(t, "r > 0, with r^2 = 0 or less", [](auto d) {
    auto c = cut_surface<d>();
    const bool negative = *rc::gen::arbitrary<bool>().as("negative");
    c.surface.squared_radius = negative ? Rational(-*gen::positive_rational()) : Rational(0);
    c = at_offset<d>(c, -abs(*gen::rational().as("offset")));
    RC_ASSERT(meets(c.surface, c.half_space) == verdict_of(!negative));
    RC_ASSERT(half_space_is_cap_repaired(c.surface, c.half_space, c.scale, c.surface.center) == Verdict::holds);
    // There is no cap to compute; that of its center is none either.
    const Cap<Rational, d> center{c.surface.center, c.surface.center + c.half_space.normal * c.scale, Rational(-1)};
    return Weakening{cuts_cap(c.surface, c.half_space),
                     is_cap_of_half_space(c.surface, c.half_space, {Verdict::holds, center, c.scale})};
  });
  needs_part_in<1, 4>(t, "s > 0", [](auto d) {
    const auto c = cut_surface<d>();
    RC_PRE(cuts_cap(c.surface, c.half_space) == Verdict::holds);
    const auto turned = cap_of_half_space(c.surface, c.half_space, Rational(-c.scale));
    RC_ASSERT(half_space_is_cap_repaired(c.surface, c.half_space, Rational(-c.scale), c.point) == Verdict::holds);
    RC_ASSERT(is_cap_of_half_space(c.surface, c.half_space, turned) == Verdict::fails);
    return Weakening{is_cap_scale(c.surface, c.half_space, Rational(-c.scale)),
                     definitions_agree(c.half_space, turned.cap, c.point)};
  });
  needs_part_in<1, 4>(t, "||s d|| = r, with s too large or too small", [](auto d) {
    const auto c = cut_surface<d>();
    RC_PRE(cuts_cap(c.surface, c.half_space) == Verdict::holds);
    const Rational factor = Rational(1) + *gen::positive_rational().as("factor");
    const Rational scale = *rc::gen::arbitrary<bool>().as("larger") ? Rational(c.scale * factor) : Rational(c.scale / factor);
    RC_ASSERT(half_space_is_cap_repaired(c.surface, c.half_space, scale, c.point) == Verdict::holds);
    const auto made = cap_of_half_space(c.surface, c.half_space, scale);
    RC_ASSERT(is_cap_of_half_space(c.surface, c.half_space, made) == Verdict::fails);
    return Weakening{is_cap_scale(c.surface, c.half_space, scale),
                     made.verdict & definitions_agree(c.half_space, made.cap, c.point)};
  });
  needs_part_in<1, 4>(t, "the point is on the surface", [](auto d) {
    auto c = cut_surface<d>();
    gen::RationalVec<d> x = c.point + *gen::nonzero_vector<d>().as("shift");
    if (*rc::gen::arbitrary<bool>().as("behind a surface that is all in the half-space")) {
      c = at_offset<d>(c, -farthest_offset<d>(c) * (Rational(1) + *gen::positive_rational().as("room")));
      x = c.surface.center - c.half_space.normal * (c.scale * (Rational(1) + *gen::positive_rational().as("distance")));
    }
    RC_PRE(cuts_cap(c.surface, c.half_space) == Verdict::holds);
    RC_PRE(on_surface(c.surface, x) == Verdict::fails);
    const auto cap = cap_of_half_space(c.surface, c.half_space, c.scale).cap;
    RC_ASSERT(half_space_is_cap_repaired(c.surface, c.half_space, c.scale, x) == Verdict::holds);
    RC_ASSERT(half_space_is_cap_printed(c.surface, c.half_space, c.scale, x) == Verdict::holds);
    RC_ASSERT(cap_is_half_space_repaired(cap, x) == Verdict::holds);
    return Weakening{on_surface(c.surface, x), definitions_agree(c.half_space, cap, x)};
  });
}

void cap_hypotheses_need_each_part(Suite& t) {
  needs_part_in<1, 4>(t, "of a cap, r > 0", [](auto d) {
    const auto center = *gen::rational_vector<d>().as("center");
    const Cap<Rational, d> cap{center, center, Rational(1) - abs(*gen::rational().as("1 - cosine"))};
    const auto made = half_space_of_cap(cap);
    RC_ASSERT(is_half_space_of_cap(cap, made) == Verdict::fails);
    RC_ASSERT(cap_is_half_space_repaired(cap, center) == Verdict::holds);
    return Weakening{is_proper_cap(cap), made.verdict};
  });
  needs_part_in<1, 4>(t, "of a cap, cos(alpha) <= 1", [](auto d) {
    auto c = *gen::cap_point<d>().as("case");
    RC_PRE(c.cap.apex != c.cap.center);
    c.cap.cos_angle = 1;
    RC_ASSERT(is_proper_cap(c.cap) == Verdict::holds && half_space_of_cap(c.cap).verdict == Verdict::holds);
    c.cap.cos_angle += *gen::positive_rational().as("amount");
    const auto made = half_space_of_cap(c.cap);
    RC_ASSERT(is_half_space_of_cap(c.cap, made) == Verdict::fails);
    RC_ASSERT(cap_is_half_space_repaired(c.cap, c.point) == Verdict::holds);
    return Weakening{is_proper_cap(c.cap), made.verdict};
  });
}

// Compares each statement with the booleans of its words, on half-spaces, caps and points that need not belong together.
void statements_say_their_words(Suite& t) {
  t.holds("the definitions agree on a point if both of their inequalities hold, or none", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto c = cut_surface<d>();
      const auto cap = (*gen::cap_point<d>().as("cap")).cap;
      const gen::RationalVec<d> to_x = c.point - cap.center, axis = cap.apex - cap.center;
      if (*rc::gen::arbitrary<bool>().as("on the plane")) c.half_space.offset = dot(c.point, c.half_space.normal);
      const bool first = dot(c.point, c.half_space.normal) >= c.half_space.offset;
      auto touching = cap;
      if (axis != gen::RationalVec<d>::Zero()) touching.cos_angle = dot(to_x, axis) / squared_norm(axis);
      RC_ASSERT(within_angle(touching, c.point) == Verdict::holds);
      RC_ASSERT(definitions_agree(c.half_space, touching, c.point) == verdict_of(first));
      const bool second = dot(to_x, axis) >= squared_norm(axis) * cap.cos_angle;
      RC_CLASSIFY(first && !second, "only in the half-space");
      RC_CLASSIFY(second && !first, "only in the cap");
      RC_ASSERT(definitions_agree(c.half_space, cap, c.point) == verdict_of(first == second));
    });
  });
  t.holds("the printed statement holds exactly where its words do", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto c = *gen::surface_in_half_space<d>().as("case");
      const Rational n2 = squared_norm(c.half_space.normal), r2 = c.surface.squared_radius;
      const bool has_length = r2 != Rational(0) && n2 != Rational(0);
      const Rational most = has_length ? Rational(c.scale * n2) : Rational(0);
      const int edge = *rc::gen::inRange(0, 5).as("edge");
      if (edge < 2) c = at_offset<d>(c, edge == 0 ? most : Rational(-most));
      const Rational factor = *rc::gen::element(Rational(1), Rational(-1), Rational(0), Rational(2), Rational(1, 2)).as("factor");
      const Rational scalar = c.scale * factor, e = offset_from_center(c.surface, c.half_space);
      auto x = c.point;
      if (*rc::gen::inRange(0, 4).as("off the surface") == 0) x += *gen::rational_vector<d>().as("shift");
      const bool hypotheses = e <= most && squared_distance(x, c.surface.center) == r2;
      const bool stretches = scalar != Rational(0) && scalar * scalar * n2 == r2;
      const bool has_angle = abs(scalar * e) <= r2;
      const bool in_half_space = dot(x, c.half_space.normal) >= c.half_space.offset;
      const bool in_cap = dot(gen::RationalVec<d>(x - c.surface.center), c.half_space.normal) * scalar >= scalar * e;
      RC_CLASSIFY(hypotheses && !stretches, "no such scalar");
      RC_CLASSIFY(hypotheses && stretches && !has_angle, "no angle");
      RC_CLASSIFY(hypotheses && stretches && has_angle && in_half_space != in_cap, "turned round");
      RC_ASSERT(half_space_is_cap_printed(c.surface, c.half_space, scalar, x) ==
                verdict_of(!hypotheses || (stretches && has_angle && in_half_space == in_cap)));
    });
  });
}

// Checks statements with intervals that cannot decide one part alone. In exact numbers a true statement could lose that part
// unseen.
void undecided_parts_are_not_lost(Suite& t) {
  t.example("what an interval cannot decide of one part of a conclusion, it cannot decide of the statement", {}, [] {
    using Point = Vec<Interval, 2>;
    const Interval zero(0), one(1), about_zero(-1e-3, 1e-3), about_one(1 - 1e-3, 1 + 1e-3);
    const Point origin(zero, zero), right(one, zero), left(-one, zero), up(zero, one), far_up(zero, Interval(2));
    const SquaredBall<Interval, 2> circle{origin, one};
    const auto of_half_space = [&](const Interval& offset, const Point& x) {
      return half_space_is_cap_repaired<Interval, 2>(circle, {right, offset}, one, x);
    };
    const auto of_cap = [&](const Interval& cosine, const Point& x) {
      return cap_is_half_space_repaired<Interval, 2>({origin, right, cosine}, x);
    };
    return Checked(of_half_space(about_one, left) == Verdict::undecided &&     // This asks whether there is an angle.
                       of_half_space(about_zero, up) == Verdict::undecided &&  // This asks whether the point is in both.
                       of_half_space(about_zero, left) == Verdict::holds && of_cap(about_one, left) == Verdict::undecided &&
                       of_cap(about_zero, up) == Verdict::undecided && of_cap(about_zero, far_up) == Verdict::holds &&
                       of_cap(about_zero, left) == Verdict::holds,
                   7);
  });
}

// Checks wrong witnesses, each of them wrong in one part and right in all others.
void checks_need_each_part(Suite& t) {
  t.holds("a cap that is wrong in one part is rejected", {.number_type = "rational", .cases = 2000}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      using Vector = gen::RationalVec<d>;
      auto c = cut_surface<d>();
      const Rational most = farthest_offset<d>(c), amount = *gen::positive_rational().as("amount");
      const int i = *rc::gen::inRange(0, int(d)).as("coordinate");
      const auto made_at = [&](const Rational& e, const Rational& scale) {
        c = at_offset<d>(c, e);
        auto witness = cap_of_half_space(c.surface, c.half_space, scale);
        witness.cap.cos_angle = scale * e / c.surface.squared_radius;  // It is not raised to -1.
        return witness;
      };
      const auto verdict = [&](const CapOfHalfSpace<Rational, d>& w) { return is_cap_of_half_space(c.surface, c.half_space, w); };
      const Rational inside = most * (Rational(2) * *gen::unit_interval_rational().as("share") - Rational(1));
      const int part = *rc::gen::inRange(0, 8).as("part");
      auto w = made_at(part == 2 ? Rational(most + amount) : part == 3 ? Rational(-most - amount) : inside, c.scale);
      if (part != 2 && part != 3) RC_ASSERT(verdict(w) == Verdict::holds);
      RC_TAG(part);
      if (part == 0) w = made_at(inside, -c.scale);                          // The sign of the scale is wrong.
      if (part == 1) w = made_at(inside, c.scale / (Rational(1) + amount));  // The radius is wrong.
      if (part == 4) {                                                       // The center is wrong.
        Vector shift = Vector::Zero();
        shift[i] = amount;
        w.cap.center += shift, w.cap.apex += shift;
      }
      if (part == 5) {  // The apex is wrong.
        RC_PRE(w.cap.apex[i] != w.cap.center[i]);
        w.cap.apex[i] = Rational(2) * w.cap.center[i] - w.cap.apex[i];
      }
      // The cosine is that of a narrower cap.
      if (part == 6) {
        RC_PRE(w.cap.cos_angle < Rational(1));
        w.cap.cos_angle += (Rational(1) - w.cap.cos_angle) / (Rational(1) + amount);
      }
      // The cosine is that of a wider cap, up to the whole surface.
      if (part == 7) {
        RC_PRE(w.cap.cos_angle > Rational(-1));
        w.cap.cos_angle -= (Rational(1) + w.cap.cos_angle) / (amount > Rational(1) ? amount : Rational(1));
      }
      RC_ASSERT(verdict(w) == Verdict::fails);
    });
  });
  t.holds("a cap of exactly the whole surface, and of its apex alone, is accepted; one of no radius is not",
          {.number_type = "rational"}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = cut_surface<d>();
              const Rational most = farthest_offset<d>(c), more = abs(*gen::rational().as("more"));
              for (const Rational& e : {most, Rational(-most), Rational(-most - more)}) {
                const auto there = at_offset<d>(c, e);
                RC_ASSERT(is_cap_of_half_space(there.surface, there.half_space,
                                               cap_of_half_space(there.surface, there.half_space, c.scale)) == Verdict::holds);
              }
              c.surface.squared_radius = 0;
              const Cap<Rational, d> point{c.surface.center, c.surface.center, Rational(1)};
              RC_ASSERT(is_cap_of_half_space(c.surface, c.half_space, {Verdict::holds, point, Rational(0)}) == Verdict::fails);
              RC_ASSERT(is_cap_scale(c.surface, c.half_space, Rational(0)) == Verdict::fails);
            });
          });
  t.holds("a half-space with one wrong coordinate is rejected", {.number_type = "rational"}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      auto cap = (*gen::cap_point<d>().as("case")).cap;
      cap.cos_angle = -1 - abs(*gen::rational().as("more"));  // a half-space of all of the surface, which holds the apex
      const int i = *rc::gen::inRange(0, int(d)).as("coordinate");
      RC_PRE(cap.apex[i] != cap.center[i]);
      auto made = half_space_of_cap(cap);
      RC_ASSERT(is_half_space_of_cap(cap, made) == Verdict::holds);
      auto& h = made.half_space;
      h.normal[i] = -h.normal[i];
      h.offset = squared_radius(cap) * cap.cos_angle + dot(cap.center, h.normal);
      RC_ASSERT(contains(h, cap.apex) == Verdict::holds);
      RC_ASSERT(is_half_space_of_cap(cap, made) == Verdict::fails);
    });
  });
}

void printed_statements_are_refuted(Suite& t) {
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
            {.form = "implied", .number_type = "rational"}, [] {
              gen::for_some_dimension<1, 4>([](auto d) {
                const auto c = *gen::surface_in_half_space<d>().as("case");
                const bool negative = *rc::gen::arbitrary<bool>().as("negative scalar");
                const Rational scalar = negative ? Rational(-c.scale) : c.scale;
                RC_ASSERT(half_space_is_cap_printed(c.surface, c.half_space, scalar, c.point) == Verdict::holds);
              });
            });
}

void repaired_statements_hold(Suite& t) {
  using namespace lemma1;
  t.holds("a half-space with d != 0 that meets the surface cuts out the cap of an apex and an angle",
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.25, .degenerate_at_most = 0.85},
          [] {
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
          {.form = "repaired", .number_type = "rational", .cases = 4000, .degenerate_at_least = 0.25, .degenerate_at_most = 0.85},
          [] {
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
              // The way back leads to the same cap.
              const SquaredBall<Rational, d> surface{c.cap.center, squared_radius(c.cap)};
              const auto back = cap_of_half_space(surface, made.half_space, Rational(1));
              RC_ASSERT(back.cap.apex == c.cap.apex);
              RC_ASSERT(back.cap.cos_angle == c.cap.cos_angle);
            });
          });
  t.holds("the same for normals of any length, with a root", {.form = "repaired", .number_type = "exact root", .cases = 150}, [] {
    gen::for_some_dimension<1, 4>([](auto d) {
      const auto surface = lift<ExactRoot>(
          SquaredBall<Rational, d>{*gen::rational_vector<d>().as("center"), *gen::positive_rational().as("squared radius")});
      const auto h =
          lift<ExactRoot>(HalfSpace<Rational, d>{*gen::nonzero_vector<d>().as("normal"), *gen::rational().as("offset")});
      // The surface meets the half-space if its foremost point is in it.
      const auto apex = point_towards<d>(surface, h.normal);
      RC_ASSERT((meets(surface, h) == contains(h, apex)));
      if (meets(surface, h) != Verdict::holds) return;
      RC_ASSERT(is_cap_of_half_space(surface, h, cap_of_half_space_by_root(surface, h)) == Verdict::holds);
    });
  });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("intervals never contradict the exact verdict on half-spaces and points",
          {.number_type = "interval", .cases = 2000, .degenerate_at_least = 0.25, .degenerate_at_most = 0.85}, [] {
            gen::for_some_dimension<1, 4>([](auto d) {
              auto c = *gen::surface_in_half_space<d>().as("case");
              RC_CLASSIFY(is_degenerate<d>(c), "degenerate");
              c.half_space.offset += *gen::nudge().as("nudge of the offset");
              decide_by_all(meets_surface, c.surface, c.half_space);
              if (cuts_cap(c.surface, c.half_space) == Verdict::holds)
                RC_ASSERT(decide_by_all(agree_on, c.surface, c.half_space, c.scale, c.point) == Verdict::holds);
            });
          });

  t.holds("a mutated witness is rejected", {.number_type = "rational", .degenerate_at_least = 0.25, .degenerate_at_most = 0.85},
          [] {
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
}

void pinned_cases(Suite& t) {
  using namespace lemma1;
  t.example("d = 0 has no apex", {.form = "repaired", .hypothesis = "d != 0"}, [] {
    return is_half_space(whole_plane) == Verdict::fails &&
           is_cap_of_half_space(unit_circle, whole_plane, cap_of_half_space(unit_circle, whole_plane, Q(1))) == Verdict::fails;
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
  t.example("another scale puts the apex off the surface", {.form = "repaired", .hypothesis = "s d is as long as the radius"},
            [] {
              const auto made = cap_of_half_space(unit_circle, beyond_a_half, Q(2));
              return is_cap_scale(unit_circle, beyond_a_half, Q(2)) == Verdict::fails &&
                     definitions_agree(beyond_a_half, made.cap, up_right) == Verdict::fails;
            });
  t.example("a cosine above 1 makes a half-space that misses the surface", {.form = "repaired", .hypothesis = "cos(alpha) <= 1"},
            [] { return is_proper_cap(no_angle) == Verdict::fails && half_space_of_cap(no_angle).verdict == Verdict::fails; });
  t.example("off the surface the half-space holds points that the cap does not",
            {.form = "repaired", .hypothesis = "the point is on the surface"}, [] {
              const auto made = half_space_of_cap(Arc{Point(0, 0), Point(1, 0), Q(0)});
              const Point off(2, 0);
              return contains(made.half_space, off) == Verdict::holds &&
                     contains(Arc{Point(0, 0), Point(1, 0), Q(0)}, off) == Verdict::fails;
            });
}

PROPTEST(lemma1_cap_definitions) {
  undecided_parts_are_not_lost(t);
  half_space_hypotheses_need_each_part(t);
  cap_hypotheses_need_each_part(t);
  statements_say_their_words(t);
  checks_need_each_part(t);
  printed_statements_are_refuted(t);
  repaired_statements_hold(t);
  verdicts_and_witnesses_are_checked(t);
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_lemma1_cap_definitions
